// Scenes out of YAML files; docs/scene-format.md describes them.
#pragma once

#include <string>

#include "parser/source.hpp"
#include "tamp/scenes/scene.hpp"

namespace praxis::tamp {

/// Files that the scene names are looked for beside it. Throws InputError with the place, the element and the
/// mend. Whether the start is free of collisions is for `check_scene` to say.
Scene read_scene(const std::string& file);

/// The same from text; other files are looked for beside the one that the source is named after.
Scene parse_scene(const Source& source);

}  // namespace praxis::tamp
