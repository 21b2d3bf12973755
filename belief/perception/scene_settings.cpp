#include "belief/perception/scene_settings.hpp"

#include <map>
#include <sstream>
#include <utility>

#include "belief/perception/settings.hpp"

namespace praxis::belief {
namespace {

constexpr double kFar = 1000;  ///< metres: nothing is farther away

Colour colour_of(Settings& settings, const std::string& member) {
    const std::vector<double> parts = settings.numbers(member, 3, 0, 255);
    Colour colour{};
    for (std::size_t i = 0; i < colour.size(); ++i) colour[i] = static_cast<std::uint8_t>(parts[i]);
    return colour;
}

Position position_of(Settings& settings, const std::string& member) {
    const std::vector<double> parts = settings.numbers(member, 3, -kFar, kFar);
    return {parts[0], parts[1], parts[2]};
}

/// "(inside cup1 drawer)".
AtomName atom_of(Settings& settings, const std::string& member) {
    const std::string text = settings.text(member);
    AtomName atom;
    const bool brackets = text.size() > 2 && text.front() == '(' && text.back() == ')';
    if (brackets) {
        std::istringstream words(text.substr(1, text.size() - 2));
        for (std::string word; words >> word;) atom.words.push_back(word);
    }
    if (atom.words.empty()) settings.fail(member, "must be an atom such as \"(open drawer1)\"");
    return atom;
}

DescribedBody::Shape shape_of(Settings& settings) {
    using Shape = DescribedBody::Shape;
    static const std::map<std::string, Shape> shapes = {
        {"cylinder", Shape::cylinder}, {"box", Shape::box}, {"tray", Shape::tray}, {"drawer", Shape::drawer}};
    const auto found = shapes.find(settings.text("shape"));
    if (found == shapes.end()) settings.fail("shape", "must be cylinder, box, tray or drawer");
    return found->second;
}

DescribedBody body_of(Settings settings) {
    DescribedBody body;
    body.name = settings.text("name");
    body.shape = shape_of(settings);
    body.colour = colour_of(settings, "colour");
    const std::vector<double> size = settings.numbers("size", 3, 1e-4, kFar);
    body.half_x = size[0] / 2;
    body.half_y = size[1] / 2;
    body.height = size[2];
    if (body.shape == DescribedBody::Shape::drawer && settings.has("open"))
        body.open = atom_of(settings, "open");
    if (settings.has("places")) {
        for (Settings& place : settings.objects("places")) {
            body.places.push_back({atom_of(place, "if"), position_of(place, "at")});
            place.finish();
        }
    } else {
        body.places.push_back({std::nullopt, position_of(settings, "at")});
    }
    settings.finish();
    return body;
}

SceneCamera camera_of(Settings settings) {
    const std::string name = settings.text("name");
    const std::string side = settings.text("side");
    if (side != "above" && side != "front") settings.fail("side", "must be above or front");
    const Position centre = position_of(settings, "centre");
    const double distance = settings.number("distance", 1e-3, kFar);
    const double visible = settings.number("visible", 1e-3, kFar);
    const auto width = static_cast<std::size_t>(settings.whole("width", 8, 4096, 320));
    const auto height = static_cast<std::size_t>(settings.whole("height", 8, 4096, 240));
    settings.finish();
    return side == "above" ? camera_above(name, centre, distance, visible, width, height)
                           : camera_in_front(name, centre, distance, visible, width, height);
}

const DescribedBody::Place* place_of(const DescribedBody& body,
                                     const std::function<bool(const AtomName&)>& holds) {
    for (const DescribedBody::Place& place : body.places)
        if (!place.atom || holds(*place.atom)) return &place;
    return nullptr;
}

}  // namespace

SceneDescription read_scene(Settings settings) {
    SceneDescription scene;
    scene.background = settings.has("background") ? colour_of(settings, "background") : Colour{40, 40, 40};
    scene.noise = settings.number("noise", 0, 255, 0);
    for (Settings& camera : settings.objects("cameras"))
        scene.cameras.push_back(camera_of(std::move(camera)));
    for (Settings& body : settings.objects("bodies")) scene.bodies.push_back(body_of(std::move(body)));
    settings.finish();
    return scene;
}

Scene scene_of(const SceneDescription& description, const std::function<bool(const AtomName&)>& holds) {
    Scene scene;
    scene.background = description.background;
    for (const DescribedBody& body : description.bodies) {
        const DescribedBody::Place* const place = place_of(body, holds);
        if (place == nullptr) continue;
        switch (body.shape) {
            case DescribedBody::Shape::tray:
                add_tray(scene, body.name, body.colour, place->base, body.half_x, body.half_y, body.height);
                break;
            case DescribedBody::Shape::drawer:
                add_drawer(scene, body.name, body.colour, place->base, body.half_x, body.half_y, body.height,
                           body.open && holds(*body.open));
                break;
            default:
                scene.bodies.push_back(
                    {body.name,
                     body.shape == DescribedBody::Shape::box ? Body::Shape::box : Body::Shape::cylinder,
                     body.colour, place->base, body.half_x, body.half_y, body.height});
        }
    }
    return scene;
}

}  // namespace praxis::belief
