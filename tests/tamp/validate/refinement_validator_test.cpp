// A valid refined plan and its document, one thing of them broken, and the refusal that names it.
#include "tamp/validate/refinement_validator.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tamp/report/replay.hpp"
#include "tamp/sampling/grasps.hpp"
#include "tests/tamp/support/solved_problem.hpp"

namespace praxis::tamp {
namespace {

using Segment = TrajectoryDocument::Segment;

class RefinementValidator : public testing::Test {
  protected:
    void refused(const std::string& part) const {
        const RefinementVerdict verdict =
            validate_refinement(solved.problem.task, plan, solved.problem.scene, document);
        EXPECT_FALSE(verdict.valid) << part;
        EXPECT_NE(verdict.reason.find(part), std::string::npos)
            << "'" << verdict.reason << "' for '" << part << "'";
    }
    /// Already by the symbolic part.
    void refused_symbolically(const std::string& part) const {
        const RefinementVerdict verdict = validate_symbolically(solved.problem.task, plan);
        EXPECT_FALSE(verdict.valid) << part;
        EXPECT_NE(verdict.reason.find(part), std::string::npos)
            << "'" << verdict.reason << "' for '" << part << "'";
        refused(part);
    }

    Segment& segment_that(const std::function<bool(const Segment&)>& wanted) {
        return *std::ranges::find_if(document.segments, wanted);
    }
    Segment& attaching() {
        return segment_that([](const Segment& segment) { return segment.attach.has_value(); });
    }
    Segment& detaching() {
        return segment_that([](const Segment& segment) { return segment.detach.has_value(); });
    }

    /// Another value wherever the plan and its facts have this name.
    void replace(const std::string& name, const Value& with) {
        const auto in = [&](std::vector<Value>& values) {
            for (Value& value : values)
                if (value.name() == name) value = with.named(name);
        };
        for (RefinedStep& step : plan.steps) in(step.arguments);
        for (StreamFact& fact : plan.facts) {
            in(fact.inputs);
            in(fact.outputs);
        }
    }

    /// The pose of the first body that is put down.
    const Value& placement() const { return plan.steps[1].arguments[1]; }
    static Value moved(const Value& pose, double metres) {
        Pose there = pose.get<Pose>();
        there.translation().x() += metres;
        return Value::of(there);
    }

