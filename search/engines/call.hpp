// A checked search expression: every name is a component, every option has a value of its type.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "search/engines/component.hpp"

namespace praxis {

struct Component;
struct Call;

/// The value of one option.
struct Argument {
    std::int64_t integer = 0;  ///< integer; boolean as 0 or 1; choice as index
    double real = 0;
    std::vector<Call> calls;  ///< evaluators, open lists and engines
};

/// A component with a value for each of its options.
struct Call {
    const Component* component = nullptr;
    std::vector<Argument> arguments;  ///< as `ComponentDescription::options`
    /// The call with all options written out: equal for calls that mean the same.
    std::string canonical;

    /// The value of an option that the component declares.
    const Argument& operator[](std::string_view option) const;
    std::int64_t integer(std::string_view option) const { return (*this)[option].integer; }
    bool flag(std::string_view option) const { return (*this)[option].integer != 0; }
};

/// Parses and checks an expression that names an engine. Throws std::invalid_argument with place and mend.
Call check_expression(std::string_view expression);

}  // namespace praxis
