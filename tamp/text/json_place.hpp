// A value of a JSON document and where it stands, for strict readers.
//
// A place keeps a pointer to the place that it is in: it must not outlive it, so `member` and `operator[]`
// cannot be called on temporaries. The text of a place ("segments[3].knots[0].q") is made only for errors.
#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace praxis::tamp {

class JsonPlace {
  public:
    /// The whole of `file`. Both are kept by reference.
    JsonPlace(const nlohmann::json& value, const std::string& file) : value_(value), file_(file) {}

    /// Throws InputError: "FILE: PLACE must be WANTED".
    [[noreturn]] void refuse(const std::string& wanted) const;
    /// Member of an object; it must be there.
    JsonPlace member(const char* name) const&;
    JsonPlace member(const char* name) const&& = delete;
    /// Of an object: it has this member, and that is not null.
    bool has(const char* name) const;
    /// Entry of a list.
    JsonPlace operator[](std::size_t index) const&;
    JsonPlace operator[](std::size_t index) const&& = delete;
    /// Number of entries of a list.
    std::size_t size() const;
    /// Calls `visit(name, place)` for each member of an object.
    template <class Visit>
    void each_member(Visit visit) const {
        if (!value_.is_object()) refuse("an object");
        for (const auto& [name, value] : value_.items())
            visit(name, JsonPlace(value, file_, this, name.c_str(), 0));
    }

    const std::string& text() const;
    bool boolean() const;
    double number() const;
    /// A whole number from `least` to `largest`.
    int integer(int least, int largest = std::numeric_limits<int>::max()) const;
    std::vector<double> numbers() const;
    /// Index of the text in `names`.
    std::size_t one_of(const std::vector<std::string>& names) const;

    /// Each entry of a list, read by `read(place)`.
    template <class Read>
    auto list(Read read) const -> std::vector<decltype(read(std::declval<const JsonPlace&>()))> {
        std::vector<decltype(read(*this))> result;
        const std::size_t count = size();
        result.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            const JsonPlace entry = (*this)[i];
            result.push_back(read(entry));
        }
        return result;
    }

  private:
    JsonPlace(const nlohmann::json& value, const std::string& file, const JsonPlace* parent, const char* name,
              std::size_t index)
        : value_(value), file_(file), parent_(parent), name_(name), index_(index) {}
    std::string where() const;

    const nlohmann::json& value_;
    const std::string& file_;
    const JsonPlace* parent_ = nullptr;
    const char* name_ = nullptr;  ///< null: an entry of a list
    std::size_t index_ = 0;
};

}  // namespace praxis::tamp
