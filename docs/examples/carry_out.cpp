// carry_out FOLDER: plans for the arm that can lift only what is light, and carries the plan out with a hand
// that slips three times in ten. What fails is tried again.
#include <cstdio>
#include <iostream>
#include <tamp/skills/refined_skills.hpp>
#include <tamp/skills/simulated_driver.hpp>
#include <tamp/solve/solve.hpp>

using namespace praxis::tamp;

int main(int argc, char** argv) try {
    const std::string folder = argc > 1 ? argv[1] : "docs/examples/weak-hand";
    SolveCallbacks callbacks;
    callbacks.bind = [](StreamLibrary& library, const Scene&) {
        library.bind("test-liftable", [](StreamCall& call) {
            return call.inputs[0].name() == "can1" ? StreamResult::pass() : StreamResult::reject({});
        });
    };
    const SceneProblem problem =
        load_scene_problem(folder + "/domain.pddl", folder + "/problem.pddl", "", folder + "/scene.yaml");
    praxis::Budget budget;
    budget.limit_wall_time(20);
    const TrajectoryDocument document = solve(problem, {}, budget, callbacks).document;

    SimulatedDriver driver(document, {.noise = 0.001, .slip = 0.3, .seed = 4});
    RefinedSkills skills(planned(document), *problem.scene.robot, driver);
    for (const TrajectoryDocument::Action& action : document.plan) {
        praxis::ActionName name{{action.name}};
        name.words.insert(name.words.end(), action.arguments.begin(), action.arguments.end());
        praxis::Execution execution;
        do {
            execution = skills.execute(name, {}, {});
            std::printf("%6.2f s  (%s %s ...) %s\n", driver.seconds(), action.name.c_str(),
                        action.arguments[0].c_str(),
                        execution.message.empty() ? "done" : execution.message.c_str());
        } while (execution.status == praxis::Execution::Status::failed);
        if (execution.status == praxis::Execution::Status::illegal) return 1;
    }
    return document.plan.empty() ? 12 : 0;
} catch (const praxis::InputError& error) {
    std::cerr << error.what();
    return 31;
}
