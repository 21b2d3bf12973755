// The domains of domains/belief: every problem can be read without a warning, written and read again, and is
// solved in sampled worlds, without an action that the world refuses.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "belief/agent.hpp"
#include "belief/check_run.hpp"
#include "belief/policies/run_policy.hpp"
#include "belief/simulated_world.hpp"

namespace praxis::belief {
namespace {

const std::filesystem::path kRoot = PRAXIS_SOURCE_DIR;
constexpr std::size_t kWorlds = 5;

/// "doors/two-walls" and so on.
std::vector<std::string> problem_names() {
    std::vector<std::string> names;
    for (const auto& domain : std::filesystem::directory_iterator(kRoot / "problems/belief"))
        for (const auto& problem : std::filesystem::directory_iterator(domain.path()))
            names.push_back(domain.path().filename().string() + "/" + problem.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

class OwnBeliefProblem : public testing::TestWithParam<std::string> {
  protected:
    static ContingentLoadResult load() {
        const std::filesystem::path name = GetParam();
        return load_contingent((kRoot / "domains/belief" / name.parent_path() / "domain.pddl").string(),
                               (kRoot / "problems/belief" / GetParam()).string() + ".pddl");
    }
};

TEST_P(OwnBeliefProblem, IsContingentAndReadWithoutWarnings) {
    const ContingentLoadResult source = load();
    for (const Diagnostic& warning : source.warnings)
        ADD_FAILURE() << to_string(warning, *source.task->task->sources);
    EXPECT_TRUE(source.task->contingent());
    const std::string domain = write_contingent_domain(*source.task);
    const std::string problem = write_contingent_problem(*source.task);
    const ContingentLoadResult again = parse_contingent({"domain", domain}, {"problem", problem});
    EXPECT_EQ(write_contingent_domain(*again.task), domain);
    EXPECT_EQ(write_contingent_problem(*again.task), problem);
}

TEST_P(OwnBeliefProblem, IsSolvedInSampledWorlds) {
    const std::shared_ptr<const BeliefTask> task = ground_belief(load().task).task;
    ASSERT_TRUE(task);
    const auto compilation = std::make_shared<const Compilation>(task);
    const Agent agent(std::make_shared<const KnowledgePlanner>(compilation));
    Random random(2026);
    for (std::size_t i = 0; i < kWorlds; ++i) {
        const std::optional<WorldState> first = sample_world(*task, random);
        ASSERT_TRUE(first);
        Belief belief(compilation);
        EXPECT_FALSE(belief.goal_known());
        SimulatedWorld world(task, *first, 0, i);
        const RunResult result = agent.run(belief, world);
        EXPECT_EQ(result.status, RunStatus::reached) << "world " << i << ": " << result.message;
        const Verdict verdict = check_run(*task, *first, result.actions, world.after_chance());
        EXPECT_TRUE(verdict.valid) << "world " << i << ": " << verdict.reason;
    }
}

TEST_P(OwnBeliefProblem, NothingIsLostByActingAtRandomFirst) {
    const std::shared_ptr<const BeliefTask> task = ground_belief(load().task).task;
    const auto compilation = std::make_shared<const Compilation>(task);
    PolicyContext context;
    context.planner = std::make_shared<const KnowledgePlanner>(compilation);
    Random random(1603);
    for (std::size_t i = 0; i < kWorlds; ++i) {
        Belief belief(compilation);
        SimulatedWorld world(task, sample_world(*task, random).value(), 0, i);
        context.seed = i;
        context.options.most_steps = 12;
        run_policy(*make_policy("random", context), context, belief, world);
        context.options.most_steps = 1000;
        const PolicyResult rest = run_policy(*make_policy("plan", context), context, belief, world);
        EXPECT_EQ(rest.run.status, RunStatus::reached) << "world " << i << ": " << rest.run.message;
        EXPECT_TRUE(world.goal_holds()) << "world " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Problems, OwnBeliefProblem, testing::ValuesIn(problem_names()),
                         [](const auto& problem) {
                             std::string name = problem.param;
                             std::replace_if(
                                 name.begin(), name.end(), [](char c) { return c == '-' || c == '/'; }, '_');
                             return name;
                         });

}  // namespace
}  // namespace praxis::belief
