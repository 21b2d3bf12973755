// Gives a scene to the streams of a task: which callbacks there are, and which values the problem's objects
// have.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "parser/streams.hpp"
#include "tamp/manipulation/manipulator.hpp"
#include "tamp/solve/scene_options.hpp"
#include "tamp/streams/stream.hpp"

namespace praxis::tamp {

struct BoundScene {
    std::shared_ptr<const Manipulator> manipulator;
    /// The built-in streams; more may be bound to it (docs/tamp.md has an example).
    StreamLibrary library;
    /// Of the problem's objects: the scene's poses by their names, and for each initial atom `(at BODY POSE)`
    /// where the body stands in the scene; for `(at-configuration Q)` where the robot starts.
    std::map<std::string, Value, std::less<>> values;
};

/// Throws InputError where the scene does not suit the task: a body that `(at ...)` speaks of is not in it,
/// or stands at another pose than the one of that name; the hand is not empty or its fingers are not open at
/// the start; the start is in collision (`check_scene`).
BoundScene bind_scene(const StreamTask& task, const Scene& scene, const SceneOptions& options);

}  // namespace praxis::tamp
