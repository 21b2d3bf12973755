// A scene that shows which atoms hold: bodies that stand where atoms say, drawers that are open if one says
// so.
//
// So a simulated world of any domain has pictures. The description is JSON; docs/perception.md has its
// members.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "belief/percept.hpp"
#include "belief/perception/render.hpp"

namespace praxis::belief {

class Settings;

struct DescribedBody {
    enum class Shape : std::uint8_t { cylinder, box, tray, drawer };
    /// It stands there if the atom holds.
    struct Place {
        std::optional<AtomName> atom;  ///< none: in any case
        Position base;
    };
    std::string name;
    Shape shape = Shape::box;
    Colour colour{};
    double half_x = 0, half_y = 0, height = 0;  ///< metres
    std::vector<Place> places;                  ///< the first that counts; if none does, it is not seen
    std::optional<AtomName> open;               ///< of a drawer
};

struct SceneDescription {
    Colour background{};
    std::vector<DescribedBody> bodies;
    std::vector<SceneCamera> cameras;
    double noise = 0;  ///< as for `add_noise`
};

/// Throws PerceptionError, naming the place.
SceneDescription read_scene(Settings settings);

/// The scene if exactly those atoms hold of which `holds` says so.
Scene scene_of(const SceneDescription& description, const std::function<bool(const AtomName&)>& holds);

}  // namespace praxis::belief
