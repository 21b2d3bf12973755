#include "belief/perception/render.hpp"

#include <algorithm>
#include <cmath>

namespace praxis::belief {
namespace {

/// The face that a body shows to a camera: its middle in the world, half its extents along the image's axes.
struct Face {
    Position middle;
    double half_u = 0, half_v = 0;
    bool round = false;
};

Face face_of(const Body& body, SceneCamera::Side side) {
    if (side == SceneCamera::Side::above) {
        return {{body.base.x, body.base.y, body.base.z + body.height},
                body.half_x,
                body.half_y,
                body.shape == Body::Shape::cylinder};
    }
    return {{body.base.x, body.base.y - body.half_y, body.base.z + body.height / 2},
            body.half_x,
            body.height / 2,
            false};
}

/// The whole numbers from 0 to size - 1 that are within `half` of `middle`: first and one past the last.
std::pair<std::size_t, std::size_t> pixels(double middle, double half, std::size_t size) {
    const double last = static_cast<double>(size);
    const double begin = std::clamp(std::ceil(middle - half), 0.0, last);
    const double end = std::clamp(std::floor(middle + half) + 1, begin, last);
    return {static_cast<std::size_t>(begin), static_cast<std::size_t>(end)};
}

void draw(const Body& body, const SceneCamera& camera, Rendering& rendering) {
    const Face face = face_of(body, camera.side);
    const auto middle = camera.camera.project(face.middle);
    if (!middle) return;
    // Both kinds of camera look along an axis of the world, so that all of a face has the same depth.
    const Position& eye = camera.camera.pose.translation;
    const double depth =
        camera.side == SceneCamera::Side::above ? eye.z - face.middle.z : face.middle.y - eye.y;
    const double half_u = face.half_u * camera.camera.pinhole.fx / depth;
    const double half_v = face.half_v * camera.camera.pinhole.fy / depth;
    if (!(half_u > 0) || !(half_v > 0)) return;
    const auto [left, right] = pixels((*middle)[0], half_u, camera.width);
    const auto [top, bottom] = pixels((*middle)[1], half_v, camera.height);
    const auto metres = static_cast<float>(depth);
    for (std::size_t row = top; row < bottom; ++row) {
        for (std::size_t column = left; column < right; ++column) {
            const double u = (static_cast<double>(column) - (*middle)[0]) / half_u;
            const double v = (static_cast<double>(row) - (*middle)[1]) / half_v;
            if (face.round && u * u + v * v > 1) continue;
            float& nearest = rendering.depth.metres[row * camera.width + column];
            if (nearest > 0 && nearest <= metres) continue;
            nearest = metres;
            rendering.image.set(column, row, body.colour);
        }
    }
}

SceneCamera camera_of(std::string name, SceneCamera::Side side, double distance, double visible,
                      std::size_t width, std::size_t height) {
    SceneCamera camera;
    camera.name = std::move(name);
    camera.side = side;
    camera.width = width;
    camera.height = height;
    const double focal = distance * static_cast<double>(width) / visible;
    camera.camera.pinhole = {focal, focal, static_cast<double>(width - 1) / 2,
                             static_cast<double>(height - 1) / 2};
    return camera;
}

Colour darker(Colour colour) {
    for (auto& channel : colour) channel = static_cast<std::uint8_t>(channel / 2);
    return colour;
}

}  // namespace

void add_tray(Scene& scene, const std::string& name, Colour colour, Position base, double half_x,
              double half_y, double height) {
    const double wall = 0.1;
    const auto box = [&](double x, double y, double half_width, double half_depth, double top, Colour c) {
        scene.bodies.push_back(
            {name, Body::Shape::box, c, {base.x + x, base.y + y, base.z}, half_width, half_depth, top});
    };
    box(0, 0, half_x, half_y, height * wall, darker(colour));
    for (const double side : {-1.0, 1.0}) {
        box(side * half_x * (1 - wall), 0, half_x * wall, half_y, height, colour);
        box(0, side * half_y * (1 - wall), half_x, half_y * wall, height, colour);
    }
}

void add_drawer(Scene& scene, const std::string& name, Colour colour, Position base, double half_x,
                double half_y, double height, bool open) {
    add_tray(scene, name, colour, base, half_x, half_y, height);
    const double shift = open ? 2 * half_y : 0;
    scene.bodies.push_back({name,
                            Body::Shape::box,
                            colour,
                            {base.x, base.y - shift, base.z + height},
                            half_x,
                            half_y,
                            height * 0.05});
}

SceneCamera camera_above(std::string name, Position centre, double distance, double visible,
                         std::size_t width, std::size_t height) {
    SceneCamera camera =
        camera_of(std::move(name), SceneCamera::Side::above, distance, visible, width, height);
    camera.camera.pose.rotation = {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    camera.camera.pose.translation = {centre.x, centre.y, centre.z + distance};
    return camera;
}

SceneCamera camera_in_front(std::string name, Position centre, double distance, double visible,
                            std::size_t width, std::size_t height) {
    SceneCamera camera =
        camera_of(std::move(name), SceneCamera::Side::front, distance, visible, width, height);
    camera.camera.pose.rotation = {{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}};
    camera.camera.pose.translation = {centre.x, centre.y - distance, centre.z};
    return camera;
}

Rendering render(const Scene& scene, const SceneCamera& camera) {
    Rendering rendering{Image(camera.width, camera.height, scene.background),
                        {camera.width, camera.height, std::vector<float>(camera.width * camera.height, 0)}};
    for (const Body& body : scene.bodies) draw(body, camera, rendering);
    return rendering;
}

void add_noise(Image& image, double deviation, std::mt19937_64& random) {
    std::normal_distribution<double> noise(0, deviation);
    for (auto& channel : image.rgb) {
        channel = static_cast<std::uint8_t>(std::clamp(std::lround(channel + noise(random)), 0L, 255L));
    }
}

std::vector<View> SceneSource::look(std::stop_token stop) {
    const Scene scene = scene_();
    std::vector<View> views;
    for (const SceneCamera& camera : cameras_) {
        if (stop.stop_requested()) throw StoppedError();
        Rendering rendering = render(scene, camera);
        if (noise_ > 0) add_noise(rendering.image, noise_, random_);
        View& view = views.emplace_back(View{camera.name, encode_png(rendering.image), camera.camera});
        view.depth->depth = std::move(rendering.depth);
    }
    return views;
}

}  // namespace praxis::belief
