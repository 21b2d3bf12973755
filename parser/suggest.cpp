#include "parser/suggest.hpp"

#include <algorithm>
#include <array>

namespace praxis {
namespace {

constexpr std::size_t kLongest = 63;

}  // namespace

std::string quote(std::string_view word) {
    constexpr std::size_t kShown = 60;
    std::size_t length = word.size();
    if (length > kShown) {
        length = kShown;
        while (length > 0 && (static_cast<unsigned char>(word[length]) & 0xC0U) == 0x80U) --length;
    }
    std::string result;
    result.reserve(length + 5);
    result.push_back('\'');
    result.append(word.substr(0, length));
    if (length < word.size()) result.append("...");
    result.push_back('\'');
    return result;
}

std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
    if (a.size() > kLongest || b.size() > kLongest) return a == b ? 0 : limit + 1;
    if (a.size() + limit < b.size() || b.size() + limit < a.size()) return limit + 1;
    std::array<std::array<std::size_t, kLongest + 1>, 3> rows{};
    for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        auto& row = rows[i % 3];
        const auto& above = rows[(i + 2) % 3];
        const auto& before = rows[(i + 1) % 3];
        row[0] = i;
        std::size_t least = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] =
                std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
            least = std::min(least, row[j]);
        }
        if (least > limit) return limit + 1;
    }
    return std::min(rows[a.size() % 3][b.size()], limit + 1);
}

Suggestion::Suggestion(std::string_view wrong)
    : wrong_(wrong), limit_(std::clamp<std::size_t>(wrong.size() / 3, 1, 3)) {}

void Suggestion::consider(std::string_view candidate) {
    if (candidate.empty() || candidate.size() <= limit_ - 1) return;
    const std::size_t distance = edit_distance(wrong_, candidate, limit_);
    if (distance > limit_ || distance * 2 >= std::max(wrong_.size(), candidate.size())) return;
    if (found() && distance == limit_) return;
    best_ = candidate;
    limit_ = distance;
}

}  // namespace praxis
