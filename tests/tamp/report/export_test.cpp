#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "tamp/report/csv.hpp"
#include "tamp/report/joint_trajectory.hpp"
#include "tamp/text/number_text.hpp"
#include "tests/tamp/samples/sample_document.hpp"

namespace praxis::tamp {
namespace {

std::vector<std::string> csv_lines(const TrajectoryDocument& document, double rate) {
    std::ostringstream out;
    write_csv(document, rate, out);
    std::istringstream in(out.str());
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<YAML::Node> ros_documents(const TrajectoryDocument& document, JointTrajectoryForm form) {
    std::ostringstream out;
    write_joint_trajectory(document, form, out);
    return YAML::LoadAll(out.str());
}

TEST(Csv, HasARowForEachSampleAndEachEvent) {
    const TrajectoryDocument document = sample_document();
    const std::vector<std::string> lines = csv_lines(document, 10);
    EXPECT_EQ(lines[0], "t,yaw,shoulder,elbow,wrist,finger,gripper,event");
    EXPECT_EQ(lines[1].substr(0, 2), "0,");
    EXPECT_TRUE(lines[1].ends_with(",,(pick can table #g1 #q1)"));
    std::size_t attached = 0, holding = 0;
    for (const std::string& line : lines) {
        attached += line.ends_with(",can,attach can");
        holding += line.find(",can,") != std::string::npos;
    }
    EXPECT_EQ(attached, 1u);
    EXPECT_GT(holding, 20u);
    EXPECT_GE(lines.size(), static_cast<std::size_t>(document.duration() * 10) + 2);
}

TEST(Csv, QuotesNames) {
    TrajectoryDocument document = sample_document();
    document.robot.variables[0] = "a,\"b\"\nc";
    std::ostringstream out;
    write_csv(document, 1, out);
    EXPECT_TRUE(out.str().starts_with("t,\"a,\"\"b\"\"\nc\",shoulder"));
}

TEST(Csv, RefusesRatesThatMakeNoRows) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double rate : {0.0, -1.0, std::nan(""), infinity, 1e9})
        EXPECT_THROW(csv_lines(sample_document(), rate), std::invalid_argument) << rate;
}

TEST(Csv, WritesADocumentWithoutMotion) {
    TrajectoryDocument document;
    EXPECT_EQ(csv_lines(document, 10), (std::vector<std::string>{"t,gripper,event", "0,,"}));
}

TEST(JointTrajectory, HasADocumentForEachSegment) {
    const TrajectoryDocument document = sample_document();
    const std::vector<YAML::Node> segments = ros_documents(document, JointTrajectoryForm::segments);
    ASSERT_EQ(segments.size(), document.segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i) {
        const auto& knots = document.segments[i].knots;
        ASSERT_EQ(segments[i]["points"].size(), knots.size());
        EXPECT_EQ(segments[i]["joint_names"].size(), document.segments[i].variables.size());
        for (std::size_t k = 0; k < knots.size(); ++k) {
            const YAML::Node point = segments[i]["points"][k];
            EXPECT_EQ(point["positions"].as<std::vector<double>>(), knots[k].positions);
            EXPECT_EQ(point["velocities"].as<std::vector<double>>(), knots[k].velocities);
            EXPECT_EQ(point["accelerations"].as<std::vector<double>>(), knots[k].accelerations);
            const YAML::Node time = point["time_from_start"];
            EXPECT_NEAR(time["sec"].as<int>() + 1e-9 * time["nanosec"].as<int>(),
                        knots[k].time - document.segments[i].start, 1e-9);
        }
    }
}

TEST(JointTrajectory, HasOneDocumentForTheWhole) {
    TrajectoryDocument document = sample_document();
    document.robot.variables[1] = "it's: \"#1\"\n- x";
    const std::vector<YAML::Node> whole = ros_documents(document, JointTrajectoryForm::whole);
    ASSERT_EQ(whole.size(), 1u);
    EXPECT_EQ(whole[0]["joint_names"].as<std::vector<std::string>>(), document.robot.variables);
    std::int64_t before = -1;
    for (const YAML::Node& point : whole[0]["points"]) {
        EXPECT_EQ(point["positions"].size(), 5u);
        const YAML::Node time = point["time_from_start"];
        const auto nanoseconds =
            time["sec"].as<std::int64_t>() * 1'000'000'000 + time["nanosec"].as<std::int64_t>();
        EXPECT_GT(nanoseconds, before);
        before = nanoseconds;
    }
    EXPECT_NEAR(static_cast<double>(before) * 1e-9, document.duration(), 1e-9);
}

TEST(NumberText, AlwaysHasAPointInYaml) {
    EXPECT_EQ(yaml_float(1), "1.0");
    EXPECT_EQ(yaml_float(1e-5), "1.0e-05");
    EXPECT_EQ(yaml_float(-2.5e-7), "-2.5e-07");
    EXPECT_EQ(yaml_float(0.1), "0.1");
    EXPECT_EQ(shortest(0.1), "0.1");
}

}  // namespace
}  // namespace praxis::tamp
