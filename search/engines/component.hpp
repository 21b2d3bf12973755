// What the parts of a search expression are called, what they take and what is known about them.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace praxis {

enum class ComponentKind { evaluator, open_list, engine };

enum class OptionType {
    integer,     ///< or "infinity", where the maximum allows it
    real,        ///< or "infinity"
    boolean,     ///< "true" or "false"
    choice,      ///< one of `choices`
    evaluator,   ///< a call of an evaluator
    evaluators,  ///< a list of them
    open_list,
    open_lists,
    engine,
    engines,
};

inline constexpr std::int64_t kInfinity = std::numeric_limits<std::int64_t>::max();

/// One option of a component. Options may be given in this order without their names.
struct OptionDescription {
    std::string name;
    OptionType type = OptionType::integer;
    std::string default_value;  ///< as one would write it; empty: the option must be given
    std::string help;
    std::vector<std::string> choices = {};
    std::int64_t minimum = std::numeric_limits<std::int64_t>::min();
    std::int64_t maximum = kInfinity;
};

/// Enough to print a manual page from.
struct ComponentDescription {
    std::string name;
    ComponentKind kind = ComponentKind::evaluator;
    std::string summary;
    std::vector<OptionDescription> options;
    std::string conditional_effects;  ///< "supported", ...
    std::string axioms;
    std::string safe;  ///< evaluators only: "yes", "no" or when
    std::string admissible;
    std::string consistent;
};

/// A name for a whole search expression.
struct AliasDescription {
    std::string name;
    std::string expression;
    std::string summary;
};

/// "integer", "list of evaluators", ...
std::string to_string(OptionType type);
/// "evaluator", "open list", "engine".
std::string to_string(ComponentKind kind);

}  // namespace praxis
