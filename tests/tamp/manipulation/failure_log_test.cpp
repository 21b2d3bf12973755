#include "tamp/manipulation/failure_log.hpp"

#include <gtest/gtest.h>

namespace praxis::tamp {
namespace {

using Reason = TrajectoryDocument::Reason;

const ActionFailure kContact{.reason = Reason::collision, .message = "in collision"};
const ActionFailure kNoPath{.reason = Reason::no_path, .message = "no path", .definite = false};

TEST(FailureLog, WhatStopsEveryWayIsToBlameAlone) {
    FailureLog log("pick 'a'");
    log.add_blocked({3, 1}, kContact);
    log.add_blocked({2, 3, 1}, kContact);
    const ActionFailure failure = log.take();
    EXPECT_EQ(failure.bodies, (std::vector<int>{1, 3}));
    EXPECT_TRUE(failure.each);
    EXPECT_TRUE(failure.definite);
    EXPECT_EQ(failure.message, "cannot pick 'a': in collision");
}

TEST(FailureLog, FewBodiesExplainAllWays) {
    FailureLog log("pick 'a'");
    log.add_blocked({1, 2}, kContact);
    log.add_blocked({2, 3}, kContact);
    log.add_blocked({4}, kContact);
    const ActionFailure failure = log.take();
    EXPECT_EQ(failure.bodies, (std::vector<int>{2, 4}));
    EXPECT_FALSE(failure.each);
}

TEST(FailureLog, AFixedObstacleBlamesNobody) {
    FailureLog log("pick 'a'");
    log.add_fixed(kContact);
    const ActionFailure failure = log.take();
    EXPECT_TRUE(failure.bodies.empty());
    EXPECT_TRUE(failure.definite);
}

TEST(FailureLog, SuspectsAreBlamedTogetherAndNotForGood) {
    FailureLog log("pick 'a'");
    log.add_blocked({5, 6}, kContact);
    log.add_no_path({1, 6}, kNoPath);
    const ActionFailure failure = log.take();
    EXPECT_EQ(failure.bodies, (std::vector<int>{1, 6}));
    EXPECT_FALSE(failure.each);
    EXPECT_FALSE(failure.definite);
    EXPECT_EQ(failure.reason, Reason::no_path);
}

}  // namespace
}  // namespace praxis::tamp
