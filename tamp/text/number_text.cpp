#include "tamp/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace praxis::tamp {

std::string shortest(double number) {
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return {text.data(), end};
}

std::string yaml_float(double number) {
    std::string text = shortest(number);
    if (text.find('.') == std::string::npos) text.insert(std::min(text.find('e'), text.size()), ".0");
    return text;
}

}  // namespace praxis::tamp
