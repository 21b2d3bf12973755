// Which operators keep it so that exactly one fact of some holds.
#include "belief/ground/choices.hpp"

#include <gtest/gtest.h>

#include "tests/belief/texts.hpp"

namespace praxis::belief::test {
namespace {

/// The operator that breaks "exactly one of (x), (y), (z)", or "".
std::string breaking(const std::string& actions) {
    const auto task = ground(propositional("(x) (y) (z) (g) (h)", actions,
                                           "(oneof (x) (y) (z)) (unknown (g)) (unknown (h))", "(g)"));
    const std::vector<Fact> choice{fact_of(*task, "(x)"), fact_of(*task, "(y)"), fact_of(*task, "(z)")};
    const auto found = breaks_choice(*task->physical, choice);
    return found ? task->physical->operator_name(*found) : "";
}

std::string action(const std::string& precondition, const std::string& effect) {
    return "(:action act :parameters () :precondition " + precondition + " :effect " + effect + ")";
}

TEST(Choices, MovesKeepThem) {
    EXPECT_EQ(breaking(action("(x)", "(and (not (x)) (y))")), "");
    EXPECT_EQ(breaking(action("(g)", "(when (x) (and (not (x)) (y)))")), "");
    EXPECT_EQ(breaking(action("(g)", "(and (when (x) (and (not (x)) (y))) (when (y) (and (not (y)) (z))))")),
              "");
    EXPECT_EQ(breaking(action("(g)", "(and (x) (not (y)) (not (z)))")), "");
}

TEST(Choices, NoValueOrTwoBreakThem) {
    EXPECT_EQ(breaking(action("(x)", "(not (x))")), "(act)");
    EXPECT_EQ(breaking(action("(x)", "(y)")), "(act)");
    EXPECT_EQ(breaking(action("(g)", "(and (x) (not (y)))")), "(act)");
    EXPECT_EQ(breaking(action("(x)", "(and (not (x)) (when (g) (y)))")), "(act)");
}

TEST(Choices, TwoNewValuesMustExcludeEachOther) {
    const std::string left = "(when (and (x) (g)) (and (not (x)) (y)))";
    EXPECT_EQ(breaking(action("()", "(and " + left + " (when (and (x) (not (g))) (and (not (x)) (z))))")),
              "");
    EXPECT_EQ(breaking(action("()", "(and " + left + " (when (and (x) (h)) (and (not (x)) (z))))")), "(act)");
}

TEST(Choices, OtherOperatorsDoNotMatter) {
    EXPECT_EQ(breaking(action("(x)", "(h)")), "");
}

}  // namespace
}  // namespace praxis::belief::test
