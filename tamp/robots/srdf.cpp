#include "tamp/robots/srdf.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "parser/suggest.hpp"
#include "tamp/robots/planar_base.hpp"
#include "tamp/robots/xml_file.hpp"

namespace praxis::tamp {

namespace {

using Element = tinyxml2::XMLElement;

/// What a group's element stands for.
struct Members {
    std::set<int> variables = {};
    std::set<int> links = {};
    int tip = -1;
};

class SrdfReader {
  public:
    SrdfReader(Robot& robot, const XmlFile& xml) : robot_(robot), xml_(xml) {}

    bool read() {
        for (const Element* joint : children(xml_.root(), "virtual_joint")) read_virtual_joint(*joint);
        const auto groups = children(xml_.root(), "group");
        for (const Element* group : groups) {
            const std::string name = xml_.attribute(*group, "name");
            if (!group_elements_.emplace(name, group).second) {
                xml_.fail(*group, "there is another group named " + quote(name), "names must differ");
            }
        }
        for (const Element* group : groups) add_group(*group);
        for (const Element* state : children(xml_.root(), "group_state")) read_state(*state);
        for (const Element* effector : children(xml_.root(), "end_effector")) read_end_effector(*effector);
        return read_collisions();
    }

  private:
    template <class Items>
    [[noreturn]] void fail_unknown(const Element& element, const char* kind, const std::string& name,
                                   const Items& items) const {
        Suggestion suggestion(name);
        for (const auto& item : items) suggestion.consider(item.name);
        xml_.fail(element, "unknown " + std::string(kind) + ' ' + quote(name), suggestion.hint());
    }

    int link(const Element& element, const char* attribute) const {
        const std::string name = xml_.attribute(element, attribute);
        const int link = robot_.find_link(name);
        if (link < 0) fail_unknown(element, "link", name, robot_.links);
        return link;
    }

    const Joint* find_joint(const std::string& name) const {
        const auto found = std::ranges::find(robot_.joints, name, &Joint::name);
        return found == robot_.joints.end() ? nullptr : &*found;
    }

    /// One, or the three of a planar joint.
    std::vector<const Joint*> joints(const Element& element) const {
        const std::string name = xml_.attribute(element, "name");
        if (const Joint* joint = find_joint(name)) return {joint};
        if (find_joint(name + "/theta") != nullptr) {
            return {find_joint(name + "/x"), find_joint(name + "/y"), find_joint(name + "/theta")};
        }
        // A virtual joint that is fixed has no joint in the tree.
        if (fixed_.contains(name)) return {};
        fail_unknown(element, "joint", name, robot_.joints);
    }

    const Joint* joint_above(int link) const {
        const int joint = robot_.links[static_cast<std::size_t>(link)].parent_joint;
        return joint < 0 ? nullptr : &robot_.joints[static_cast<std::size_t>(joint)];
    }

    void read_virtual_joint(const Element& element) {
        const std::string name = xml_.attribute(element, "name");
        const std::string type = xml_.attribute(element, "type");
        if (type == "fixed") {
            fixed_.insert(name);
            return;
        }
        if (type != "planar") {
            xml_.fail(element, "a virtual joint of type " + quote(type) + " is not supported",
                      "make it fixed or planar");
        }
        if (link(element, "child_link") != 0)
            xml_.fail(element, "a virtual joint must carry the robot's root link");
        try {
            add_planar_base(robot_, name, xml_.attribute(element, "parent_frame"));
        } catch (const std::invalid_argument& error) {
            xml_.fail(element, error.what());
        }
    }

    void add_joint(Members& members, const Joint& joint) const {
        members.links.insert(joint.child);
        // The joint that has the variable; mimics only share it.
        if (joint.variable >= 0 &&
            robot_.variables[static_cast<std::size_t>(joint.variable)].name == joint.name) {
            members.variables.insert(joint.variable);
        }
    }

    void add_chain(Members& members, const Element& chain) const {
        const int base = link(chain, "base_link");
        const int tip = link(chain, "tip_link");
        for (int at = tip; at != base; at = joint_above(at)->parent) {
            const Joint* joint = joint_above(at);
            if (joint == nullptr) {
                xml_.fail(chain, "link " + quote(xml_.attribute(chain, "tip_link")) + " is not below " +
                                     quote(xml_.attribute(chain, "base_link")));
            }
            add_joint(members, *joint);
        }
        members.tip = tip;
    }

