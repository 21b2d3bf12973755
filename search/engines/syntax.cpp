#include "search/engines/syntax.hpp"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <stdexcept>

namespace praxis {

namespace {

constexpr int kMaximumDepth = 100;

class Parser {
  public:
    explicit Parser(std::string_view text) : text_(text) {}

    SyntaxNode parse() {
        SyntaxNode node = value(0);
        skip_blanks();
        if (at_ < text_.size()) fail("expected the end of the expression");
        return node;
    }

  private:
    SyntaxNode value(int depth) {
        if (depth > kMaximumDepth) fail("the expression is nested too deeply");
        skip_blanks();
        SyntaxNode node;
        node.offset = at_;
        if (accept('[')) {
            node.kind = SyntaxNode::Kind::list;
            sequence(node, ']', depth);
            return node;
        }
        node.text = word();
        if (node.text.empty()) fail("expected a name, a number or a list");
        node.length = node.text.size();
        if (accept('(')) {
            node.kind = SyntaxNode::Kind::call;
            sequence(node, ')', depth);
        }
        return node;
    }

    void sequence(SyntaxNode& parent, char close, int depth) {
        if (accept(close)) return;
        do {
            skip_blanks();
            const std::size_t start = at_;
            std::string key;
            if (close == ')') {
                key = word();
                if (key.empty() || !accept('=')) {
                    at_ = start;
                    key.clear();
                }
            }
            parent.children.push_back(value(depth + 1));
            parent.children.back().key = std::move(key);
            parent.children.back().key_offset = start;
        } while (accept(','));
        if (!accept(close)) fail(std::string("expected ',' or '") + close + "'");
    }

    std::string word() {
        std::string result;
        const auto part_of_word = [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-' ||
                   c == '+';
        };
        while (at_ < text_.size() && part_of_word(text_[at_])) {
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(text_[at_++])));
        }
        return result;
    }

    bool accept(char c) {
        skip_blanks();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }

    void skip_blanks() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    }

    [[noreturn]] void fail(const std::string& message) {
        skip_blanks();
        expression_error(text_, at_, 1, message);
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substituted = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

SyntaxNode parse_expression(std::string_view expression) {
    return Parser(expression).parse();
}

void expression_error(std::string_view expression, std::size_t offset, std::size_t length,
                      const std::string& message, const std::string& hint) {
    std::string line(expression);
    for (char& c : line) {
        if (std::isspace(static_cast<unsigned char>(c)) != 0) c = ' ';
    }
    std::string text = "search expression:" + std::to_string(offset + 1) + ": " + message + "\n  " + line +
                       "\n  " + std::string(offset, ' ') + '^' +
                       std::string(length > 1 ? length - 1 : 0, '~');
    if (!hint.empty()) text += ' ' + hint;
    throw std::invalid_argument(text);
}

std::string closest_name(std::string_view word, const std::vector<std::string>& candidates) {
    std::string closest;
    std::size_t best = std::max<std::size_t>(2, word.size() / 3) + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate);
        if (distance < best) {
            best = distance;
            closest = candidate;
        }
    }
    return closest;
}

}  // namespace praxis
