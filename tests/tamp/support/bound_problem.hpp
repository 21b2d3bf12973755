// A generated problem with its streams bound, ready for `refine`.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "parser/files.hpp"
#include "parser/streams.hpp"
#include "tamp/manipulation/stacking_stream.hpp"
#include "tamp/problems/generate.hpp"
#include "tamp/refine/refine.hpp"
#include "tamp/scenes/scene_file.hpp"

namespace praxis::tamp {

struct BoundProblem {
    Scene scene;
    StreamTask task;
    StreamLibrary library;
    std::map<std::string, Value, std::less<>> values;

    /// `folder` is where the scene's other files are looked for.
    explicit BoundProblem(const GeneratedProblem& problem, const std::string& folder = {}) {
        scene = parse_scene({(std::filesystem::path(folder) / "scene.yaml").string(), problem.scene});
        const std::string domain = PRAXIS_SOURCE_DIR "/domains/tamp/" + problem.domain;
        task = parse_streams(read_source(domain + "/domain.pddl"), {"problem.pddl", problem.problem},
                             read_source(domain + "/streams.pddl"))
                   .task;
        const auto places = std::make_shared<PickPlaceScene>();
        places->world = *scene.world;
        places->bodies = scene.objects;
        places->areas = areas_of(scene);
        const std::string base = scene.robot->find_group("base") >= 0 ? "base" : "";
        bind_pick_place(library, places,
                        std::make_shared<const Manipulator>(scene.robot, scene.start, "", base));
        bind_stacking(library, places);
        for (const auto& [name, pose] : scene.poses) values[name] = Value::of(pose);
        const LiftedTask& lifted = *task.task;
        for (std::size_t i = 0; i < lifted.predicates.size(); ++i) {
            if (lifted.predicates[i].name != "at") continue;
            const Relation& standing = lifted.initial_atoms[i];
            for (std::size_t k = 0; k < standing.count; ++k) {
                const auto name = [&](std::size_t argument) {
                    return lifted.objects[standing.tuple(k)[argument].index()].name;
                };
                values[name(1)] = Value::of((*scene.world)[scene.objects.at(name(0))].pose);
            }
        }
    }

    Refinement refine(const Budget& budget, const RefineOptions& options = {}) const {
        return tamp::refine({.task = &task, .library = &library, .values = values, .options = options},
                            budget);
    }
};

}  // namespace praxis::tamp
