// A valid document, one thing of it broken, and the refusal that names it.
#include "tamp/validate/trajectory_validator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tamp/report/describe.hpp"
#include "tamp/report/replay.hpp"
#include "tamp/scenes/body.hpp"
#include "tests/tamp/support/solved_problem.hpp"

namespace praxis::tamp {
namespace {

using Segment = TrajectoryDocument::Segment;
using Knot = Trajectory::Knot;

class TrajectoryValidator : public testing::Test {
  protected:
    TrajectoryVerdict verdict() const { return validate_trajectory(document, robot, world, start, check); }

    TrajectoryVerdict refused(const std::string& part) const {
        TrajectoryVerdict found = verdict();
        EXPECT_FALSE(found.valid) << part;
        EXPECT_NE(found.reason.find(part), std::string::npos)
            << "'" << found.reason << "' for '" << part << "'";
        return found;
    }

    std::size_t find(const std::function<bool(const Segment&)>& wanted) const {
        const auto found = std::ranges::find_if(document.segments, wanted);
        EXPECT_NE(found, document.segments.end());
        return static_cast<std::size_t>(found - document.segments.begin());
    }
    /// The first that moves, and has knots within.
    std::size_t moving() const {
        return find([](const Segment& segment) { return segment.knots.size() > 3; });
    }
    std::size_t attaching() const {
        return find([](const Segment& segment) { return segment.attach.has_value(); });
    }
    std::size_t detaching() const {
        return find([](const Segment& segment) { return segment.detach.has_value(); });
    }

    /// Later by so many seconds, from that segment on.
    void delay(std::size_t first, double seconds) {
        for (std::size_t i = first; i < document.segments.size(); ++i) {
            Segment& segment = document.segments[i];
            segment.start += seconds;
            segment.end += seconds;
            for (Knot& knot : segment.knots) knot.time += seconds;
        }
        for (TrajectoryDocument::Action& action : document.plan) action.end = document.duration();
    }

    /// Cuts a moving segment at a knot within; the second half follows at once.
    std::size_t split() {
        const std::size_t number = moving();
        Segment second = document.segments[number];
        Segment& first = document.segments[number];
        const std::ptrdiff_t middle = static_cast<std::ptrdiff_t>(first.knots.size() / 2);
        first.knots.erase(first.knots.begin() + middle + 1, first.knots.end());
        second.knots.erase(second.knots.begin(), second.knots.begin() + middle);
        first.end = second.start = first.knots.back().time;
        first.attach.reset();
        first.detach.reset();
        document.segments.insert(document.segments.begin() + static_cast<std::ptrdiff_t>(number) + 1, second);
        return number;
    }

    /// A small ball in the air, in the world and in the document.
    void add_ball(const std::string& name, const Vector3& where) {
        Pose pose = Pose::Identity();
        pose.translation() = where;
        world = world.with_body(make_body(name, {{Pose::Identity(), Sphere{0.002}}}), pose);
        document.bodies = begin_document(robot, world, start).bodies;
    }

    double middle_of(std::size_t segment) const {
        return (document.segments[segment].start + document.segments[segment].end) / 2;
    }

