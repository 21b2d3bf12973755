#include "tamp/robots/builtin.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "tamp/robots/limits.hpp"
#include "tamp/robots/model_texts.hpp"
#include "tamp/robots/mount.hpp"
#include "tamp/robots/read_robot.hpp"

namespace praxis::tamp {

namespace {

Robot make_model(const std::string& name, const char* urdf, const char* srdf, const char* limits,
                 const CoverOptions& cover) {
    const RobotOptions options{.limits = parse_limits({name + ".yaml", limits}), .cover = cover};
    return parse_robot({name + ".urdf", urdf}, {name + ".srdf", srdf}, options);
}

Robot make_arm(const CoverOptions& cover) {
    return make_model("arm7", models::kArmUrdf, models::kArmSrdf, models::kArmLimits, cover);
}

/// Moves what two groups move; its tip is that of the second.
void join_groups(Robot& robot, const std::string& name, const Group& first, const Group& second) {
    Group both{.name = name, .variables = first.variables, .tip = second.tip};
    both.variables.insert(both.variables.end(), second.variables.begin(), second.variables.end());
    robot.groups.push_back(std::move(both));
}

Robot make_mobile_arm(const CoverOptions& cover) {
    Robot robot =
        make_model("platform", models::kPlatformUrdf, models::kPlatformSrdf, models::kPlatformLimits, cover);
    robot.name = "mobile-arm7";
    mount(robot, make_arm(cover), robot.find_link("mount"), Pose::Identity());
    const Group base = robot.groups[static_cast<std::size_t>(robot.find_group("base"))];
    const Group arm = robot.groups[static_cast<std::size_t>(robot.find_group("arm"))];
    join_groups(robot, "base_arm", base, arm);
    std::vector<NamedState> states;
    for (const NamedState& state : robot.states) {
        if (state.group != arm.name) continue;
        NamedState both{state.name, "base_arm", Configuration(base.variables.size())};
        both.positions.insert(both.positions.end(), state.positions.begin(), state.positions.end());
        states.push_back(std::move(both));
    }
    robot.states.insert(robot.states.end(), states.begin(), states.end());
    // The column carries the arm's foot, and its shoulder turns above it.
    for (const char* link : {"link0", "link1", "link2"}) {
        robot.allowed_collisions.emplace_back(robot.find_link("platform"), robot.find_link(link));
    }
    std::ranges::sort(robot.allowed_collisions);
    check_robot(robot);
    return robot;
}

using Maker = Robot (*)(const CoverOptions&);
constexpr std::array<std::pair<std::string_view, Maker>, 2> kRobots = {
    {{"arm7", make_arm}, {"mobile-arm7", make_mobile_arm}}};

}  // namespace

std::vector<std::string> builtin_robot_names() {
    std::vector<std::string> names;
    for (const auto& [name, make] : kRobots) names.emplace_back(name);
    return names;
}

Robot builtin_robot(std::string_view wanted, const CoverOptions& cover) {
    std::string names;
    for (const auto& [name, make] : kRobots) {
        if (name == wanted) return make(cover);
        names += (names.empty() ? "" : ", ") + std::string(name);
    }
    throw std::invalid_argument("there is no robot '" + std::string(wanted) + "'; there are " + names);
}

}  // namespace praxis::tamp
