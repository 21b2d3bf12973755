// Knowledge that lasts a number of actions (`:decay`).
#include <gtest/gtest.h>

#include <string>

#include "belief/agent.hpp"
#include "belief/simulated_world.hpp"
#include "tests/belief/texts.hpp"

namespace praxis::belief {
namespace {

std::string domain(int steps) {
    return "(define (domain d) (:predicates (open) (a) (b) (done)) (:decay open " + std::to_string(steps) +
           ") (:action look :parameters () :observe (open))"
           " (:action one :parameters () :effect (a)) (:action two :parameters () :precondition (a) :effect "
           "(b))"
           " (:action unlock :parameters () :effect (open))"
           " (:action go :parameters () :precondition (and (open) (b)) :effect (done)))";
}
constexpr const char* kProblem = "(define (problem p) (:domain d) (:init (open)) (:goal (done)))";

struct Loaded {
    explicit Loaded(int steps)
        : task(ground_belief(parse_contingent({"d", domain(steps)}, {"p", kProblem}).task).task),
          compilation(std::make_shared<const Compilation>(task)) {}
    std::uint32_t action(const std::string& name) const {
        for (std::uint32_t a = 0; a < task->operator_count(); ++a)
            if (task->physical->operator_names.words(a) == name) return a;
        ADD_FAILURE() << name;
        return 0;
    }
    Fact open() const {
        for (std::size_t v = 0; v < task->uncertain.size(); ++v)
            for (std::int32_t value : {0, 1})
                if (task->physical->fact_name({static_cast<std::int32_t>(v), value}) == "Atom open()")
                    return {static_cast<std::int32_t>(v), value};
        ADD_FAILURE();
        return {};
    }
    std::shared_ptr<const BeliefTask> task;
    std::shared_ptr<const Compilation> compilation;
};

TEST(Decay, KnowledgeLastsSoManyActions) {
    const Loaded loaded(2);
    Belief belief(loaded.compilation);
    EXPECT_TRUE(belief.knows(loaded.open()));
    belief.act(loaded.action("one"));
    belief.act(loaded.action("two"));
    EXPECT_TRUE(belief.knows(loaded.open()));
    belief.act(loaded.action("one"));
    EXPECT_EQ(belief.truth(loaded.open()), Truth::unknown);
}

TEST(Decay, ReadingsAndEffectsRenewIt) {
    const Loaded loaded(1);
    Belief belief(loaded.compilation);
    belief.act(loaded.action("one"));
    EXPECT_TRUE(belief.learn(loaded.open()));  // known still, and read again
    belief.act(loaded.action("two"));
    EXPECT_TRUE(belief.knows(loaded.open()));
    belief.act(loaded.action("one"));
    EXPECT_FALSE(belief.knows(loaded.open()));
    belief.act(loaded.action("unlock"));
    EXPECT_TRUE(belief.knows(loaded.open()));
}

TEST(Decay, TheLoopLooksAgain) {
    const Loaded loaded(1);
    const auto planner = std::make_shared<const KnowledgePlanner>(loaded.compilation);
    Belief belief(loaded.compilation);
    SimulatedWorld world(loaded.task, loaded.task->physical->initial_values);
    const RunResult result = Agent(planner).run(belief, world);
    EXPECT_EQ(result.status, RunStatus::reached);
    EXPECT_TRUE(world.goal_holds());
    EXPECT_EQ(result.actions.size(), 4u);  // one, two, a look or unlocking, go
}

}  // namespace
}  // namespace praxis::belief
