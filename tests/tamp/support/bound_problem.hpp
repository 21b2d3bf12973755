// A generated problem with its streams bound, ready for `refine`.
#pragma once

#include <filesystem>
#include <string>

#include "parser/files.hpp"
#include "parser/streams.hpp"
#include "tamp/problems/generate.hpp"
#include "tamp/refine/refine.hpp"
#include "tamp/scenes/scene_file.hpp"
#include "tamp/solve/bind_scene.hpp"

namespace praxis::tamp {

struct BoundProblem {
    Scene scene;
    StreamTask task;
    BoundScene streams;

    /// `folder` is where the scene's other files are looked for.
    explicit BoundProblem(const GeneratedProblem& problem, const std::string& folder = {}) {
        scene = parse_scene({(std::filesystem::path(folder) / "scene.yaml").string(), problem.scene});
        const std::string domain = PRAXIS_SOURCE_DIR "/domains/tamp/" + problem.domain;
        task = parse_streams(read_source(domain + "/domain.pddl"), {"problem.pddl", problem.problem},
                             read_source(domain + "/streams.pddl"))
                   .task;
        streams = bind_scene(task, scene, scene_options(scene));
    }

    Refinement refine(const Budget& budget, const RefineOptions& options = {}) const {
        return tamp::refine(
            {.task = &task, .library = &streams.library, .values = streams.values, .options = options}, budget);
    }
};

}  // namespace praxis::tamp
