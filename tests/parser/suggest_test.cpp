#include "parser/suggest.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace praxis {
namespace {

TEST(EditDistance, CountsEdits) {
    EXPECT_EQ(edit_distance("truck9", "truck0", 3), 1U);
    EXPECT_EQ(edit_distance("abcd", "abdc", 3), 1U);
    EXPECT_EQ(edit_distance("abc", "abcd", 3), 1U);
    EXPECT_EQ(edit_distance("kitten", "sitting", 5), 3U);
    EXPECT_EQ(edit_distance("", "ab", 5), 2U);
}

TEST(EditDistance, StopsAtTheLimit) {
    EXPECT_EQ(edit_distance("aaaaaaaa", "bbbbbbbb", 2), 3U);
    EXPECT_EQ(edit_distance(std::string(100, 'a'), std::string(99, 'a'), 3), 4U);
}

TEST(Suggestion, TakesTheNearest) {
    Suggestion suggestion("trukc0");
    for (const char* name : {"depot0", "truck1", "truck0", "crate0"}) suggestion.consider(name);
    EXPECT_EQ(suggestion.hint(), "did you mean 'truck0'?");
}

TEST(Suggestion, PrefersTheFirstOfEqual) {
    Suggestion suggestion("truck9");
    suggestion.consider("truck0");
    suggestion.consider("truck1");
    EXPECT_EQ(suggestion.best(), "truck0");
}

TEST(Suggestion, LeavesFarWordsAlone) {
    Suggestion suggestion("x");
    suggestion.consider("y");
    suggestion.consider("depot");
    EXPECT_FALSE(suggestion.found());
    EXPECT_EQ(suggestion.hint(), "");
}

TEST(Quote, CutsLongWordsBetweenCharacters) {
    EXPECT_EQ(quote("abc"), "'abc'");
    EXPECT_EQ(quote(std::string(80, 'a')), "'" + std::string(60, 'a') + "...'");
    EXPECT_EQ(quote(std::string(59, 'a') + "\xC3\xA4" + "b"), "'" + std::string(59, 'a') + "...'");
}

RC_GTEST_PROP(EditDistanceLaws, IsSymmetricAndZeroForEqual, ()) {
    const auto word = rc::gen::container<std::string>(rc::gen::inRange('a', 'd'));
    const std::string a = *word;
    const std::string b = *word;
    RC_ASSERT(edit_distance(a, b, 20) == edit_distance(b, a, 20));
    RC_ASSERT((edit_distance(a, b, 20) == 0) == (a == b));
}

}  // namespace
}  // namespace praxis
