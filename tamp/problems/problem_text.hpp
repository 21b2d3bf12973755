// Puts a problem and its scene together, element by element; both are text in the order of the calls.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tamp/problems/generate.hpp"

namespace praxis::tamp {

using Place = std::array<double, 2>;
using Size3 = std::array<double, 3>;

namespace colors {
inline constexpr std::array<double, 3> kWood = {0.72, 0.58, 0.42};
inline constexpr std::array<double, 3> kWall = {0.8, 0.8, 0.78};
inline constexpr std::array<double, 3> kGrey = {0.55, 0.57, 0.6};
inline constexpr std::array<double, 3> kRed = {0.85, 0.2, 0.18};
inline constexpr std::array<double, 3> kGreen = {0.25, 0.65, 0.3};
inline constexpr std::array<double, 3> kBlue = {0.2, 0.4, 0.8};
inline constexpr std::array<double, 3> kYellow = {0.92, 0.75, 0.2};
}  // namespace colors

/// YAML of a shape.
std::string box_text(const Size3& size);
std::string cylinder_text(double radius, double length);

/// A body that can be moved: `object - body`, graspable, at its pose `p-NAME`.
struct Thing {
    std::string name = {};
    std::string shape = {};    ///< YAML, "box: [...]"
    std::string surface = {};  ///< on which it stands at `place` of the surface's frame
    Place place = {};
    double yaw = 0;
    /// Instead: it stands in the world at this pose of `add_pose`.
    std::optional<std::pair<std::string, Size3>> pose = {};
    std::array<double, 3> color = colors::kGrey;
    std::string grasps = {};  ///< YAML list, "[side]"; empty: all kinds
};

class ProblemText {
  public:
    /// `domain` is the name of the domain and of its folder; `start` is YAML of the robot's start.
    ProblemText(std::string domain, std::string name, std::string comment, const std::string& robot = "arm7",
                const std::string& start = "{arm: ready, gripper: open}");

    void add_box(const std::string& name, const Size3& size, const Size3& center,
                 const std::array<double, 3>& color = colors::kWood);
    void add_cylinder(const std::string& name, double radius, double length, const Size3& center,
                      const std::array<double, 3>& color = colors::kWood);
    /// A fixed body at the origin, its shape in YAML.
    void add_fixed(const std::string& name, const std::string& shape);
    /// The top of a body, by the body's name.
    void add_top(const std::string& body);
    /// The top of a body under another name.
    void add_top(const std::string& surface, const std::string& body);
    /// A floor in the world.
    void add_floor(const std::string& name, const Size3& center, const Place& size);
    /// Also an object of type region, unless a type is given (none: "").
    void add_region(const std::string& name, const std::string& surface, const Place& center,
                    const Place& size, const std::string& type = "region");
    void add_thing(const Thing& thing, const std::string& type = "body");
    /// A pose in the world that the task knows by name; also an object of type pose.
    void add_pose(const std::string& name, const Size3& position);
    void allow_contact(const std::string& first, const std::string& second);
    void add_file(const std::string& name, std::string bytes) { result_.files[name] = std::move(bytes); }
    void add_stream_option(const std::string& key, const std::string& value);

    void add_object(const std::string& name, const std::string& type);
    void add_fact(const std::string& fact) { facts_.push_back(fact); }
    void add_goal(const std::string& goal) { goals_.push_back(goal); }

    GeneratedProblem finish() &&;

  private:
    std::string domain_, name_, comment_, robot_;
    std::string bodies_, surfaces_, regions_, poses_, contacts_, options_;
    std::vector<std::pair<std::string, std::vector<std::string>>> objects_;  ///< names by type
    std::vector<std::string> facts_, goals_;
    GeneratedProblem result_;
};

}  // namespace praxis::tamp
