// A value that PDDL cannot see into: a pose, a grasp, a trajectory, a number. Whoever makes it chooses the
// type; whoever uses it asks for that type. Values are immutable, cheap to copy (the content is shared) and
// may be read by any thread. Two values are the same if they share their content.
#pragma once

#include <concepts>
#include <memory>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <utility>

namespace praxis::tamp {

class Value {
  public:
    /// Without content: what a PDDL object has that no value was given to.
    Value() = default;

    template <class T>
    static Value of(T content) {
        return Value(std::make_shared<const T>(std::move(content)), typeid(T));
    }
    template <class T>
    static Value shared(std::shared_ptr<const T> content) {
        return Value(std::move(content), typeid(T));
    }

    bool has_content() const { return content_ != nullptr; }
    template <class T>
    bool is() const {
        return content_ != nullptr && *type_ == typeid(T);
    }
    /// Null if the content is missing or of another type.
    template <class T>
    const T* get_if() const {
        return is<T>() ? static_cast<const T*>(content_.get()) : nullptr;
    }
    /// Throws std::invalid_argument, naming the value, if the content is missing or of another type.
    template <class T>
    const T& get() const {
        if (const T* content = get_if<T>()) return *content;
        fail(typeid(T));
    }

    /// The PDDL object or placeholder ("#p3") that the value is for; empty until the planner has taken it.
    const std::string& name() const { return name_; }
    Value named(std::string name) const {
        Value result = *this;
        result.name_ = std::move(name);
        return result;
    }

    friend bool operator==(const Value& a, const Value& b) {
        return a.content_ == b.content_ && (a.content_ != nullptr || a.name_ == b.name_);
    }

  private:
    Value(std::shared_ptr<const void> content, const std::type_info& type)
        : content_(std::move(content)), type_(&type) {}
    [[noreturn]] void fail(const std::type_info& wanted) const;

    std::shared_ptr<const void> content_;
    const std::type_info* type_ = nullptr;
    std::string name_;
};

}  // namespace praxis::tamp
