#include "search/text/markup.hpp"

#include <gtest/gtest.h>

namespace praxis {
namespace {

const std::string kReplacement = "\xef\xbf\xbd";

TEST(Markup, EscapesWhatWouldBeMarkup) {
    EXPECT_EQ(escape_markup("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; 'd'");
    EXPECT_EQ(escape_markup(""), "");
}

TEST(Markup, KeepsTextOfAllPlanes) {
    for (const std::string text : {"\t\n\r ~", "\xc2\x80", "\xc3\xa9", "\xe2\x82\xac", "\xf0\x9f\xa4\x96"})
        EXPECT_EQ(escape_markup(text), text);
}

TEST(Markup, ReplacesControlCharacters) {
    EXPECT_EQ(escape_markup(std::string("a\0b\x1b", 4)), "a" + kReplacement + "b" + kReplacement);
}

TEST(Markup, ReplacesEachByteThatIsNotText) {
    EXPECT_EQ(escape_markup("\xff<"), kReplacement + "&lt;");
    EXPECT_EQ(escape_markup("\xc3"), kReplacement);                     // cut off
    EXPECT_EQ(escape_markup("\xc0\xbc"), kReplacement + kReplacement);  // overlong "<"
    EXPECT_EQ(escape_markup("\xe0\x80\xbc"), kReplacement + kReplacement + kReplacement);
    EXPECT_EQ(escape_markup("\xef\xbf\xbf"), kReplacement);  // U+FFFF
    EXPECT_EQ(escape_markup("\xed\xa0\x80"), kReplacement);  // a surrogate
    EXPECT_EQ(escape_markup("\xc3("), kReplacement + "(");
}

TEST(Markup, ScriptStringsCannotEndTheirElement) {
    EXPECT_EQ(script_string("</script>\n\"\\"), "\"\\u003c/script\\u003e\\u000a\\\"\\\\\"");
}

}  // namespace
}  // namespace praxis
