// The text of a search expression as a tree: name(argument, [list], key=value), words and numbers.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace praxis {

/// One node of an expression. Text is in lower case; names may be written in any case.
struct SyntaxNode {
    enum class Kind { call, list, word };
    Kind kind = Kind::word;
    std::string text;                  ///< call: the name; word: itself; list: empty
    std::size_t offset = 0;            ///< in the expression
    std::size_t length = 1;            ///< of what an error about the node points at
    std::vector<SyntaxNode> children;  ///< arguments or items
    std::string key;                   ///< as an argument: its name; empty if it has none
    std::size_t key_offset = 0;
};

/// Throws std::invalid_argument with place and mend.
SyntaxNode parse_expression(std::string_view expression);

/// Throws std::invalid_argument: the message, the expression and a caret under the place, with a hint behind
/// it.
[[noreturn]] void expression_error(std::string_view expression, std::size_t offset, std::size_t length,
                                   const std::string& message, const std::string& hint = {});

/// The candidate that is closest to a misspelt word, if one is close; else empty.
std::string closest_name(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace praxis
