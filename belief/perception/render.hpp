// A small software renderer: scenes of flat-coloured bodies, seen from above and from the side.
//
// It draws what a simulated robot's cameras would see, so that perception can be developed and tested on real
// pixels without a robot and without a service. Every body shows one face to each camera, parallel to the
// image, its upper side or its front; nearer faces hide farther ones (depth buffer), so that a lid hides what
// is in a box. The cameras are exact pinhole cameras and give depth images as well.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "belief/perception/image.hpp"
#include "belief/perception/vision_observer.hpp"

namespace praxis::belief {

/// A standing cylinder or box. Metres.
struct Body {
    enum class Shape : std::uint8_t { cylinder, box };
    std::string name;
    Shape shape = Shape::box;
    Colour colour{};
    Position base;                  ///< the middle of its lower side; z is up
    double half_x = 0, half_y = 0;  ///< half its extent; the radii of a cylinder
    double height = 0;
};

struct Scene {
    std::vector<Body> bodies;
    Colour background{40, 40, 40};
};

/// The lower part of a box that is open above: a floor and four walls of a tenth of its extent.
void add_tray(Scene& scene, const std::string& name, Colour colour, Position base, double half_x,
              double half_y, double height);

/// A tray with a sliding lid: shut, it hides what is inside from above and from the front; open, the lid is
/// pulled away towards the front.
void add_drawer(Scene& scene, const std::string& name, Colour colour, Position base, double half_x,
                double half_y, double height, bool open);

struct SceneCamera {
    enum class Side : std::uint8_t { above, front };
    std::string name;
    Side side = Side::above;
    DepthCamera camera;                     ///< its depth image is made by rendering
    std::size_t width = 160, height = 120;  ///< pixels
};

/// A camera above `centre`, looking down from `distance` metres, showing `visible` metres from left to right
/// at the height of `centre`. x of the world is to the right, y up.
SceneCamera camera_above(std::string name, Position centre, double distance, double visible,
                         std::size_t width = 160, std::size_t height = 120);

/// A camera in front of `centre` (at lower y), looking along y. x of the world is to the right, z up.
SceneCamera camera_in_front(std::string name, Position centre, double distance, double visible,
                            std::size_t width = 160, std::size_t height = 120);

struct Rendering {
    Image image;
    DepthImage depth;  ///< zero where nothing is seen
};

Rendering render(const Scene& scene, const SceneCamera& camera);

/// Adds normally distributed noise to every channel, of a standard deviation in steps of 1/255.
void add_noise(Image& image, double deviation, std::mt19937_64& random);

/// Renders the present scene whenever it is looked at.
class SceneSource : public ImageSource {
  public:
    /// `scene` is asked for the present state at each look. `noise` as for `add_noise`.
    SceneSource(std::function<Scene()> scene, std::vector<SceneCamera> cameras, double noise = 0,
                std::uint64_t seed = 0)
        : scene_(std::move(scene)), cameras_(std::move(cameras)), noise_(noise), random_(seed) {}

    std::vector<View> look(std::stop_token stop) override;

  private:
    std::function<Scene()> scene_;
    std::vector<SceneCamera> cameras_;
    double noise_;
    std::mt19937_64 random_;
};

}  // namespace praxis::belief
