#include "tamp/problems/problem_text.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "tamp/text/number_text.hpp"

namespace praxis::tamp {

namespace {

/// Rounded to a tenth of a millimetre: short, and the same on every machine.
std::string number(double value) {
    const double rounded = std::round(value * 1e4) / 1e4;
    return shortest(rounded == 0 ? 0 : rounded);
}

std::string list(std::span<const double> values) {
    std::string text = "[";
    for (const double value : values) text += (text.size() > 1 ? ", " : "") + number(value);
    return text + "]";
}

std::string join(const std::vector<std::string>& items, const std::string& between) {
    std::string text;
    for (const std::string& item : items) text += (text.empty() ? "" : between) + item;
    return text;
}

void add_section(std::string& text, const std::string& key, const std::string& items) {
    if (!items.empty()) text += key + ":\n" + items;
}

std::string fixed_body(const std::string& name, const std::string& shape, const Size3& center,
                       const std::array<double, 3>& color) {
    return "  - {name: " + name + ", " + shape + ", pose: {xyz: " + list(center) +
           "}, color: " + list(color) + "}\n";
}

}  // namespace

std::string box_text(const Size3& size) {
    return "box: " + list(size);
}

std::string cylinder_text(double radius, double length) {
    return "cylinder: {radius: " + number(radius) + ", length: " + number(length) + "}";
}

ProblemText::ProblemText(std::string domain, std::string name, std::string comment, const std::string& robot,
                         const std::string& start)
    : domain_(std::move(domain)),
      name_(std::move(name)),
      comment_(std::move(comment)),
      robot_("robot: {builtin: " + robot + ", start: " + start + "}\n") {
    add_fact("(hand-empty)");
}

void ProblemText::add_box(const std::string& name, const Size3& size, const Size3& center,
                          const std::array<double, 3>& color) {
    bodies_ += fixed_body(name, box_text(size), center, color);
}

void ProblemText::add_cylinder(const std::string& name, double radius, double length, const Size3& center,
                               const std::array<double, 3>& color) {
    bodies_ += fixed_body(name, cylinder_text(radius, length), center, color);
}

void ProblemText::add_fixed(const std::string& name, const std::string& shape) {
    bodies_ += fixed_body(name, shape, {}, colors::kWall);
}

void ProblemText::add_top(const std::string& body) {
    add_top(body, body);
}

void ProblemText::add_top(const std::string& surface, const std::string& body) {
    surfaces_ += "  - {name: " + surface + ", body: " + body + "}\n";
}

void ProblemText::add_floor(const std::string& name, const Size3& center, const Place& size) {
    surfaces_ += "  - {name: " + name + ", pose: {xyz: " + list(center) + "}, size: " + list(size) + "}\n";
}

void ProblemText::add_region(const std::string& name, const std::string& surface, const Place& center,
                             const Place& size, const std::string& type) {
    regions_ += "  - {name: " + name + ", surface: " + surface + ", center: " + list(center) +
                ", size: " + list(size) + "}\n";
    if (!type.empty()) add_object(name, type);
}

void ProblemText::add_thing(const Thing& thing, const std::string& type) {
    bodies_ += "  - {name: " + thing.name + ", " + thing.shape + ", movable: true";
    if (thing.pose) {
        bodies_ += ", pose: {xyz: " + list(thing.pose->second) + "}";
    } else {
        bodies_ += ", on: " + thing.surface + ", at: " + list(thing.place);
    }
    if (thing.yaw != 0) bodies_ += ", yaw: " + number(thing.yaw);
    bodies_ += ", color: " + list(thing.color);
    if (!thing.grasps.empty()) bodies_ += ", grasps: " + thing.grasps;
    bodies_ += "}\n";
    add_object(thing.name, type);
    const std::string pose = thing.pose ? thing.pose->first : "p-" + thing.name;
    if (!thing.pose) add_object(pose, "pose");
    const std::string pair = thing.name + " " + pose;
    add_fact("(graspable " + thing.name + ") (pose-of " + pair + ") (at " + pair + ")");
}

void ProblemText::add_pose(const std::string& name, const Size3& position) {
    poses_ += "  - {name: " + name + ", pose: {xyz: " + list(position) + "}}\n";
    add_object(name, "pose");
}

void ProblemText::allow_contact(const std::string& first, const std::string& second) {
    contacts_ += "  - [" + first + ", " + second + "]\n";
}

void ProblemText::add_stream_option(const std::string& key, const std::string& value) {
    options_ += "  " + key + ": " + value + "\n";
}

void ProblemText::add_object(const std::string& name, const std::string& type) {
    auto group = std::ranges::find(objects_, type, &decltype(objects_)::value_type::first);
    if (group == objects_.end()) group = objects_.insert(group, {type, {}});
    group->second.push_back(name);
}

GeneratedProblem ProblemText::finish() && {
    result_.domain = domain_;
    std::vector<std::string> objects;
    for (const auto& [type, names] : objects_) objects.push_back(join(names, " ") + " - " + type);
    result_.problem = "; " + comment_ + "\n(define (problem " + name_ + ")\n  (:domain " + domain_ +
                      ")\n  (:objects " + join(objects, "\n            ") + ")\n  (:init " +
                      join(facts_, "\n         ") + ")\n  (:goal (and " + join(goals_, "\n              ") +
                      ")))\n";
    std::string& scene = result_.scene;
    scene = "# " + comment_ + "\n" + robot_;
    add_section(scene, "bodies", bodies_);
    add_section(scene, "surfaces", surfaces_);
    add_section(scene, "regions", regions_);
    add_section(scene, "poses", poses_);
    add_section(scene, "allowed_collisions", contacts_);
    add_section(scene, "stream_options", options_);
    return std::move(result_);
}

}  // namespace praxis::tamp