    const Members& members(const Element& element) {
        const std::string name = xml_.attribute(element, "name");
        if (const auto known = members_.find(name); known != members_.end()) return known->second;
        if (!open_.insert(name).second)
            xml_.fail(element, "group " + quote(name) + " has itself as a subgroup");
        Members made;
        for (const Element* joint : children(element, "joint")) {
            for (const Joint* each : joints(*joint)) add_joint(made, *each);
        }
        for (const Element* named : children(element, "link")) {
            const int number = link(*named, "name");
            made.links.insert(number);
            if (const Joint* above = joint_above(number)) add_joint(made, *above);
        }
        for (const Element* chain : children(element, "chain")) add_chain(made, *chain);
        for (const Element* subgroup : children(element, "group")) {
            const auto found = group_elements_.find(xml_.attribute(*subgroup, "name"));
            if (found == group_elements_.end()) {
                xml_.fail(*subgroup, "unknown group " + quote(xml_.attribute(*subgroup, "name")));
            }
            const Members& inner = members(*found->second);
            made.variables.insert(inner.variables.begin(), inner.variables.end());
            made.links.insert(inner.links.begin(), inner.links.end());
            if (inner.tip >= 0) made.tip = inner.tip;
        }
        if (made.tip < 0) made.tip = serial_tip(made);
        return members_.emplace(name, std::move(made)).first->second;
    }

    /// The deepest of the links below the group's variables, if each of them is above the next.
    int serial_tip(const Members& group) const {
        int last = -1;
        for (const Joint& joint : robot_.joints) {
            if (!group.variables.contains(joint.variable)) continue;
            if (last >= 0 && !is_above(last, joint.child)) return -1;
            last = joint.child;
        }
        return last;
    }

    bool is_above(int upper, int lower) const {
        while (lower > upper) lower = joint_above(lower)->parent;
        return lower == upper;
    }

    void add_group(const Element& element) {
        const Members& group = members(element);
        if (group.variables.empty()) return;
        if (group.variables.size() > 16) xml_.fail(element, "a group may have at most 16 variables");
        robot_.groups.push_back({.name = xml_.attribute(element, "name"),
                                 .variables = {group.variables.begin(), group.variables.end()},
                                 .tip = group.tip});
    }

    const Group* find_group(const std::string& name) const {
        const int group = robot_.find_group(name);
        return group < 0 ? nullptr : &robot_.groups[static_cast<std::size_t>(group)];
    }

    void read_state(const Element& element) {
        const std::string group_name = xml_.attribute(element, "group");
        const Group* group = find_group(group_name);
        if (group == nullptr) {
            if (group_elements_.contains(group_name)) return;
            fail_unknown(element, "group", group_name, robot_.groups);
        }
        Configuration whole = robot_.zero();
        for (const Element* value : children(element, "joint")) {
            const std::vector<const Joint*> named = joints(*value);
            const std::vector<double> numbers = xml_.numbers(*value, "value");
            if (numbers.size() != std::max<std::size_t>(named.size(), 1)) {
                xml_.fail(*value, "the joint needs " + std::to_string(named.size()) + " numbers");
            }
            for (std::size_t i = 0; i < named.size(); ++i) {
                const int variable = named[i]->variable;
                if (variable < 0) continue;
                const Variable& limits = robot_.variables[static_cast<std::size_t>(variable)];
                if (limits.name != named[i]->name) continue;
                if (numbers[i] < limits.lower - 1e-6 || numbers[i] > limits.upper + 1e-6) {
                    xml_.fail(*value, "the value is outside of the limits of joint " + quote(limits.name));
                }
                whole[static_cast<std::size_t>(variable)] =
                    std::clamp(numbers[i], limits.lower, limits.upper);
            }
        }
        robot_.states.push_back({xml_.attribute(element, "name"), group_name, robot_.extract(*group, whole)});
    }

    std::string group_above(const Element& element, int link, const std::string& gripper) const {
        if (element.Attribute("parent_group") != nullptr) {
            std::string name = xml_.attribute(element, "parent_group");
            if (find_group(name) == nullptr) fail_unknown(element, "group", name, robot_.groups);
            return name;
        }
        for (const Group& group : robot_.groups) {
            if (group.tip == link && group.name != gripper) return group.name;
        }
        xml_.fail(element, "no group has the end effector's parent link as its tip",
                  "name one by parent_group");
    }

    std::optional<Configuration> state(const std::string& group,
                                       std::initializer_list<const char*> names) const {
        for (const NamedState& state : robot_.states) {
            if (state.group == group && std::ranges::find(names, state.name) != names.end())
                return state.positions;
        }
        return std::nullopt;
    }

