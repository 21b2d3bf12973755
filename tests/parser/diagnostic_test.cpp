#include "parser/diagnostic.hpp"

#include <gtest/gtest.h>

namespace praxis {
namespace {

std::string shown(const std::string& text, std::uint32_t offset, std::uint32_t length,
                  const std::string& hint = {}) {
    const Sources sources{{{"f.pddl", text}}};
    return to_string({Severity::error, {0, offset, length}, true, "wrong", hint}, sources);
}

TEST(Diagnostic, NamesPlaceAndMend) {
    EXPECT_EQ(shown("(a)\n  (at truck9 depot0)\n", 10, 6, "did you mean 'truck0'?"),
              "f.pddl:2:7: error: wrong\n"
              "  2 |   (at truck9 depot0)\n"
              "    |       ^~~~~~ did you mean 'truck0'?\n");
}

TEST(Diagnostic, AlignsWiderLineNumbers) {
    EXPECT_EQ(shown(std::string(99, '\n') + "xy", 100, 1),
              "f.pddl:100:2: error: wrong\n"
              "  100 | xy\n"
              "      |  ^\n");
}

TEST(Diagnostic, ExpandsTabs) {
    EXPECT_EQ(shown("\ta\tbc", 3, 2),
              "f.pddl:1:4: error: wrong\n"
              "  1 |         a       bc\n"
              "    |                 ^~\n");
}

TEST(Diagnostic, UnderlinesToTheEndOfTheLineOnly) {
    EXPECT_EQ(shown("ab (c\nd)", 3, 5),
              "f.pddl:1:4: error: wrong\n"
              "  1 | ab (c\n"
              "    |    ^~\n");
}

TEST(Diagnostic, ShowsTheEndOfTheFile) {
    EXPECT_EQ(shown("(a", 2, 0),
              "f.pddl:1:3: error: wrong\n"
              "  1 | (a\n"
              "    |   ^\n");
    EXPECT_EQ(shown("", 0, 0), "f.pddl:1:1: error: wrong\n  1 | \n    | ^\n");
}

TEST(Diagnostic, CountsCharactersNotBytes) {
    EXPECT_EQ(shown("\xC3\xA4\xE2\x82\xAC x", 6, 1),
              "f.pddl:1:4: error: wrong\n"
              "  1 | \xC3\xA4\xE2\x82\xAC x\n"
              "    |    ^\n");
}

TEST(Diagnostic, HidesUnprintableBytes) {
    EXPECT_EQ(shown(std::string("a\0\x1B\xFFz", 5), 4, 1),
              "f.pddl:1:5: error: wrong\n"
              "  1 | a???z\n"
              "    |     ^\n");
}

TEST(Diagnostic, DropsCarriageReturns) {
    EXPECT_EQ(shown("ab\r\ncd\r\n", 0, 2), "f.pddl:1:1: error: wrong\n  1 | ab\n    | ^~\n");
}

TEST(Diagnostic, CutsLongLinesAroundThePlace) {
    const std::string text = shown(std::string(1000, 'a') + "X" + std::string(1000, 'b'), 1000, 1);
    EXPECT_EQ(text,
              "f.pddl:1:1001: error: wrong\n"
              "  1 | ..." +
                  std::string(40, 'a') + "X" + std::string(59, 'b') +
                  "...\n"
                  "    | " +
                  std::string(43, ' ') + "^\n");
}

TEST(Diagnostic, SeveritiesHaveNames) {
    const Sources sources{{{"f", "x"}}};
    EXPECT_TRUE(
        to_string({Severity::warning, {0, 0, 1}, true, "m", ""}, sources).starts_with("f:1:1: warning: m\n"));
    EXPECT_TRUE(to_string({Severity::unsupported, {0, 0, 1}, true, "m", ""}, sources)
                    .starts_with("f:1:1: unsupported: m\n"));
}

TEST(Diagnostic, WorksWithoutAPlace) {
    EXPECT_EQ(to_string({Severity::error, {}, false, "gone", ""}, {}), "error: gone\n");
    EXPECT_EQ(to_string({Severity::error, {}, false, "gone", "look"}, {}), "error: gone; look\n");
}

}  // namespace
}  // namespace praxis
