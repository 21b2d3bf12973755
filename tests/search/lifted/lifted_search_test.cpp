// Plans of the lifted search, checked by the independent validator, and proofs that there is none.
#include "search/lifted/lifted_search.hpp"

#include <gtest/gtest.h>

#include "search/validate.hpp"
#include "tests/search/ground/texts.hpp"

namespace praxis {
namespace {

TEST(LiftedSearch, PlansWithoutActions) {
    const Task task = test::task_of("(:predicates (p ?x - thing))", "(p a)", "(p a)");
    const LiftedOutcome outcome = lifted_search(*task);
    ASSERT_EQ(outcome.status, Status::solved);
    EXPECT_TRUE(outcome.plan->steps.empty());
}

}  // namespace
}  // namespace praxis
