#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "parser/diagnostic.hpp"
#include "tamp/report/document_json.hpp"
#include "tamp/view/trajectory_page.hpp"
#include "tests/tamp/samples/sample_document.hpp"

namespace praxis::tamp {
namespace {

std::string page(const TrajectoryDocument& document) {
    std::ostringstream out;
    write_view(document, out);
    return out.str();
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t result = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++result;
    return result;
}

class Page : public testing::Test {
  protected:
    void SetUp() override {
        if (!has_viewer()) GTEST_SKIP() << "this build has no viewer";
    }
};

TEST(NoViewer, IsSaid) {
    if (has_viewer()) GTEST_SKIP() << "this build has the viewer";
    try {
        page(sample_document());
        FAIL() << "a page was written";
    } catch (const UnsupportedError& error) {
        EXPECT_NE(std::string(error.what()).find("this build of Praxis has no viewer"), std::string::npos);
    }
}

TEST_F(Page, HoldsTheDocument) {
    const TrajectoryDocument document = sample_document();
    const std::string text = page(document);
    const std::string mark = "<script type=\"application/json\" id=\"document\">";
    ASSERT_EQ(count(text, mark), 1u);
    const std::size_t begin = text.find(mark) + mark.size();
    const std::string json = text.substr(begin, text.find("</script>", begin) - begin);
    EXPECT_EQ(to_json(read_document({"page", json})), to_json(document));
}

TEST_F(Page, NeedsNothingElse) {
    const std::string text = page(sample_document());
    EXPECT_EQ(count(text, "<link"), 0u);
    EXPECT_EQ(count(text, "<script src"), 0u);
    EXPECT_EQ(count(text, "@import"), 0u);
    EXPECT_LT(text.size(), 1'000'000u);
}

TEST_F(Page, NamesCannotEndElements) {
    TrajectoryDocument document = sample_document();
    const std::size_t ends = count(page(document), "</script");
    document.robot.name = "</title></script><script>x()</script>";
    document.plan[0].arguments[0] = "</script><!-- <script>";
    document.values["</script>"] = {"</SCRIPT>", {}};
    const std::string text = page(document);
    EXPECT_EQ(count(text, "</script"), ends);
    EXPECT_EQ(count(text, "</title>"), 1u);
    EXPECT_EQ(count(text, "<script>x"), 0u);
    EXPECT_EQ(count(text, "</SCRIPT"), 0u);
}

TEST_F(Page, RefusesDocumentsThatDoNotFitTogether) {
    TrajectoryDocument document = sample_document();
    document.start[0] = std::nan("");
    EXPECT_THROW(page(document), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
