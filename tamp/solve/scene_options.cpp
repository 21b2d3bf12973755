#include "tamp/solve/scene_options.hpp"

#include <cmath>
#include <cstdlib>
#include <functional>

#include "parser/files.hpp"
#include "parser/suggest.hpp"

namespace praxis::tamp {
namespace {

class Options {
  public:
    explicit Options(const Scene& scene) : scene_(scene) {
        if (scene.robot->find_group("base") >= 0) result_.base = "base";
        ManipulatorOptions& skills = result_.manipulator;
        GraspOptions& grasps = result_.grasps;
        text("effector", [this](const std::string& value) { set_effector(value); });
        text("base", [this](const std::string& value) { set_base(value); });
        metres("approach", skills.approach);
        metres("lift", skills.lift);
        count("arm_configurations", skills.arm_configurations);
        count("base_poses", skills.base_poses);
        metres("base_nearest", skills.base_nearest);
        metres("base_furthest", skills.base_furthest);
        metres("plan_time", skills.plan_time);
        count("grasp_turns", grasps.turns);
        count("grasp_places", grasps.places);
        metres("grasp_depth", grasps.depth);
        metres("grasp_clearance", grasps.clearance);
        count("placements", result_.placements.count);
        metres("placement_margin", result_.placements.margin);
    }

    SceneOptions read() {
        for (const auto& [name, value] : scene_.stream_options) {
            const auto reader = readers_.find(name);
            if (reader == readers_.end()) refuse_name(name);
            reader->second(value);
        }
        const ManipulatorOptions& skills = result_.manipulator;
        if (skills.base_nearest > skills.base_furthest)
            fail("base_nearest", "at most 'base_furthest' (" + std::to_string(skills.base_furthest) + ")",
                 std::to_string(skills.base_nearest));
        return std::move(result_);
    }

  private:
    using Reader = std::function<void(const std::string&)>;

    void text(const std::string& name, Reader reader) { readers_.emplace(name, std::move(reader)); }

    void metres(const std::string& name, double& target) {
        text(name, [name, &target](const std::string& value) { target = number(name, value, 100); });
    }

    template <class Count>
    void count(const std::string& name, Count& target) {
        text(name, [name, &target](const std::string& value) {
            const double read = number(name, value, 100'000);
            if (read != std::floor(read) || read < 1) fail(name, "a whole number, 1 or more", value);
            target = static_cast<Count>(read);
        });
    }

    static double number(const std::string& name, const std::string& value, double most) {
        char* end = nullptr;
        const double read = std::strtod(value.c_str(), &end);
        if (end == value.c_str() || *end != '\0' || !(read >= 0 && read <= most))
            fail(name, "a number from 0 to " + std::to_string(static_cast<int>(most)), value);
        return read;
    }

    void set_effector(const std::string& value) {
        if (scene_.robot->find_end_effector(value) < 0)
            fail("effector", "the name of an end effector of robot " + quote(scene_.robot->name), value);
        result_.effector = value;
    }

    void set_base(const std::string& value) {
        if (value != "none" && scene_.robot->find_group(value) < 0)
            fail("base", "a group of robot " + quote(scene_.robot->name) + ", or none", value);
        result_.base = value == "none" ? "" : value;
    }

    [[noreturn]] static void fail(const std::string& name, const std::string& wanted,
                                  const std::string& value) {
        fail_unplaced("stream option " + quote(name) + " must be " + wanted + ", not " + quote(value));
    }

    [[noreturn]] void refuse_name(const std::string& name) const {
        Suggestion suggestion(name);
        for (const auto& [known, reader] : readers_) suggestion.consider(known);
        fail_unplaced("there is no stream option " + quote(name) +
                      (suggestion.found() ? "; " + suggestion.hint() : "; see docs/tamp.md"));
    }

    const Scene& scene_;
    SceneOptions result_;
    std::map<std::string, Reader> readers_;
};

}  // namespace

SceneOptions scene_options(const Scene& scene) {
    return Options(scene).read();
}

}  // namespace praxis::tamp
