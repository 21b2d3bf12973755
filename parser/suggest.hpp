// Words in messages: quoting them, and "did you mean ...?".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace praxis {

/// A word of the source in quotes; a very long one is cut.
std::string quote(std::string_view word);

/// Edits (insert, delete, replace, swap neighbours) between two words; `limit` + 1 if there are more than
/// `limit`.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit);

/// Finds the candidate nearest to a wrong word, if one is near enough. Expects folded words.
class Suggestion {
  public:
    explicit Suggestion(std::string_view wrong);
    void consider(std::string_view candidate);

    bool found() const { return !best_.empty(); }
    const std::string& best() const { return best_; }
    /// "did you mean 'x'?", or nothing.
    std::string hint() const { return found() ? "did you mean " + quote(best_) + '?' : std::string(); }

  private:
    std::string wrong_;
    std::string best_;
    std::size_t limit_;
};

}  // namespace praxis