    const SceneProblem& problem = sorted_sticks().problem;
    TrajectoryDocument document = sorted_sticks().solution.document;
    Robot robot = *problem.scene.robot;
    World world = *problem.scene.world;
    Configuration start = problem.scene.start;
    TrajectoryCheck check = {};
};

TEST_F(TrajectoryValidator, AcceptsWhatIsValid) {
    const TrajectoryVerdict found = verdict();
    EXPECT_TRUE(found.valid) << found.reason;
    EXPECT_EQ(found.reason, "");
    EXPECT_EQ(found.segment, -1);
    EXPECT_GT(found.checked, 500U);
    check.step /= 2;
    EXPECT_GT(verdict().checked, found.checked * 3 / 2);
}

TEST_F(TrajectoryValidator, AcceptsWhatIsCutWhereNothingHappens) {
    split();
    EXPECT_EQ(verdict().reason, "");
}

TEST_F(TrajectoryValidator, RefusesJumps) {
    const std::size_t number = moving();
    for (Knot& knot : document.segments[number].knots) knot.positions[0] += 0.001;
    const TrajectoryVerdict position = refused("jumps where the segment begins");
    EXPECT_EQ(position.segment, static_cast<int>(number));
    EXPECT_EQ(position.time, document.segments[number].start);
    document = sorted_sticks().solution.document;
    document.segments[number].knots[0].velocities[1] += 0.001;
    refused("jumps where the segment begins");
}

TEST_F(TrajectoryValidator, EveryKnotMustFitItsNeighbours) {
    check.step = 1;
    std::size_t broken = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < document.segments.size(); ++i) {
        for (std::size_t k = 0; k < document.segments[i].knots.size(); ++k) {
            if (count++ % 7 != 0) continue;
            Knot& knot = document.segments[i].knots[k];
            const Knot before = knot;
            const std::size_t column = count % knot.positions.size();
            const bool last = k + 1 == document.segments[i].knots.size();
            for (const int part : {0, 1, 2}) {
                if (part == 2 && last) continue;
                (part == 0   ? knot.positions
                 : part == 1 ? knot.velocities
                             : knot.accelerations)[column] += part == 2 ? 0.1 : 1e-3;
                const TrajectoryVerdict found = verdict();
                EXPECT_FALSE(found.valid) << "segment " << i << " knot " << k << " part " << part;
                EXPECT_LE(found.segment, static_cast<int>(i) + 1);
                knot = before;
                ++broken;
            }
        }
    }
    EXPECT_GT(broken, 30U);
    EXPECT_TRUE(verdict().valid);
}

TEST_F(TrajectoryValidator, RefusesKnotsThatDoNotFitTheirAcceleration) {
    document.segments[moving()].knots[1].accelerations[0] += 0.5;
    refused("does not get from one knot to the next");
}

TEST_F(TrajectoryValidator, HoldsTheLimitsOfVelocityAndAcceleration) {
    for (Variable& variable : robot.variables) variable.max_velocity *= 0.5;
    refused("moves at");
    robot = *problem.scene.robot;
    for (Variable& variable : robot.variables) variable.max_acceleration *= 0.5;
    refused("accelerates by");
    check.limit_tolerance = 1.01;
    EXPECT_EQ(verdict().reason, "");
}

TEST_F(TrajectoryValidator, HoldsTheLimitsOfPosition) {
    const Segment& segment = document.segments[moving()];
    const std::size_t variable = static_cast<std::size_t>(segment.variables[0]);
    double highest = -1e9, lowest = 1e9;
    for (const Knot& knot : segment.knots) {
        highest = std::max(highest, knot.positions[0]);
        lowest = std::min(lowest, knot.positions[0]);
    }
    ASSERT_GT(highest - lowest, 0.01);
    (highest > start[variable] + 0.005 ? robot.variables[variable].upper = highest - 0.001
                                       : robot.variables[variable].lower = lowest + 0.001);
    refused("leaves its limits");
}

/// Turns round between two knots that are both within the limits.
TEST_F(TrajectoryValidator, HoldsTheLimitsBetweenKnots) {
    document.plan.resize(1);
    document.segments.resize(1);
    const double q = start[0];
    document.segments[0] = {.start = 0, .end = 4, .variables = {0}};
    document.segments[0].knots = {{0, {q}, {0}, {0.2}},
                                  {1, {q + 0.1}, {0.2}, {-0.2}},
                                  {3, {q + 0.1}, {-0.2}, {0.2}},
                                  {4, {q}, {0}, {0}}};
    robot.variables[0].upper = q + 0.21;
    EXPECT_EQ(verdict().reason, "");
    robot.variables[0].upper = q + 0.19;
    EXPECT_EQ(refused("leaves its limits").time, 1);
    robot.variables[0].upper = 3;
    EXPECT_EQ(verdict().reason, "");
    for (Knot& knot : document.segments[0].knots)
        for (auto* numbers : {&knot.velocities, &knot.accelerations}) (*numbers)[0] *= -1;
    for (const std::size_t k : {1U, 2U}) document.segments[0].knots[k].positions[0] = q - 0.1;
    EXPECT_EQ(verdict().reason, "");
    robot.variables[0].lower = q - 0.19;
    EXPECT_EQ(refused("leaves its limits").time, 1);
}

TEST_F(TrajectoryValidator, RefusesLinksThatTouchABodyInTheWay) {
    const std::size_t segment = moving();
    const EndEffector& hand = robot.end_effectors.front();
    const Link& link = robot.links[static_cast<std::size_t>(hand.link)];
    const std::vector<Pose> links = Replay(document).links_at(middle_of(segment));
    add_ball("midge", links[static_cast<std::size_t>(document.find_link(link.name))] *
                          link.collision.front().pose.translation());
    const TrajectoryVerdict found = refused("touches 'midge'");
    EXPECT_EQ(found.segment, static_cast<int>(segment));
    EXPECT_LE(found.time, middle_of(segment));
}

TEST_F(TrajectoryValidator, RefusesHeldBodiesThatTouchABodyInTheWay) {
    const std::size_t carried = attaching();
    const std::string held = document.segments[carried].attach->body;
    const std::size_t transfer =
        find([](const Segment& segment) { return segment.kind == TrajectoryDocument::Motion::transfer; });
    ASSERT_GT(transfer, carried);
    const Pose pose =
        Replay(document).bodies_at(middle_of(transfer))[static_cast<std::size_t>(document.find_body(held))];
    const double half = pose.linear().col(2).z() * 0.09;
    // Near the lower end, where neither hand nor table is.
    add_ball("midge", pose * Vector3(0, 0, -half));
    const TrajectoryVerdict found = refused("touches 'midge'");
    EXPECT_NE(found.reason.find("'" + held + "'"), std::string::npos) << found.reason;
}

TEST_F(TrajectoryValidator, RefusesWhatIsTakenElsewhere) {
    Segment& segment = document.segments[attaching()];
    segment.attach->pose[0] += 0.01;
    const TrajectoryVerdict found = refused("is not where the hand takes it, but 0.01 away");
    EXPECT_EQ(found.time, segment.end);
}

TEST_F(TrajectoryValidator, RefusesWhatIsTakenFromAfar) {
    const std::size_t number = attaching();
    Segment taking = document.segments[number];
    document.segments[number].attach.reset();
    // While the hand is still at home.
    const std::string body = taking.attach->body;
    const int link = robot.find_link(taking.attach->link);
    taking.attach->pose = to_numbers(link_pose(robot, start, link).inverse() * world[world.find(body)].pose);
    taking.start = taking.end = 0;
    taking.knots.clear();
    document.segments.insert(document.segments.begin(), taking);
    refused("out of reach of the hand");
}

TEST_F(TrajectoryValidator, RefusesWhatIsLetGoElsewhere) {
    document.segments[detaching()].detach->pose[2] += 0.01;
    refused("is not where the hand lets it go, but 0.01 away");
}

TEST_F(TrajectoryValidator, RefusesWhatIsLetGoInTheAir) {
    const std::size_t number =
        find([](const Segment& segment) { return segment.kind == TrajectoryDocument::Motion::transfer; });
    const std::size_t later = detaching();
    ASSERT_LT(number, later);
    TrajectoryDocument::Stand stand = *document.segments[later].detach;
    document.segments[later].detach.reset();
    const double time = document.segments[number].end;
    const Pose pose =
        Replay(document).bodies_at(time)[static_cast<std::size_t>(document.find_body(stand.body))];
    stand.pose = to_numbers(pose);
    document.segments[number].detach = stand;
    EXPECT_EQ(refused("is let go in the air").time, time);
    // A floor under it, as scenes may have one without a body.
    const double height = world[world.find(stand.body)].pose.translation().z();
    Area floor{.name = "floor", .size = {10, 10}};
    check.floors = {floor};
    refused("is let go in the air");
    for (double z = 0; z < 2; z += 0.005) {
        floor.pose.translation().z() = z;
        check.floors.push_back(floor);
    }
    EXPECT_EQ(verdict().reason.find("in the air"), std::string::npos) << height;
}

TEST_F(TrajectoryValidator, WhatIsLetGoMayFallALittle) {
    check.drop = kPlacementGap / 10;
    refused("is let go in the air");
    check.drop = kPlacementGap * 2;
    EXPECT_EQ(verdict().reason, "");
}

TEST_F(TrajectoryValidator, TheHandRestsWhileItTakesAndLetsGo) {
    const TrajectoryDocument::Hold hold = *document.segments[attaching()].attach;
    const std::size_t number = split();
    ASSERT_GT(std::abs(*std::ranges::max_element(document.segments[number].knots.back().velocities)), 0.01);
    document.segments[attaching()].attach.reset();
    document.segments[number].attach = hold;
    refused("is not at rest");
}

TEST_F(TrajectoryValidator, NothingStopsAtOnce) {
    const std::size_t number = split();
    delay(number + 1, 0.5);
    refused("is not at rest where nothing moves it");
    const Segment& first = document.segments[number];
    document.segments.insert(document.segments.begin() + static_cast<std::ptrdiff_t>(number) + 1,
                             {.action = first.action,
                              .kind = TrajectoryDocument::Motion::wait,
                              .start = first.end,
                              .end = first.end + 0.5});
    refused("is not at rest where nothing moves it");
}

TEST_F(TrajectoryValidator, EndsAtRest) {
    const std::size_t number = split();
    document.segments.resize(number + 1);
    refused("is not at rest where nothing moves it");
}

TEST_F(TrajectoryValidator, WaitingAtRestIsFine) {
    const std::size_t number = attaching();
    delay(number + 1, 0.5);
    EXPECT_EQ(verdict().reason, "");
}

TEST_F(TrajectoryValidator, RefusesBodiesThatCannotBeMoved) {
    const std::string body = document.segments[attaching()].attach->body;
    World fixed;
    for (const BodyState& state : world.bodies()) {
        BodyModel model = *state.model;
        if (model.name == body) model.movable = false;
        fixed = fixed.with_body(std::make_shared<const BodyModel>(model), state.pose);
    }
    world = fixed;
    refused("body '" + body + "' cannot be moved");
}

TEST_F(TrajectoryValidator, RefusesBodiesThatAreNotThere) {
    TrajectoryDocument::Body ghost = document.bodies.front();
    ghost.name = "ghost";
    document.bodies.push_back(ghost);
    refused("other bodies than the world");
    std::swap(document.bodies.front(), document.bodies.back());
    document.bodies.pop_back();
    refused("is not in the document");
    document = sorted_sticks().solution.document;
    document.segments[attaching()].attach->body = "ghost";
    EXPECT_THROW(verdict(), std::invalid_argument);
}

TEST_F(TrajectoryValidator, RefusesBodiesThatStartElsewhere) {
    document.bodies.back().pose[0] += 1e-4;
    refused("'" + document.bodies.back().name + "' does not start where it is in the world");
    document = sorted_sticks().solution.document;
    const int body = world.find(document.bodies.back().name);
    world = world.with_attached(body, {.link = robot.end_effectors.front().link});
    refused("is held at the start in the document or the world");
}

TEST_F(TrajectoryValidator, RefusesLinksThatAreNotThere) {
    TrajectoryDocument::Link ghost;
    ghost.name = "ghost";
    ghost.parent = 0;
    document.robot.links.push_back(ghost);
    Segment& segment = document.segments[attaching()];
    segment.attach->link = "ghost";
    refused("there is no link 'ghost'");
    document = sorted_sticks().solution.document;
    document.robot.links.back().name = "ghost";
    refused("is not in the document");
}

TEST_F(TrajectoryValidator, RefusesAnotherRobot) {
    document.robot.links[3].origin[2] += 1e-3;
    refused("'" + document.robot.links[3].name + "' of the document is not where the robot's is");
    document = sorted_sticks().solution.document;
    document.robot.variables[0] = "nose";
    refused("variable 'nose' is none of the robot");
    document = sorted_sticks().solution.document;
    document.robot.variables.push_back("nose");
    document.start.push_back(0);
    refused("another number of variables");
}

TEST_F(TrajectoryValidator, RefusesAnotherStart) {
    start[2] += 1e-3;
    refused("'" + robot.variables[2].name + "' does not start where the robot is");
}

TEST_F(TrajectoryValidator, RefusesSegmentsAtTheSameTime) {
    // The fingers move before the arm has stopped.
    std::size_t number = 0;
    for (std::size_t i = 0; i + 1 < document.segments.size(); ++i) {
        const Segment& next = document.segments[i + 1];
        if (document.segments[i].knots.size() > 1 && next.kind == TrajectoryDocument::Motion::gripper &&
            !next.knots.empty())
            number = i + 1;
    }
    ASSERT_GT(number, 0U);
    delay(number, -0.01);
    EXPECT_EQ(refused("starts before the last one has ended").segment, static_cast<int>(number));
}

TEST_F(TrajectoryValidator, RefusesVariablesThatAreMovedTwice) {
    const std::size_t number = split();
    document.segments[number + 1].start -= 0.01;
    document.segments[number + 1].knots[0].time -= 0.01;
    EXPECT_THROW(verdict(), std::invalid_argument);
}

TEST_F(TrajectoryValidator, RefusesVariablesOutOfOrder) {
    Segment& segment = document.segments[moving()];
    std::swap(segment.variables[0], segment.variables[1]);
    for (Knot& knot : segment.knots)
        for (auto* numbers : {&knot.positions, &knot.velocities, &knot.accelerations})
            std::swap((*numbers)[0], (*numbers)[1]);
    refused("variables are not in order");
}

TEST_F(TrajectoryValidator, ActionsThatDoNothingAreValid) {
    document.segments.clear();
    const TrajectoryVerdict found = verdict();
    EXPECT_TRUE(found.valid) << found.reason;
    EXPECT_EQ(found.checked, 0U);
}

}  // namespace
}  // namespace praxis::tamp
