// Goals that stay out of reach however much is sampled.
#include "tamp/refine/reachable.hpp"

#include <gtest/gtest.h>

#include "parser/streams.hpp"
#include "tamp/refine/refine.hpp"

namespace praxis::tamp {
namespace {

constexpr const char* kDomain = R"((define (domain shelves) (:requirements :typing :disjunctive-preconditions)
  (:types cup shelf spot)
  (:predicates (on ?s - shelf ?p - spot) (fits ?c - cup ?p - spot) (free ?c - cup) (put ?c - cup ?s - shelf))
  (:action store :parameters (?c - cup ?s - shelf ?p - spot)
    :precondition (and (free ?c) (on ?s ?p) (fits ?c ?p))
    :effect (and (not (free ?c)) (put ?c ?s))))
)";
constexpr const char* kStreams = R"((define (stream shelves)
  (:stream spots :inputs (?s - shelf) :outputs (?p - spot) :certified (on ?s ?p))
  (:stream fit :inputs (?c - cup ?s - shelf ?p - spot) :domain (on ?s ?p) :certified (fits ?c ?p))))";

/// Spots without cheap enumeration: the stream costs too much to make all of them.
Refinement solve(const std::string& goal, bool any_fits) {
    const StreamTask task =
        parse_streams({"domain.pddl", kDomain},
                      {"problem.pddl", "(define (problem p) (:domain shelves) (:objects a b - cup low high - shelf)"
                                       " (:init (free a) (free b)) (:goal " + goal + "))"},
                      {"streams.pddl", kStreams})
            .task;
    StreamLibrary library;
    library.bind(
        "spots",
        [](StreamCall& call) {
            if (call.attempt == 5) return StreamResult::exhausted();
            return StreamResult::sample({Value::of(static_cast<int>(call.attempt))});
        },
        {.effort = 1e4});
    library.bind("fit", [any_fits](StreamCall& call) {
        const bool fits = call.inputs[1].name() == "low" || (any_fits && call.inputs[2].get<int>() == 4);
        return fits ? StreamResult::pass() : StreamResult::reject({.message = "too tall"});
    });
    return refine({.task = &task, .library = &library});
}

TEST(Reachable, AnActionThatNeverWorksMakesItsGoalHopeless) {
    const Refinement found = solve("(and (put a low) (put b high))", false);
    EXPECT_EQ(found.status, RefineStatus::infeasible);
    EXPECT_FALSE(found.statistics.exact);
    ASSERT_FALSE(found.reasons.empty());
    EXPECT_NE(found.reasons[0].find("store b high"), std::string::npos) << found.reasons[0];
}

TEST(Reachable, AnActionThatWorksOnceDoesNot) {
    EXPECT_EQ(solve("(and (put a low) (put b high))", true).status, RefineStatus::solved);
}

TEST(Reachable, OtherWaysAreTaken) {
    EXPECT_EQ(solve("(or (put a high) (put b low))", false).status, RefineStatus::solved);
}

}  // namespace
}  // namespace praxis::tamp
