// A generated problem with its streams bound, ready for `refine`.
#pragma once

#include <string>

#include "tamp/refine/refine.hpp"
#include "tamp/solve/bind_scene.hpp"
#include "tests/tamp/support/generated_problem.hpp"

namespace praxis::tamp {

struct BoundProblem {
    Scene scene;
    StreamTask task;
    BoundScene streams;

    /// `folder` is where the scene's other files are looked for.
    explicit BoundProblem(const GeneratedProblem& problem, const std::string& folder = {}) {
        SceneProblem loaded = scene_problem(problem, folder);
        scene = std::move(loaded.scene);
        task = std::move(loaded.task);
        streams = bind_scene(task, scene, scene_options(scene));
    }

    Refinement refine(const Budget& budget, const RefineOptions& options = {}) const {
        return tamp::refine(
            {.task = &task, .library = &streams.library, .values = streams.values, .options = options},
            budget);
    }
};

}  // namespace praxis::tamp
