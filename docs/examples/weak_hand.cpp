// weak_hand FOLDER: an arm that can lift only what is light, by a stream of its own; prints the plan.
#include <iostream>
#include <map>
#include <tamp/solve/solve.hpp>

using namespace praxis::tamp;

int main(int argc, char** argv) try {
    const std::string folder = argc > 1 ? argv[1] : "docs/examples/weak-hand";
    const std::map<std::string, double, std::less<>> kilograms = {{"can1", 0.4}, {"can2", 7.5}};
    SolveCallbacks callbacks;
    callbacks.bind = [&](StreamLibrary& library, const Scene&) {
        library.bind("test-liftable", [&](StreamCall& call) {
            if (kilograms.at(call.inputs[0].name()) <= 3) return StreamResult::pass();
            return StreamResult::reject({.message = "'" + call.inputs[0].name() + "' is too heavy"});
        });
    };
    const SceneProblem problem =
        load_scene_problem(folder + "/domain.pddl", folder + "/problem.pddl", "", folder + "/scene.yaml");
    praxis::Budget budget;
    budget.limit_wall_time(20);
    const Solution solution = solve(problem, {}, budget, callbacks);
    const Refinement& found = solution.refinement;
    for (const std::string& reason : found.reasons) std::cerr << reason << '\n';
    if (!found.plan) return 12;
    for (std::size_t i = 0; i < found.plan->steps.size(); ++i) std::cout << found.plan->action(i) << '\n';
} catch (const praxis::InputError& error) {
    std::cerr << error.what();
    return 31;
}
