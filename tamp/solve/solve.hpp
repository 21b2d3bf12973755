// From files to checked motion: the whole of task and motion planning in one call.
//
//     SceneProblem problem = load_scene_problem("domain.pddl", "problem.pddl", "", "scene.yaml");
//     Solution solution = solve(problem);
//     if (solution.refinement.status == RefineStatus::solved) std::cout << to_json(solution.document);
//
// A solution is given out only after `validate/` has checked it: its actions lead to the goal, its motion is
// what they say, touches nothing, and keeps all limits.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "parser/streams.hpp"
#include "search/budget.hpp"
#include "tamp/refine/refine.hpp"
#include "tamp/report/trajectory_document.hpp"
#include "tamp/scenes/scene.hpp"
#include "tamp/solve/bind_scene.hpp"
#include "tamp/solve/schedule.hpp"
#include "tamp/validate/trajectory_validator.hpp"

namespace praxis::tamp {

struct SceneProblem {
    StreamTask task;
    Scene scene;
    std::vector<Diagnostic> warnings = {};
};

/// Reads the files; without one for streams it is `streams.pddl` beside the domain. Throws InputError or
/// UnsupportedError.
SceneProblem load_scene_problem(const std::string& domain_file, const std::string& problem_file,
                                const std::string& stream_file, const std::string& scene_file);

struct SolveOptions {
    RefineOptions refine = {};
    ScheduleOptions schedule = {};
    /// Go straight from one action to the next, not by way of the home configuration.
    bool join = true;
    /// Check the result (`validate/`). Off only for measuring.
    bool validate = true;
    TrajectoryCheck check = {};
};

/// What a phase of `solve` took, processor seconds of the calling thread, all tries together.
struct SolvePhase {
    std::string name = {};  ///< "bind", "refine", "join", "schedule", "validate"
    double seconds = 0;
};

struct Solution {
    Refinement refinement;
    /// Robot, scene and what was tried in vain; where solved, the plan and its motion, too.
    TrajectoryDocument document;
    std::size_t checked = 0;  ///< configurations that the validator looked at
    int refusals = 0;         ///< plans that the validators refused before this one was found
    std::vector<SolvePhase> phases = {};
};

struct SolveCallbacks {
    std::function<void(const char* phase)> on_phase = {};
    std::function<void(const RefineStatistics&)> on_progress = {};
    /// Binds streams of one's own, or others in place of the built-in ones.
    std::function<void(StreamLibrary&, const Scene&)> bind = {};
};

/// The validators refuse every plan that was found: a fault of Praxis.
class InvalidSolution : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

/// Throws InputError where scene and task do not go together (`bind_scene`), StreamError for streams that
/// break the rules, UnsupportedError as `ground` does, InvalidSolution.
Solution solve(const SceneProblem& problem, const SolveOptions& options = {}, const Budget& budget = {},
               const SolveCallbacks& callbacks = {});

}  // namespace praxis::tamp
