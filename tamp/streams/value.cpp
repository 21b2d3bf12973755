#include "tamp/streams/value.hpp"

#include <cxxabi.h>
#include <cstdlib>

namespace praxis::tamp {
namespace {

std::string readable(const std::type_info& type) {
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> name(
        abi::__cxa_demangle(type.name(), nullptr, nullptr, &status), &std::free);
    return name ? name.get() : type.name();
}

}  // namespace

void Value::fail(const std::type_info& wanted) const {
    const std::string who = name_.empty() ? "a value" : "the value of '" + name_ + "'";
    throw std::invalid_argument(who +
                                (content_ == nullptr ? " has no content" : " has type " + readable(*type_)) +
                                "; " + readable(wanted) + " is wanted");
}

}  // namespace praxis::tamp
