// What is read, but cannot be planned for, is refused with its place, not passed over.
#include <gtest/gtest.h>

#include <string>

#include "belief/belief_task.hpp"

namespace praxis::belief {
namespace {

std::string refusal(const std::string& domain, const std::string& problem) {
    try {
        ground_belief(parse_contingent({"d.pddl", domain}, {"p.pddl", problem}).task);
    } catch (const UnsupportedError& error) {
        return error.what();
    }
    return "";
}

constexpr const char* kProblem = "(define (problem p) (:domain d) (:init (unknown (q))) (:goal (r)))";

TEST(Refuse, SensingModels) {
    EXPECT_NE(refusal("(define (domain d) (:predicates (q) (r) (o)) (:variable v (q)) (:obs-variable w (o))"
                      "(:action a :parameters () :precondition (q) :effect (r))"
                      "(:action b :parameters () :sensing-model (when (q) (o))))",
                      kProblem)
                  .find("sensing models"),
              std::string::npos);
}

TEST(Refuse, NothingOfAnOrdinaryTask) {
    EXPECT_EQ(refusal("(define (domain d) (:predicates (q) (r))"
                      "(:action a :parameters () :precondition (q) :effect (r))"
                      "(:action b :parameters () :observe (q)))",
                      kProblem),
              "");
}

}  // namespace
}  // namespace praxis::belief
