#include "tests/tamp/view/browser.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "tamp/report/replay.hpp"
#include "tamp/view/trajectory_page.hpp"
#include "tests/tamp/samples/sample_document.hpp"

namespace praxis::tamp {
namespace {

namespace fs = std::filesystem;

/// Tests that look at pages in a browser; each writes a page of its own.
class Browser : public testing::Test {
  protected:
    void SetUp() override {
#ifdef PRAXIS_SANITIZED
        GTEST_SKIP() << "the page is the same with sanitizers";
#endif
        if (!has_viewer()) GTEST_SKIP() << "this build has no viewer";
        if (find_browser().empty()) GTEST_SKIP() << "chromium is not installed (./setup.sh --packages --all)";
    }

    Visit look(const TrajectoryDocument& document, const std::string& hash) {
        const fs::path page =
            fs::temp_directory_path() / ("praxis-page-" + std::to_string(getpid()) + ".html");
        {
            std::ofstream out(page);
            write_view(document, out);
        }
        const Visit result = visit(page, hash);
        fs::remove(page);
        return result;
    }
};

/// The text of a joint's cell in the table of joints.
std::string joint_text(const Visit& page, const std::string& joint) {
    const std::string before = "<td>" + joint + "</td><td>";
    const std::size_t start = page.dom.find(before);
    if (start == std::string::npos) return "missing";
    const std::size_t begin = start + before.size();
    return page.dom.substr(begin, page.dom.find('<', begin) - begin);
}

std::size_t differing_pixels(const Picture& first, const Picture& second) {
    std::size_t count = 0;
    for (std::size_t y = 80; y < 600; ++y)
        for (std::size_t x = 0; x < 900; ++x)
            count += first.pixels.at(y * first.width + x) != second.pixels.at(y * second.width + x);
    return count;
}

std::size_t red_pixels(const Picture& picture) {
    std::size_t count = 0;
    for (std::size_t y = 80; y < 600; ++y)
        for (std::size_t x = 0; x < 900; ++x) {
            const std::uint32_t pixel = picture.pixels.at(y * picture.width + x);
            const std::uint32_t red = pixel & 0xff, green = pixel >> 8 & 0xff, blue = pixel >> 16 & 0xff;
            count += red > 140 && green < 60 && blue < 70;
        }
    return count;
}

TEST_F(Browser, ShowsTheSceneAndMovesTheRobot) {
    const TrajectoryDocument document = sample_document();
    const Visit start = look(document, "t=0&theme=light");
    const Visit later = look(document, "t=4&theme=light");
    EXPECT_EQ(start.errors, "");
    EXPECT_EQ(later.errors, "");
    EXPECT_EQ(start.picture.width, 1280u);
    EXPECT_GT(start.picture.colors(0, 80, 900, 600).size(), 200u);
    EXPECT_GT(differing_pixels(start.picture, later.picture), 5000u);
    EXPECT_EQ(red_pixels(start.picture), 0u);

    const double yaw = Replay(document).motion_at(4).positions[0];
    EXPECT_NEAR(std::stod(joint_text(later, "yaw")), yaw, 1e-3);
    EXPECT_NE(joint_text(start, "yaw"), joint_text(later, "yaw"));
    EXPECT_NE(later.dom.find("transfer, holding can"), std::string::npos);
    EXPECT_EQ(start.dom.find("holding can"), std::string::npos);
}

TEST_F(Browser, PlaysByItself) {
    const Visit page = look(sample_document(), "play=1&speed=8");
    EXPECT_EQ(page.errors, "");
    EXPECT_NE(page.dom.find("6.00 <small>/ 6.00 s"), std::string::npos) << joint_text(page, "yaw");
}

TEST_F(Browser, ShowsAFailedAttemptInRed) {
    const Visit page = look(sample_document(), "attempt=0&theme=dark");
    EXPECT_EQ(page.errors, "");
    EXPECT_GT(red_pixels(page.picture), 5000u);
    EXPECT_NE(page.dom.find("forearm × shelf"), std::string::npos);
    EXPECT_NE(page.dom.find("the forearm would touch the upper board"), std::string::npos);
}

TEST_F(Browser, ShowsHostileNamesAsTheyAre) {
    TrajectoryDocument document = sample_document();
    const std::string hostile = "</script><img src=x onerror=console.error(1)><!--";
    document.robot.name = hostile;
    document.robot.variables[0] = "__proto__";
    document.plan[0].name = hostile;
    document.plan[0].arguments = {hostile, "toString", "constructor"};
    document.attempts[0].action = hostile;
    document.attempts[0].message = hostile;
    document.values[hostile] = {hostile, {1}};
    document.values["__proto__"] = {"pose", {1}};
    document.bodies[4].name = hostile;
    const Visit page = look(document, "attempt=0");
    EXPECT_EQ(page.errors, "");
    EXPECT_EQ(page.dom.find("<img"), std::string::npos);
    EXPECT_NE(page.dom.find("<h1 id=\"name\">&lt;/script&gt;&lt;img"), std::string::npos);
    EXPECT_NE(joint_text(page, "__proto__"), "missing");
}

TEST_F(Browser, ShowsADocumentWithNothingInIt) {
    const Visit page = look(TrajectoryDocument(), "");
    EXPECT_EQ(page.errors, "");
    EXPECT_NE(page.dom.find("There is no plan."), std::string::npos);
}

}  // namespace
}  // namespace praxis::tamp
