#include "practice/experiment/curves.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "support.hpp"

namespace praxis::practice {
namespace {

const Curve kFirst{"row", "ees", 1, {{0, 0, 0.0}, {1, 100, 0.5}, {2, 200, 1.0}}};
const Curve kSecond{"row", "ees", 2, {{0, 0, 0.2}, {1, 150, 0.4}, {2, 260, 0.6}}};

TEST(Curves, AreStepsBetweenEvaluations) {
    EXPECT_EQ(solved_at(kFirst.points, 0), 0.0);
    EXPECT_EQ(solved_at(kFirst.points, 99), 0.0);
    EXPECT_EQ(solved_at(kFirst.points, 100), 0.5);
    EXPECT_EQ(solved_at(kFirst.points, 199), 0.5);
    EXPECT_EQ(solved_at(kFirst.points, 1'000'000), 1.0);
    EXPECT_EQ(solved_at(std::vector<CurvePoint>{{1, 50, 0.3}}, 10), 0.3);
    EXPECT_THROW(solved_at({}, 0), std::invalid_argument);
}

TEST(Curves, TheLastOfSeveralEvaluationsAtOnePlaceCounts) {
    EXPECT_EQ(solved_at(std::vector<CurvePoint>{{0, 5, 0.1}, {1, 5, 0.2}}, 5), 0.2);
}

TEST(Curves, TheGridHasEveryEvaluation) {
    const std::vector<Curve> curves = {kFirst, kSecond};
    EXPECT_EQ(common_grid(curves), (std::vector<std::int64_t>{0, 100, 150, 200, 260}));
    EXPECT_EQ(common_grid(curves, 3), (std::vector<std::int64_t>{0, 130, 260}));
    EXPECT_EQ(common_grid({}), (std::vector<std::int64_t>{}));
    EXPECT_THROW(common_grid(curves, 1), std::invalid_argument);
}

TEST(Curves, LargeNumbersHaveAGridToo) {
    constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
    Curve curve{"e", "m", 0, {}};
    for (int i = 0; i < 10; ++i) curve.points.push_back({i, kLargest / 9 * i, 0.5});
    curve.points.back().transitions = kLargest;
    const std::vector<std::int64_t> grid = common_grid({&curve, 1}, 4);
    ASSERT_EQ(grid.size(), 4u);
    EXPECT_EQ(grid.front(), 0);
    EXPECT_EQ(grid.back(), kLargest);
    EXPECT_TRUE(std::is_sorted(grid.begin(), grid.end()));
}

TEST(Curves, MeansByHand) {
    const std::vector<Curve> curves = {kFirst, kSecond};
    const std::vector<CurveSummary> summaries = summarise(curves);
    ASSERT_EQ(summaries.size(), 1u);
    const std::vector<double> means = {0.1, 0.35, 0.45, 0.7, 0.8};  // at 0, 100, 150, 200, 260
    ASSERT_EQ(summaries[0].points.size(), means.size());
    for (std::size_t i = 0; i < means.size(); ++i) {
        const IntervalEstimate& solved = summaries[0].points[i].solved;
        EXPECT_NEAR(solved.value, means[i], 1e-12);
        EXPECT_EQ(solved.count, 2u);
        EXPECT_GE(solved.low, 0);
        EXPECT_LE(solved.high, 1);
    }
    // Two seeds, 12.7062 * 0.05: no cut at 150 transitions, where they solve 0.5 and 0.4.
    EXPECT_EQ(summaries[0].points[2].solved.high, 1);
    EXPECT_EQ(summaries[0].points[2].solved.low, 0);
}

TEST(Curves, MethodsShareAGridAndEndWhereTheyEnd) {
    Curve other = kFirst;
    other.method = "random";
    other.points.pop_back();
    Curve elsewhere = kFirst;
    elsewhere.environment = "kitchen";
    const std::vector<Curve> curves = {kFirst, elsewhere, other, kSecond};
    const std::vector<CurveSummary> summaries = summarise(curves);
    ASSERT_EQ(summaries.size(), 3u);
    EXPECT_EQ(summaries[0].method, "ees");
    EXPECT_EQ(summaries[1].method, "random");
    EXPECT_EQ(summaries[2].environment, "kitchen");
    EXPECT_EQ(summaries[0].points.size(), 5u);
    ASSERT_EQ(summaries[1].points.size(), 2u);
    EXPECT_EQ(summaries[1].points.back().transitions, 100);
    EXPECT_EQ(summaries[1].points.back().solved.count, 1u);
}

TEST(Curves, AThinGridKeepsTheEndsOfEachMethod) {
    Curve brief{"row", "brief", 1, {{0, 3, 0.1}, {1, 7, 0.2}}};
    const std::vector<Curve> curves = {kFirst, kSecond, brief};
    const std::vector<CurveSummary> summaries = summarise(curves, 0.95, 3);
    ASSERT_EQ(summaries[1].points.size(), 2u);
    EXPECT_EQ(summaries[1].points[0].transitions, 3);
    EXPECT_EQ(summaries[1].points[1].transitions, 7);
    EXPECT_EQ(summaries[0].points.back().transitions, 260);
}

TEST(Curves, RefusesWhatIsNoCurve) {
    const auto refused = [](std::vector<CurvePoint> points) {
        const Curve curve{"row", "ees", 456, std::move(points)};
        try {
            check_curves({&curve, 1});
        } catch (const std::invalid_argument& error) {
            return std::string(error.what()).find("456") != std::string::npos;
        }
        return false;
    };
    EXPECT_TRUE(refused({}));
    EXPECT_TRUE(refused({{1, 0, 0.5}, {0, 1, 0.5}}));
    EXPECT_FALSE(refused({{0, 0, 0.5}, {0, 1, 0.5}})) << "a cycle may have several tests";
    EXPECT_TRUE(refused({{0, 2, 0.5}, {1, 1, 0.5}}));
    EXPECT_TRUE(refused({{0, 0, 1.5}}));
    EXPECT_TRUE(refused({{0, 0, std::numeric_limits<double>::quiet_NaN()}}));
    EXPECT_TRUE(refused({{0, -1, 0.5}}));
    EXPECT_FALSE(refused({{0, 0, 0.5}, {2, 0, 1}}));
    EXPECT_THROW(check_curves(std::vector<Curve>{kFirst, kFirst}), std::invalid_argument);
}

RC_GTEST_PROP(Curves, MeansLieBetweenTheSeeds, ()) {
    std::vector<Curve> curves;
    const int seeds = *rc::gen::inRange(1, 5);
    for (int seed = 0; seed < seeds; ++seed) {
        Curve& curve = curves.emplace_back(Curve{"e", "m", static_cast<std::uint64_t>(seed), {}});
        std::int64_t transitions = 0;
        const int points = *rc::gen::inRange(1, 6);
        for (int cycle = 0; cycle < points; ++cycle) {
            transitions += *rc::gen::inRange(0, 50);
            curve.points.push_back({cycle, transitions, *rc::gen::inRange(0, 101) / 100.0});
        }
    }
    const std::vector<CurveSummary> summaries = summarise(curves);
    for (const auto& [at, solved] : summaries[0].points) {
        double least = 1, most = 0;
        for (const Curve& curve : curves) {
            least = std::min(least, solved_at(curve.points, at));
            most = std::max(most, solved_at(curve.points, at));
        }
        RC_ASSERT(solved.value >= least - 1e-12 && solved.value <= most + 1e-12);
        RC_ASSERT(solved.low <= solved.value + 1e-12 && solved.value <= solved.high + 1e-12);
    }
}

}  // namespace
}  // namespace praxis::practice
