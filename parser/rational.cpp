#include "parser/rational.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace praxis {
namespace {

__extension__ using Wide = __int128;

Wide greatest_common_divisor(Wide a, Wide b) {
    while (b != 0) {
        const Wide rest = a % b;
        a = b;
        b = rest;
    }
    return a < 0 ? -a : a;
}

bool fits(Wide value) {
    return value >= std::numeric_limits<std::int64_t>::min() &&
           value <= std::numeric_limits<std::int64_t>::max();
}

/// The parts of a reduced fraction with a positive denominator; nothing if they do not fit.
std::optional<std::array<std::int64_t, 2>> reduced(Wide numerator, Wide denominator) {
    if (denominator < 0) {
        numerator = -numerator;
        denominator = -denominator;
    }
    const Wide divisor = greatest_common_divisor(numerator, denominator);
    numerator /= divisor;
    denominator /= divisor;
    if (!fits(numerator) || !fits(denominator)) return std::nullopt;
    return std::array{static_cast<std::int64_t>(numerator), static_cast<std::int64_t>(denominator)};
}

std::array<std::int64_t, 2> reduced_or_throw(Wide numerator, Wide denominator) {
    if (denominator == 0) throw std::domain_error("division by zero");
    if (const auto parts = reduced(numerator, denominator)) return *parts;
    throw std::overflow_error("number too large for a 64-bit fraction");
}

/// a * b where one of them is small; clamps instead of overflowing.
bool multiply(Wide& value, std::int64_t factor) {
    constexpr Wide kLimit = Wide(std::numeric_limits<std::int64_t>::max()) << 32;
    if (value > kLimit || value < -kLimit) return false;
    value *= factor;
    return true;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

}  // namespace

Rational::Rational(std::int64_t numerator, std::int64_t denominator) {
    const auto parts = reduced_or_throw(numerator, denominator);
    numerator_ = parts[0];
    denominator_ = parts[1];
}

std::optional<Rational> Rational::parse(std::string_view text) {
    std::size_t at = 0;
    const bool negative = !text.empty() && text[0] == '-';
    if (!text.empty() && (text[0] == '-' || text[0] == '+')) ++at;
    Wide numerator = 0;
    Wide denominator = 1;
    std::size_t digits = 0;
    for (; at < text.size() && is_digit(text[at]); ++at, ++digits) {
        if (!multiply(numerator, 10)) return std::nullopt;
        numerator += text[at] - '0';
    }
    if (at < text.size() && text[at] == '.') {
        std::size_t end = ++at;
        while (end < text.size() && is_digit(text[end])) ++end;
        digits += end - at;
        std::size_t significant = end;
        while (significant > at && text[significant - 1] == '0') --significant;
        for (; at < significant; ++at) {
            if (!multiply(numerator, 10) || !multiply(denominator, 10)) return std::nullopt;
            numerator += text[at] - '0';
        }
        at = end;
    }
    if (digits == 0) return std::nullopt;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        ++at;
        const bool small = at < text.size() && text[at] == '-';
        if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
        if (at == text.size()) return std::nullopt;
        int exponent = 0;
        for (; at < text.size() && is_digit(text[at]); ++at) {
            exponent = std::min(exponent * 10 + (text[at] - '0'), 1000);
        }
        for (; exponent > 0 && numerator != 0; --exponent) {
            if (!multiply(small ? denominator : numerator, 10)) return std::nullopt;
        }
    }
    if (at != text.size()) return std::nullopt;
    const auto parts = reduced(negative ? -numerator : numerator, denominator);
    if (!parts) return std::nullopt;
    return Rational((*parts)[0], (*parts)[1]);
}

Rational operator+(Rational a, Rational b) {
    const auto parts =
        reduced_or_throw(Wide(a.numerator_) * b.denominator_ + Wide(b.numerator_) * a.denominator_,
                         Wide(a.denominator_) * b.denominator_);
    return Rational(parts[0], parts[1]);
}

Rational operator-(Rational a, Rational b) {
    const auto parts =
        reduced_or_throw(Wide(a.numerator_) * b.denominator_ - Wide(b.numerator_) * a.denominator_,
                         Wide(a.denominator_) * b.denominator_);
    return Rational(parts[0], parts[1]);
}

Rational operator*(Rational a, Rational b) {
    const auto parts =
        reduced_or_throw(Wide(a.numerator_) * b.numerator_, Wide(a.denominator_) * b.denominator_);
    return Rational(parts[0], parts[1]);
}

Rational operator/(Rational a, Rational b) {
    const auto parts =
        reduced_or_throw(Wide(a.numerator_) * b.denominator_, Wide(a.denominator_) * b.numerator_);
    return Rational(parts[0], parts[1]);
}

std::strong_ordering operator<=>(Rational a, Rational b) {
    const Wide left = Wide(a.numerator_) * b.denominator_;
    const Wide right = Wide(b.numerator_) * a.denominator_;
    if (left == right) return std::strong_ordering::equal;
    return left < right ? std::strong_ordering::less : std::strong_ordering::greater;
}

std::string Rational::to_string() const {
    if (denominator_ == 1) return std::to_string(numerator_);
    std::int64_t rest = denominator_;
    int twos = 0;
    int fives = 0;
    for (; rest % 2 == 0; rest /= 2) ++twos;
    for (; rest % 5 == 0; rest /= 5) ++fives;
    const int decimals = std::max(twos, fives);
    Wide scaled = numerator_ < 0 ? -Wide(numerator_) : Wide(numerator_);
    bool finite = rest == 1 && decimals <= 18;
    for (int i = twos; finite && i < decimals; ++i) finite = multiply(scaled, 2);
    for (int i = fives; finite && i < decimals; ++i) finite = multiply(scaled, 5);
    if (!finite) return std::to_string(numerator_) + '/' + std::to_string(denominator_);
    std::string digits;
    for (int place = 0; scaled > 0 || place <= decimals; ++place, scaled /= 10) {
        if (place == decimals) digits += '.';
        digits += static_cast<char>('0' + static_cast<int>(scaled % 10));
    }
    if (numerator_ < 0) digits += '-';
    return {digits.rbegin(), digits.rend()};
}

}  // namespace praxis