    void set_gripper(EndEffector& effector, Group& gripper) const {
        gripper.tip = -1;
        effector.gripper = gripper.name;
        Configuration lower;
        Configuration upper;
        for (const int variable : gripper.variables) {
            lower.push_back(robot_.variables[static_cast<std::size_t>(variable)].lower);
            upper.push_back(robot_.variables[static_cast<std::size_t>(variable)].upper);
        }
        effector.open = state(gripper.name, {"open", "opened"}).value_or(upper);
        effector.closed = state(gripper.name, {"close", "closed"}).value_or(lower);
        for (const Joint& joint : robot_.joints) {
            if (joint.type != JointType::prismatic) continue;
            const auto place = std::ranges::find(gripper.variables, joint.variable);
            if (place == gripper.variables.end()) continue;
            const auto index = static_cast<std::size_t>(place - gripper.variables.begin());
            effector.max_opening +=
                std::abs(joint.multiplier * ((*effector.open)[index] - (*effector.closed)[index]));
        }
    }

    void read_tool(EndEffector& effector, const Element& element) const {
        const auto three = [&](const char* name) {
            if (element.Attribute(name) == nullptr) return Vector3(0, 0, 0);
            const std::vector<double> numbers = xml_.numbers(element, name);
            if (numbers.size() != 3) xml_.fail(element, quote(name) + " needs 3 numbers");
            return Vector3(numbers[0], numbers[1], numbers[2]);
        };
        effector.tool = pose_from_rpy(three("xyz"), three("rpy"));
        if (element.Attribute("max_opening") == nullptr) return;
        const std::vector<double> opening = xml_.numbers(element, "max_opening");
        if (opening.size() != 1 || opening[0] < 0)
            xml_.fail(element, "max_opening must be one number, not negative");
        effector.max_opening = opening[0];
    }

    void read_end_effector(const Element& element) {
        const std::string group_name = xml_.attribute(element, "group");
        const auto group = group_elements_.find(group_name);
        if (group == group_elements_.end()) fail_unknown(element, "group", group_name, robot_.groups);
        EndEffector effector{.name = xml_.attribute(element, "name"), .link = link(element, "parent_link")};
        if (robot_.find_end_effector(effector.name) >= 0) {
            xml_.fail(element, "there is another end effector named " + quote(effector.name));
        }
        effector.arm = group_above(element, effector.link, group_name);
        std::set<int> links = members(*group->second).links;
        links.insert(effector.link);
        const int gripper = robot_.find_group(group_name);
        if (gripper >= 0) {
            Group& fingers = robot_.groups[static_cast<std::size_t>(gripper)];
            set_gripper(effector, fingers);
            for (const Joint& joint : robot_.joints) {
                if (std::ranges::find(fingers.variables, joint.variable) != fingers.variables.end()) {
                    links.insert(joint.child);
                }
            }
        }
        effector.links = {links.begin(), links.end()};
        if (const Element* tool = element.FirstChildElement("tool")) read_tool(effector, *tool);
        robot_.end_effectors.push_back(std::move(effector));
    }

    bool read_collisions() {
        std::set<std::pair<int, int>> pairs(robot_.allowed_collisions.begin(),
                                            robot_.allowed_collisions.end());
        const auto pair_of = [&](const Element& element) -> std::pair<int, int> {
            return std::minmax({link(element, "link1"), link(element, "link2")});
        };
        const auto always = children(xml_.root(), "disable_default_collisions");
        for (const Element* element : always) {
            const int one = link(*element, "link");
            for (int other = 0; other < static_cast<int>(robot_.links.size()); ++other) {
                if (other != one) pairs.insert(std::minmax({one, other}));
            }
        }
        for (const Element* element : children(xml_.root(), "enable_collisions"))
            pairs.erase(pair_of(*element));
        const auto disabled = children(xml_.root(), "disable_collisions");
        for (const Element* element : disabled) {
            const auto pair = pair_of(*element);
            if (pair.first == pair.second) xml_.fail(*element, "a link never collides with itself");
            pairs.insert(pair);
        }
        robot_.allowed_collisions = {pairs.begin(), pairs.end()};
        return !always.empty() || !disabled.empty();
    }

    Robot& robot_;
    const XmlFile& xml_;
    std::map<std::string, const Element*> group_elements_;
    std::map<std::string, Members> members_;
    std::set<std::string> open_;
    std::set<std::string> fixed_;
};

}  // namespace

bool apply_srdf(Robot& robot, const Source& source) {
    const XmlFile xml(source, "robot");
    return SrdfReader(robot, xml).read();
}

}  // namespace praxis::tamp
