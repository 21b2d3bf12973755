// belief DOMAIN PROBLEM: acts in a simulated world until the goal is known to hold, and prints what was done.
#include <belief/agent.hpp>
#include <belief/check_run.hpp>
#include <belief/simulated_world.hpp>
#include <iostream>

using namespace praxis::belief;

int main(int argc, char** argv) try {
    if (argc != 3) return 31;
    praxis::Budget budget;
    budget.limit_wall_time(60);
    const auto source = praxis::load_contingent(argv[1], argv[2]).task;
    const std::shared_ptr<const BeliefTask> task = ground_belief(source, budget).task;
    if (!task) return 23;
    const auto compilation = std::make_shared<const Compilation>(task);
    const Agent agent(std::make_shared<const KnowledgePlanner>(compilation, budget));

    praxis::Random random(0);
    const auto first = sample_world(*task, random);  // what the agent must not see
    if (!first) return 12;
    SimulatedWorld world(task, *first);
    Belief belief(compilation);
    const RunResult run = agent.run(belief, world, budget, [&](const Event& event, const Belief& known) {
        if (event.kind == Event::Kind::executed)
            std::cout << task->physical->operator_name(praxis::OperatorId(event.action)) << "\n";
        else
            std::cout << "; " << event.text << (known.goal_known() ? " (the goal is known to hold)" : "")
                      << "\n";
    });
    return run.status == RunStatus::reached && check_run(*task, *first, run.actions).valid ? 0 : 12;
} catch (const praxis::InputError& error) {
    std::cerr << error.what();
    return 31;
}
