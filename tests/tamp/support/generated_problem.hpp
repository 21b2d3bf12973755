// A generated problem as `solve` takes it, without files for problem and scene.
#pragma once

#include <filesystem>
#include <string>

#include "parser/files.hpp"
#include "tamp/problems/generate.hpp"
#include "tamp/scenes/scene_file.hpp"
#include "tamp/solve/solve.hpp"

namespace praxis::tamp {

/// `folder` is where the scene's other files are looked for.
inline SceneProblem scene_problem(const GeneratedProblem& problem, const std::string& folder = {}) {
    const std::string domain = PRAXIS_SOURCE_DIR "/domains/tamp/" + problem.domain;
    StreamLoadResult loaded =
        parse_streams(read_source(domain + "/domain.pddl"), {"problem.pddl", problem.problem},
                      read_source(domain + "/streams.pddl"));
    return {std::move(loaded.task),
            parse_scene({(std::filesystem::path(folder) / "scene.yaml").string(), problem.scene}),
            std::move(loaded.warnings)};
}

}  // namespace praxis::tamp
