#include "tamp/robots/mount.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace praxis::tamp {

namespace {

template <class Items>
void require_new_names(const Items& items, const Items& more, const std::string& prefix) {
    std::set<std::string> names;
    for (const auto& item : items) names.insert(item.name);
    for (const auto& item : more) {
        if (!names.insert(prefix + item.name).second) {
            throw std::invalid_argument("both robots have the name '" + prefix + item.name +
                                        "'; mount one with a prefix");
        }
    }
}

}  // namespace

void mount(Robot& carrier, const Robot& carried, int link, const Pose& pose, const std::string& prefix) {
    if (link < 0 || static_cast<std::size_t>(link) >= carrier.links.size()) {
        throw std::invalid_argument("robot '" + carrier.name + "' has no link to mount on with number " +
                                    std::to_string(link));
    }
    require_new_names(carrier.links, carried.links, prefix);
    require_new_names(carrier.joints, carried.joints, prefix);
    require_new_names(carrier.groups, carried.groups, prefix);
    require_new_names(carrier.end_effectors, carried.end_effectors, prefix);
    Robot whole = carrier;
    const int links = static_cast<int>(carrier.links.size());
    const int joints = static_cast<int>(carrier.joints.size()) + 1;
    const int variables = static_cast<int>(carrier.variables.size());
    for (Link part : carried.links) {
        part.name = prefix + part.name;
        part.parent_joint = part.parent_joint < 0 ? joints - 1 : part.parent_joint + joints;
        whole.links.push_back(std::move(part));
    }
    whole.joints.push_back({.name = prefix + carried.links.front().name + "_mount",
                            .parent = link,
                            .child = links,
                            .origin = pose});
    for (Joint joint : carried.joints) {
        joint.name = prefix + joint.name;
        joint.parent += links;
        joint.child += links;
        joint.variable += joint.variable < 0 ? 0 : variables;
        whole.joints.push_back(std::move(joint));
    }
    for (Variable variable : carried.variables) {
        variable.name = prefix + variable.name;
        whole.variables.push_back(std::move(variable));
    }
    for (Group group : carried.groups) {
        group.name = prefix + group.name;
        for (int& variable : group.variables) variable += variables;
        group.tip += group.tip < 0 ? 0 : links;
        whole.groups.push_back(std::move(group));
    }
    for (EndEffector effector : carried.end_effectors) {
        effector.name = prefix + effector.name;
        effector.link += links;
        effector.arm = prefix + effector.arm;
        if (!effector.gripper.empty()) effector.gripper = prefix + effector.gripper;
        for (int& part : effector.links) part += links;
        whole.end_effectors.push_back(std::move(effector));
    }
    for (NamedState state : carried.states) {
        state.group = prefix + state.group;
        whole.states.push_back(std::move(state));
    }
    whole.allowed_collisions.emplace_back(link, links);
    for (const auto& [first, second] : carried.allowed_collisions) {
        whole.allowed_collisions.emplace_back(first + links, second + links);
    }
    std::ranges::sort(whole.allowed_collisions);
    check_robot(whole);
    carrier = std::move(whole);
}

}  // namespace praxis::tamp
