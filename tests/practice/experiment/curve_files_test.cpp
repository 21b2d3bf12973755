#include "practice/experiment/curve_files.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "parser/diagnostic.hpp"
#include "practice/experiment/csv.hpp"
#include "support.hpp"

namespace praxis::practice {
namespace {

const std::string kHeader = "environment,method,seed,cycle,transitions,solved\n";

std::vector<Curve> read(const std::string& text) {
    return read_curves({"curves.csv", text});
}

/// The message that refuses a text; "" if it is read.
std::string refusal(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(CurveFiles, LongForm) {
    const std::vector<Curve> curves = {{"a,b", "ees", 456, {{0, 0, 0.1}, {1, 250, 1}}}};
    EXPECT_EQ(curves_to_csv(curves), kHeader + "\"a,b\",ees,456,0,0,0.1\n\"a,b\",ees,456,1,250,1\n");
}

TEST(CurveFiles, Summary) {
    const std::vector<CurveSummary> summaries = {{"row", "say \"so\"", {{250, {0.5, 0.25, 0.75, 30}}}}};
    EXPECT_EQ(
        summaries_to_csv(summaries),
        "environment,method,transitions,mean,low,high,n\nrow,\"say \"\"so\"\"\",250,0.5,0.25,0.75,30\n");
}

TEST(CurveFiles, HostileNamesComeBack) {
    std::vector<Curve> curves;
    for (const std::string& environment : testing::hostile_names())
        for (const std::string& method : testing::hostile_names())
            curves.push_back({environment, method, 1, {{0, 0, 0.5}}});
    EXPECT_EQ(read(curves_to_csv(curves)), curves);
}

RC_GTEST_PROP(CurveFiles, EverythingComesBack, ()) {
    std::vector<Curve> curves;
    const auto text = rc::gen::container<std::string>(
        rc::gen::oneOf(rc::gen::elementOf(std::string("ab,\"\r\n.<")), rc::gen::arbitrary<char>()));
    const int count = *rc::gen::inRange(0, 5);
    for (int i = 0; i < count; ++i) {
        Curve& curve = curves.emplace_back(
            Curve{*text, *text + std::to_string(i), *rc::gen::arbitrary<std::uint64_t>(), {}});
        CurvePoint point{*rc::gen::inRange(0, 3), *rc::gen::inRange(0, 1000), 0};
        const int points = *rc::gen::inRange(1, 5);
        for (int p = 0; p < points; ++p) {
            point.cycle += *rc::gen::inRange(1, 3);
            point.transitions += *rc::gen::inRange(0, 3000);
            point.solved = 1 / (1 + static_cast<double>(*rc::gen::arbitrary<std::uint32_t>()) / 1e9);
            curve.points.push_back(point);
        }
    }
    RC_ASSERT(read(curves_to_csv(curves)) == curves);
}

TEST(CurveFiles, OtherProgramsMayEndLinesTheirWay) {
    const auto curves = read("environment,method,seed,cycle,transitions,solved\r\n\"row\",ees,1,0,0,5e-1");
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_EQ(curves[0], (Curve{"row", "ees", 1, {{0, 0, 0.5}}}));
}

TEST(CurveFiles, RowsOfSeveralRunsMayBeMixed) {
    const auto curves = read(kHeader + "e,b,1,0,0,0\ne,a,1,0,0,0\ne,b,1,1,9,1\n");
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0].method, "b");
    EXPECT_EQ(curves[0].points.size(), 2u);
}

TEST(CurveFiles, RefusalsNameLineAndMend) {
    const std::string good = "e,m,1,0,0,0.5\n";
    EXPECT_EQ(refusal(kHeader + good), "");
    const auto expect = [&](const std::string& rows, const std::string& place, const std::string& part) {
        const std::string message = refusal(kHeader + good + rows);
        EXPECT_NE(message.find("curves.csv:" + place), std::string::npos) << rows << "\n" << message;
        EXPECT_NE(message.find(part), std::string::npos) << rows << "\n" << message;
    };
    expect("e,m,2,0,0\n", "3:1:", "6 fields, this one has 5");
    expect("e,m,x,0,0,1\n", "3:5:", "'x' is not a seed");
    expect("e,m,-2,0,0,1\n", "3:5:", "not a seed");
    expect("e,m,2,0,0,nan\n", "3:11:", "from 0 to 1");
    expect("e,m,2,0,0,1.5\n", "3:11:", "from 0 to 1");
    expect("e,m,2,0,0,1e999\n", "3:11:", "not a fraction");
    expect("e,m,2,0,0,0.5 \n", "3:11:", "not a fraction");
    expect("e,m,2,99999999999,0,1\n", "3:7:", "not a number of a cycle");
    expect("e,m,1,0,0,1\n", "3:7:", "the row before it is of cycle 0");
    expect("e,m,2,3,9,1\ne,m,2,4,8,1\n", "4:9:", "there were 9 before");
    expect("e,m,2,-1,0,1\n", "3:7:", "rise from 0");
    expect("\n", "3:1:", "this one has 1");
    expect("e,\"m,2,0,0,1\n", "3:3:", "never closed");
    expect("e,\"m\"x,2,0,0,1\n", "3:6:", "after a closed quote");
    expect("e,m\"x,2,0,0,1\n", "3:4:", "a quote or carriage return");
    EXPECT_NE(refusal("").find("is empty"), std::string::npos);
    EXPECT_NE(refusal("a,b\n").find("the first line must be"), std::string::npos);
}

RC_GTEST_PROP(CurveFiles, AnyTextIsReadOrRefused, ()) {
    const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("01.,e\"\n\rm-")));
    try {
        check_curves(read(kHeader + text));
    } catch (const InputError&) {
    }
}

}  // namespace
}  // namespace praxis::practice
