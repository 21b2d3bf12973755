#include "practice/experiment/number_text.hpp"

#include <charconv>
#include <cmath>

namespace praxis::practice {
namespace {

constexpr double kLargest = 1e15;  ///< beyond, digits would say more than a double knows

}  // namespace

std::string exact(double value) {
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string brief(double value) {
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 4).ptr};
}

std::string fixed(double value, int digits) {
    if (std::isnan(value)) return "?";
    if (std::abs(value) > kLargest) return value > 0 ? "\u221e" : "\u2212\u221e";
    char text[64];
    std::string result(text,
                       std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits).ptr);
    if (result.front() == '-' && result.find_first_not_of("-0.") == std::string::npos) result.erase(0, 1);
    return result;
}

std::string grouped(double value) {
    std::string text = fixed(value, 0);
    if (std::abs(value) > kLargest || std::isnan(value)) return text;
    const std::size_t start = text.front() == '-' ? 1 : 0;
    for (std::size_t at = text.size(); at > start + 3;) text.insert(at -= 3, ",");
    return text;
}

}  // namespace praxis::practice