    const SolvedProblem& solved = sorted_sticks();
    RefinedPlan plan = solved.plan();
    TrajectoryDocument document = solved.solution.document;
};

TEST_F(RefinementValidator, AcceptsWhatIsValid) {
    EXPECT_EQ(validate_symbolically(solved.problem.task, plan).reason, "");
    const RefinementVerdict verdict =
        validate_refinement(solved.problem.task, plan, solved.problem.scene, document);
    EXPECT_EQ(verdict.reason, "");
    EXPECT_TRUE(verdict.valid);
}

TEST_F(RefinementValidator, TheOrderOfFactsMeansNothing) {
    std::ranges::reverse(plan.facts);
    EXPECT_EQ(validate_symbolically(solved.problem.task, plan).reason, "");
}

TEST_F(RefinementValidator, EveryActionIsNeeded) {
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        plan.steps.erase(plan.steps.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_FALSE(validate_symbolically(solved.problem.task, plan).valid) << i;
        plan = solved.plan();
    }
    plan.steps.pop_back();
    refused_symbolically("goal");
}

TEST_F(RefinementValidator, RefusesActionsInAnotherOrder) {
    std::swap(plan.steps[0], plan.steps[1]);
    refused_symbolically("holding");
}

TEST_F(RefinementValidator, EveryFactIsNeeded) {
    ASSERT_GT(plan.facts.size(), 4U);
    for (std::size_t i = 0; i < plan.facts.size(); ++i) {
        plan.facts.erase(plan.facts.begin() + static_cast<std::ptrdiff_t>(i));
        const RefinementVerdict verdict = validate_symbolically(solved.problem.task, plan);
        EXPECT_FALSE(verdict.valid) << i;
        EXPECT_NE(verdict.reason, "") << i;
        plan = solved.plan();
    }
}

TEST_F(RefinementValidator, RefusesValuesThatNoStreamHasMade) {
    plan.steps[1].arguments[1] = plan.steps[1].arguments[1].named("#nowhere");
    refused_symbolically("action 'place' uses '#nowhere', which no stream has made");
}

TEST_F(RefinementValidator, RefusesOneNameForTwoValues) {
    plan.steps[1].arguments[1] = moved(placement(), 0).named(placement().name());
    refused_symbolically("'" + placement().name() + "' stands for two values");
}

TEST_F(RefinementValidator, RefusesActionsOfAnotherTask) {
    plan.steps[0].name = "fly";
    refused_symbolically("there is no action 'fly'");
}

TEST_F(RefinementValidator, RefusesArgumentsOfAnotherStep) {
    std::swap(plan.steps[0].arguments[0], plan.steps[2].arguments[0]);
    ASSERT_NE(plan.steps[0].arguments[0].name(), plan.steps[2].arguments[0].name());
    refused_symbolically("pick");
}

TEST_F(RefinementValidator, RefusesAPoseOutsideOfItsRegion) {
    replace(placement().name(), moved(placement(), 3));
    EXPECT_TRUE(validate_symbolically(solved.problem.task, plan).valid);
    refused("does not stand in");
}

TEST_F(RefinementValidator, RefusesAPoseAboveItsRegion) {
    Pose above = placement().get<Pose>();
    above.translation().z() += 0.01;
    replace(placement().name(), Value::of(above));
    refused("does not stand in");
}

TEST_F(RefinementValidator, RefusesAPoseWhereTheBodyIsNotPut) {
    const std::string name = placement().name();
    replace(name, moved(placement(), 2e-5));
    refused("is not at '" + name + "' after action 2");
    replace(name, moved(placement(), -2e-5 + 1e-6));
    EXPECT_EQ(validate_refinement(solved.problem.task, plan, solved.problem.scene, document).reason, "");
}

TEST_F(RefinementValidator, RefusesAnotherMeaningOfAPoseThatTheSceneNames) {
    const SolvedProblem& discs = moved_discs();
    RefinedPlan other = discs.plan();
    ASSERT_EQ(
        validate_refinement(discs.problem.task, other, discs.problem.scene, discs.solution.document).reason,
        "");
    const Value& pose = other.steps[1].arguments[1];
    ASSERT_TRUE(discs.problem.scene.poses.contains(pose.name()));
    plan = other;
    replace(pose.name(), moved(pose, 0.2));
    const RefinementVerdict verdict =
        validate_refinement(discs.problem.task, plan, discs.problem.scene, discs.solution.document);
    EXPECT_EQ(verdict.reason, "'" + pose.name() + "' is another pose in the scene");
}

TEST_F(RefinementValidator, RefusesBodiesThatEndElsewhere) {
    detaching().detach->pose[0] += 1e-4;
    refused("is not at '" + placement().name() + "' after action 2");
}

TEST_F(RefinementValidator, RefusesBodiesThatStartElsewhere) {
    const int body = document.find_body(attaching().attach->body);
    document.bodies[static_cast<std::size_t>(body)].pose[1] += 1e-4;
    refused("at the start");
}

TEST_F(RefinementValidator, RefusesHeldBodiesThatShouldStand) {
    detaching().detach.reset();
    refused("is held after action 2, but should stand");
}

TEST_F(RefinementValidator, RefusesStandingBodiesThatShouldBeHeld) {
    attaching().attach.reset();
    detaching().detach.reset();
    refused("is not held after action 1");
}

TEST_F(RefinementValidator, RefusesAnotherGrasp) {
    attaching().attach->pose[2] += 1e-4;
    refused("is not held by '" + plan.steps[0].arguments[2].name() + "' after action 1");
}

TEST_F(RefinementValidator, RefusesADocumentOfOtherActions) {
    document.plan[1].name = "drop";
    refused("action 2 of the document is not the plan's");
    document = solved.solution.document;
    document.plan[0].arguments[0] = "elephant";
    refused("action 1 of the document is not the plan's");
    document = solved.solution.document;
    document.plan[2].arguments.pop_back();
    refused("action 3 of the document is not the plan's");
    document = solved.solution.document;
    document.plan.push_back(document.plan.back());
    refused("another number of actions");
}

TEST_F(RefinementValidator, RefusesADocumentWithoutTheBody) {
    const std::string body = attaching().attach->body;
    const auto rename = [&](std::string& name) {
        if (name == body) name = "elephant";
    };
    rename(document.bodies[static_cast<std::size_t>(document.find_body(body))].name);
    for (Segment& segment : document.segments) {
        if (segment.attach) rename(segment.attach->body);
        if (segment.detach) rename(segment.detach->body);
    }
    document.attempts.clear();
    refused("the document has no body '" + body + "'");
}

TEST_F(RefinementValidator, ADocumentOutOfOrderIsWrongUse) {
    document.start.pop_back();
    EXPECT_THROW(validate_refinement(solved.problem.task, plan, solved.problem.scene, document),
                 std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
