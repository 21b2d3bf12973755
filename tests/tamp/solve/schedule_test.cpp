#include "tamp/solve/schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/tamp/support/planned_motions.hpp"

namespace praxis::tamp {
namespace {

class ScheduleTest : public testing::Test {
  protected:
    /// Largest share of a limit that is used.
    double used(const TrajectoryDocument& document, bool velocity) const {
        double most = 0;
        for (const TrajectoryDocument::Segment& segment : document.segments) {
            for (const Trajectory::Knot& knot : segment.knots) {
                for (std::size_t i = 0; i < segment.variables.size(); ++i) {
                    const Variable& variable =
                        planned.problem.scene.robot
                            ->variables[static_cast<std::size_t>(segment.variables[i])];
                    most = std::max(most, velocity
                                              ? std::abs(knot.velocities[i]) / variable.max_velocity
                                              : std::abs(knot.accelerations[i]) / variable.max_acceleration);
                }
            }
        }
        return most;
    }

    PlannedMotions planned = PlannedMotions(sorted_sticks());
};

TEST_F(ScheduleTest, OnePieceFollowsTheOther) {
    const TrajectoryDocument document = planned.schedule();
    EXPECT_NO_THROW(check_document(document));
    ASSERT_EQ(document.plan.size(), planned.actions.size());
    double time = 0;
    for (std::size_t i = 0; i < document.plan.size(); ++i) {
        EXPECT_EQ(document.plan[i].name, planned.actions[i].name);
        EXPECT_EQ(document.plan[i].arguments, planned.actions[i].arguments);
        EXPECT_EQ(document.plan[i].start, time);
        EXPECT_GT(document.plan[i].end, time);
        time = document.plan[i].end;
    }
    EXPECT_EQ(document.duration(), time);
    std::size_t piece = 0;
    time = 0;
    for (std::size_t i = 0; i < planned.actions.size(); ++i) {
        for (const MotionPiece& wanted : planned.actions[i].motion.pieces) {
            ASSERT_LT(piece, document.segments.size());
            const TrajectoryDocument::Segment& segment = document.segments[piece++];
            EXPECT_EQ(segment.action, static_cast<int>(i));
            EXPECT_EQ(segment.kind, wanted.kind);
            EXPECT_EQ(segment.start, time);
            EXPECT_EQ(segment.attach.has_value(), wanted.attach.has_value());
            EXPECT_EQ(segment.detach.has_value(), wanted.detach.has_value());
            if (wanted.path.size() > 1) {
                EXPECT_EQ(segment.knots.front().positions, wanted.path.front());
                EXPECT_EQ(segment.knots.back().positions, wanted.path.back());
            }
            time = segment.end;
        }
    }
    EXPECT_EQ(piece, document.segments.size());
    EXPECT_EQ(planned.fault(document), "");
}

TEST_F(ScheduleTest, LessSpeedTakesLonger) {
    double before = 0;
    for (const double speed : {1.0, 0.5, 0.2}) {
        const TrajectoryDocument document = planned.schedule({.speed = speed, .acceleration = speed});
        EXPECT_GT(document.duration(), before) << speed;
        before = document.duration();
        EXPECT_LE(used(document, true), speed * (1 + 1e-9));
        EXPECT_LE(used(document, false), speed * (1 + 1e-9));
        EXPECT_GT(used(document, false), speed * 0.99);
        EXPECT_EQ(planned.fault(document), "") << speed;
    }
}

TEST_F(ScheduleTest, SpeedAndAccelerationAreSharesOfTheirOwn) {
    const double whole = planned.schedule().duration();
    const TrajectoryDocument slow = planned.schedule({.speed = 0.1});
    EXPECT_LE(used(slow, true), 0.1 * (1 + 1e-9));
    EXPECT_GT(used(slow, false), 0.9);
    EXPECT_GT(slow.duration(), whole);
    const TrajectoryDocument soft = planned.schedule({.acceleration = 0.1});
    EXPECT_LE(used(soft, false), 0.1 * (1 + 1e-9));
    EXPECT_GT(soft.duration(), whole);
}

TEST_F(ScheduleTest, CornersThatAreCutSaveTime) {
    const TrajectoryDocument exact = planned.schedule({.max_deviation = 0});
    EXPECT_GE(exact.duration(), planned.schedule().duration());
    EXPECT_EQ(planned.fault(exact), "");
}

TEST_F(ScheduleTest, SharesAreAboveZeroAndAtMostOne) {
    for (const double wrong : {0.0, -1.0, 1.5, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(planned.schedule({.speed = wrong}), std::invalid_argument) << wrong;
        EXPECT_THROW(planned.schedule({.acceleration = wrong}), std::invalid_argument) << wrong;
    }
}

TEST_F(ScheduleTest, NothingTakesNoTime) {
    planned.actions.clear();
    const TrajectoryDocument document = planned.schedule();
    EXPECT_EQ(document.duration(), 0);
    EXPECT_TRUE(document.segments.empty());
    EXPECT_EQ(document.bodies.size(), planned.problem.scene.world->size());
    planned.actions.push_back({.name = "think"});
    EXPECT_EQ(planned.schedule().plan.front().end, 0);
}

}  // namespace
}  // namespace praxis::tamp
