// The example of docs/stream-language.md.
#include <gtest/gtest.h>

#include "tamp/refine/refine.hpp"

namespace praxis::tamp {
namespace {

constexpr const char* kDomain = R"(
(define (domain cups)
  (:requirements :typing)
  (:types cup shelf height)
  (:predicates (on ?s - shelf ?h - height) (reachable ?h - height)
               (in-hand ?c - cup) (at ?c - cup ?h - height) (stored ?c - cup ?s - shelf))
  (:action put :parameters (?c - cup ?s - shelf ?h - height)
    :precondition (and (in-hand ?c) (on ?s ?h) (reachable ?h))
    :effect (and (not (in-hand ?c)) (at ?c ?h) (stored ?c ?s))))
)";
constexpr const char* kStreams = R"(
(define (stream cups)
  (:stream sample-height :inputs (?s - shelf) :outputs (?h - height) :certified (on ?s ?h))
  (:stream test-reach :inputs (?s - shelf ?h - height) :domain (on ?s ?h) :certified (reachable ?h)))
)";

Refinement store(const std::string& shelf) {
    const StreamTask task =
        parse_streams({"cups.pddl", kDomain},
                      {"store.pddl",
                       "(define (problem store) (:domain cups) (:objects c - cup low high - shelf)"
                       "(:init (in-hand c)) (:goal (stored c " +
                           shelf + ")))"},
                      {"streams.pddl", kStreams})
            .task;
    StreamLibrary library;
    library.bind(
        "sample-height",
        [](StreamCall& call) {
            if (call.attempt == 10) return StreamResult::exhausted();
            return StreamResult::sample({Value::of(call.inputs[0].get<double>() + 0.05 * call.attempt)});
        },
        {.max_samples = 10});
    library.bind("test-reach", [](StreamCall& call) {
        if (call.inputs[1].get<double>() < 1.2) return StreamResult::pass();
        return StreamResult::reject({.reason = Reason::kinematics, .message = "too high"});
    });
    return refine({&task, &library, {{"low", Value::of(1.0)}, {"high", Value::of(2.0)}}, {}});
}

TEST(Manual, TheCupGoesOnTheLowShelf) {
    const Refinement low = store("low");
    ASSERT_EQ(low.status, RefineStatus::solved);
    EXPECT_EQ(low.plan->action(0), "(put c low #h3)");
    EXPECT_EQ(low.plan->steps[0].arguments[2].get<double>(), 1.0);
}

TEST(Manual, TheHighShelfIsTooHigh) {
    const Refinement high = store("high");
    EXPECT_EQ(high.status, RefineStatus::infeasible);
    EXPECT_EQ(high.attempts.front().message, "too high");
    ASSERT_FALSE(high.reasons.empty());
    EXPECT_EQ(high.reasons.front(), "(put c high #h-4): test-reach failed");
}

}  // namespace
}  // namespace praxis::tamp
