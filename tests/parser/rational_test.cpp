#include "parser/rational.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <stdexcept>

namespace praxis {
namespace {

constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kMin = std::numeric_limits<std::int64_t>::min();

Rational small_fraction() {
    const auto denominator = *rc::gen::inRange<std::int64_t>(1, 1000);
    return Rational(*rc::gen::inRange<std::int64_t>(-1000, 1000), denominator);
}

TEST(Rational, IsReducedWithAPositiveDenominator) {
    const Rational value(6, -4);
    EXPECT_EQ(value.numerator(), -3);
    EXPECT_EQ(value.denominator(), 2);
    EXPECT_EQ(Rational(0, -7), Rational(0));
}

TEST(Rational, ParsesDecimalNumbers) {
    EXPECT_EQ(Rational::parse("3"), Rational(3));
    EXPECT_EQ(Rational::parse("-2.50"), Rational(-5, 2));
    EXPECT_EQ(Rational::parse("+.5"), Rational(1, 2));
    EXPECT_EQ(Rational::parse("7."), Rational(7));
    EXPECT_EQ(Rational::parse("1e-3"), Rational(1, 1000));
    EXPECT_EQ(Rational::parse("1.5E3"), Rational(1500));
    EXPECT_EQ(Rational::parse("0e999999999"), Rational(0));
    EXPECT_EQ(Rational::parse("1.00000000000000000000000000000000"), Rational(1));
    EXPECT_EQ(Rational::parse("9223372036854775807"), Rational(kMax));
    EXPECT_EQ(Rational::parse("-9223372036854775808"), Rational(kMin));
}

TEST(Rational, RefusesWhatIsNoNumberOrDoesNotFit) {
    for (const char* text : {"",
                             "-",
                             "+",
                             ".",
                             "e5",
                             "1e",
                             "1e+",
                             "1x",
                             "1.2.3",
                             "--1",
                             "0x10",
                             "1 ",
                             " 1",
                             "nan",
                             "9223372036854775808",
                             "-9223372036854775809",
                             "1e19",
                             "1e-19",
                             "1e99999999999",
                             "0.12345678901234567890123456789"}) {
        EXPECT_EQ(Rational::parse(text), std::nullopt) << text;
    }
}

TEST(Rational, PrintsDecimalsWhereTheyAreFinite) {
    EXPECT_EQ(Rational(5, 2).to_string(), "2.5");
    EXPECT_EQ(Rational(-1, 8).to_string(), "-0.125");
    EXPECT_EQ(Rational(1, 20).to_string(), "0.05");
    EXPECT_EQ(Rational(1, 3).to_string(), "1/3");
    EXPECT_EQ(Rational(kMin).to_string(), "-9223372036854775808");
    EXPECT_EQ(Rational(100).to_string(), "100");
}

TEST(Rational, ThrowsInsteadOfOverflowing) {
    EXPECT_THROW(Rational(kMax) + Rational(1), std::overflow_error);
    EXPECT_THROW(Rational(kMin) - Rational(1), std::overflow_error);
    EXPECT_THROW(Rational(kMax) * Rational(2), std::overflow_error);
    EXPECT_THROW(-Rational(kMin), std::overflow_error);
    EXPECT_THROW(Rational(1, kMax) * Rational(1, 2), std::overflow_error);
    EXPECT_THROW(Rational(1) / Rational(0), std::domain_error);
    EXPECT_THROW(Rational(1, 0), std::domain_error);
    EXPECT_EQ(Rational(kMax) * Rational(1, kMax), Rational(1));
}

TEST(Rational, ComparesExtremesExactly) {
    EXPECT_LT(Rational(kMax - 1, kMax), Rational(1));
    EXPECT_LT(Rational(kMin), Rational(kMin + 1));
    EXPECT_GT(Rational(1, 3), Rational(333333333333333333, 1000000000000000000));
}

RC_GTEST_PROP(RationalLaws, FieldOperations, ()) {
    const Rational a = small_fraction();
    const Rational b = small_fraction();
    const Rational c = small_fraction();
    RC_ASSERT(a + b == b + a);
    RC_ASSERT(a * b == b * a);
    RC_ASSERT((a + b) + c == a + (b + c));
    RC_ASSERT((a * b) * c == a * (b * c));
    RC_ASSERT(a * (b + c) == a * b + a * c);
    RC_ASSERT(a - b == a + (-b));
    if (b != Rational(0)) RC_ASSERT(a / b * b == a);
}

RC_GTEST_PROP(RationalLaws, OrderAgreesWithSubtraction, ()) {
    const Rational a = small_fraction();
    const Rational b = small_fraction();
    RC_ASSERT((a < b) == ((a - b).numerator() < 0));
    RC_ASSERT((a == b) == ((a <=> b) == std::strong_ordering::equal));
}

RC_GTEST_PROP(RationalLaws, DecimalsSurviveARoundTrip, ()) {
    const Rational value(*rc::gen::inRange<std::int64_t>(-1000000, 1000000),
                         *rc::gen::element<std::int64_t>(1, 2, 5, 10, 16, 1000, 625));
    RC_ASSERT(Rational::parse(value.to_string()) == value);
}

}  // namespace
}  // namespace praxis
