// Exact numbers for action costs.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace praxis {

/// A fraction of 64-bit integers, always reduced, denominator positive. Arithmetic that would not fit throws
/// std::overflow_error; division by zero throws std::domain_error.
class Rational {
  public:
    constexpr Rational() = default;
    constexpr Rational(std::int64_t integer) : numerator_(integer) {}  // NOLINT: integers are rationals
    Rational(std::int64_t numerator, std::int64_t denominator);

    /// "3", "-2.50", "1e-3"; nothing if the text is not a number or does not fit.
    static std::optional<Rational> parse(std::string_view text);

    constexpr std::int64_t numerator() const { return numerator_; }
    constexpr std::int64_t denominator() const { return denominator_; }

    friend Rational operator+(Rational a, Rational b);
    friend Rational operator-(Rational a, Rational b);
    friend Rational operator*(Rational a, Rational b);
    friend Rational operator/(Rational a, Rational b);
    friend Rational operator-(Rational a) { return Rational() - a; }
    friend bool operator==(Rational a, Rational b) = default;
    friend std::strong_ordering operator<=>(Rational a, Rational b);

    /// A decimal number where there is a finite one ("2.5"), else "numerator/denominator".
    std::string to_string() const;

  private:
    std::int64_t numerator_ = 0;
    std::int64_t denominator_ = 1;
};

}  // namespace praxis
