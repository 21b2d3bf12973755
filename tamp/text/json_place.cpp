#include "tamp/text/json_place.hpp"

#include <algorithm>

#include "parser/files.hpp"

namespace praxis::tamp {

std::string JsonPlace::where() const {
    if (!parent_) return "";
    const std::string parent = parent_->where();
    if (!name_) return parent + "[" + std::to_string(index_) + "]";
    return parent.empty() ? name_ : parent + "." + name_;
}

void JsonPlace::refuse(const std::string& wanted) const {
    fail_unplaced(file_ + ": " + (parent_ ? where() : "the document") + " must be " + wanted);
}

JsonPlace JsonPlace::member(const char* name) const& {
    if (!value_.is_object()) refuse("an object");
    const auto found = value_.find(name);
    if (found == value_.end()) refuse("an object with a member \"" + std::string(name) + "\"");
    return {*found, file_, this, name, 0};
}

bool JsonPlace::has(const char* name) const {
    if (!value_.is_object()) refuse("an object");
    const auto found = value_.find(name);
    return found != value_.end() && !found->is_null();
}

JsonPlace JsonPlace::operator[](std::size_t index) const& {
    if (index >= size()) refuse("a list of more than " + std::to_string(index));
    return {value_[index], file_, this, nullptr, index};
}

std::size_t JsonPlace::size() const {
    if (!value_.is_array()) refuse("a list");
    return value_.size();
}

const std::string& JsonPlace::text() const {
    if (!value_.is_string()) refuse("a text");
    return value_.get_ref<const std::string&>();
}

bool JsonPlace::boolean() const {
    if (!value_.is_boolean()) refuse("true or false");
    return value_.get<bool>();
}

double JsonPlace::number() const {
    if (!value_.is_number()) refuse("a number");
    return value_.get<double>();
}

int JsonPlace::integer(int least, int largest) const {
    const bool whole = value_.is_number_unsigned()
                           ? value_.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::max(largest, 0))
                           : value_.is_number_integer();
    const std::int64_t number = whole ? value_.get<std::int64_t>() : std::int64_t{least} - 1;
    if (number < least || number > largest)
        refuse("a whole number from " + std::to_string(least) + " to " + std::to_string(largest));
    return static_cast<int>(number);
}

std::vector<double> JsonPlace::numbers() const {
    return list([](const JsonPlace& entry) { return entry.number(); });
}

std::size_t JsonPlace::one_of(const std::vector<std::string>& names) const {
    const auto found = std::ranges::find(names, text());
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    std::string wanted = "one of";
    for (const std::string& name : names) wanted += (&name == &names.front() ? " \"" : ", \"") + name + "\"";
    refuse(wanted);
}

}  // namespace praxis::tamp
