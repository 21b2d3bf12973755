#include "tamp/robots/derive.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "search/engines/random.hpp"
#include "tamp/robots/finish_robot.hpp"

namespace praxis::tamp {

namespace {

constexpr std::size_t kMaximumGroup = 16;
constexpr double kFar = 0.02;

std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// Joints by the link that they hang from.
std::vector<std::vector<int>> joints_below(const Robot& robot) {
    std::vector<std::vector<int>> below(robot.links.size());
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
        below[at(robot.joints[i].parent)].push_back(static_cast<int>(i));
    }
    return below;
}

/// The links that move when something below them or above them moves: whether any variable is in the subtree.
std::vector<bool> links_with_variables_below(const Robot& robot) {
    std::vector<bool> moving(robot.links.size());
    for (std::size_t i = robot.joints.size(); i-- > 0;) {
        const Joint& joint = robot.joints[i];
        if (joint.variable >= 0 || moving[at(joint.child)]) moving[at(joint.parent)] = true;
    }
    return moving;
}

class GroupMaker {
  public:
    explicit GroupMaker(Robot& robot)
        : robot_(robot), below_(joints_below(robot)), moving_(links_with_variables_below(robot)) {}

    void make() {
        std::vector<int> starts = {0};
        std::vector<Group> chains;
        while (!starts.empty()) {
            const int start = starts.back();
            starts.pop_back();
            Group chain = follow(start, starts);
            if (!chain.variables.empty()) chains.push_back(std::move(chain));
        }
        const auto arm =
            std::ranges::max_element(chains, {}, [](const Group& g) { return g.variables.size(); });
        if (arm == chains.end()) return;
        const Group gripper = everything_below(arm->tip);
        for (Group& chain : chains) {
            const bool in_gripper = std::ranges::includes(gripper.variables, chain.variables);
            if (&chain == &*arm)
                chain.name = "arm";
            else if (in_gripper)
                continue;
            if (chain.variables.size() <= kMaximumGroup) robot_.groups.push_back(chain);
        }
        if (!gripper.variables.empty() && gripper.variables.size() <= kMaximumGroup) {
            robot_.groups.push_back(gripper);
        }
    }

  private:
    bool owns(const Joint& joint) const {
        return joint.variable >= 0 && robot_.variables[at(joint.variable)].name == joint.name;
    }

    /// Goes down from a link to the next branching of what moves.
    Group follow(int link, std::vector<int>& starts) const {
        Group chain;
        std::set<int> variables;
        for (;;) {
            if (link != 0) {
                const Joint& above = robot_.joints[at(robot_.links[at(link)].parent_joint)];
                if (owns(above)) variables.insert(above.variable);
            }
            std::vector<int> moving;
            for (const int joint : below_[at(link)]) {
                const Joint& candidate = robot_.joints[at(joint)];
                if (candidate.variable >= 0 || moving_[at(candidate.child)])
                    moving.push_back(candidate.child);
            }
            if (moving.empty() && below_[at(link)].size() == 1) {
                link = robot_.joints[at(below_[at(link)].front())].child;
            } else if (moving.size() == 1) {
                link = moving.front();
            } else {
                starts.insert(starts.end(), moving.rbegin(), moving.rend());
                break;
            }
        }
        chain.name = robot_.links[at(link)].name;
        chain.variables = {variables.begin(), variables.end()};
        chain.tip = link;
        return chain;
    }

    Group everything_below(int link) const {
        std::set<int> variables;
        std::vector<int> open = {link};
        while (!open.empty()) {
            const int next = open.back();
            open.pop_back();
            for (const int joint : below_[at(next)]) {
                const Joint& below = robot_.joints[at(joint)];
                if (owns(below)) variables.insert(below.variable);
                open.push_back(below.child);
            }
        }
        return {.name = "gripper", .variables = {variables.begin(), variables.end()}};
    }

    Robot& robot_;
    std::vector<std::vector<int>> below_;
    std::vector<bool> moving_;
};

double uniform(Random& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random.next() >> 11) * 0x1p-53;
}

Configuration random_configuration(const Robot& robot, Random& random) {
    Configuration configuration;
    for (const Variable& variable : robot.variables) {
        const double reach = variable.continuous ? std::numbers::pi : 1;
        const double lower = std::isfinite(variable.lower) ? variable.lower : -reach;
        const double upper = std::isfinite(variable.upper) ? variable.upper : std::max(lower, reach);
        configuration.push_back(uniform(random, std::min(lower, upper), upper));
    }
    return configuration;
}

/// The distance between the balls of two links: negative if some meet.
double clearance(const std::vector<Ball>& first, const std::vector<Ball>& second,
                 const Pose& second_in_first) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Ball& ball : second) {
        const Vector3 center = second_in_first * ball.center;
        for (const Ball& other : first) {
            nearest = std::min(nearest, (other.center - center).norm() - other.radius - ball.radius);
        }
    }
    return nearest;
}

/// A number for each link, the same for links that never move against each other.
std::vector<int> rigid_parts(const Robot& robot) {
    std::vector<int> part(robot.links.size(), 0);
    for (const Joint& joint : robot.joints) {
        part[at(joint.child)] = joint.variable < 0 ? part[at(joint.parent)] : joint.child;
    }
    return part;
}

}  // namespace

void derive_groups(Robot& robot) {
    GroupMaker(robot).make();
}

void derive_allowed_collisions(Robot& robot, std::size_t samples, std::uint64_t seed) {
    struct Pair {
        int first = 0;
        int second = 0;
        std::size_t meetings = 0;
        bool came_near = false;
    };
    std::vector<Pair> pairs;
    std::vector<std::pair<int, int>> rigid;
    const std::vector<int> part = rigid_parts(robot);
    for (int first = 0; first < static_cast<int>(robot.links.size()); ++first) {
        for (int second = first + 1; second < static_cast<int>(robot.links.size()); ++second) {
            const bool empty = robot.links[at(first)].balls.empty() || robot.links[at(second)].balls.empty();
            if (part[at(first)] == part[at(second)]) {
                rigid.emplace_back(first, second);
            } else if (!empty && robot.may_collide(first, second)) {
                pairs.push_back({first, second});
            }
        }
    }
    Random random(seed);
    std::vector<Pose> poses(robot.links.size());
    for (std::size_t sample = 0; sample < samples; ++sample) {
        forward_kinematics(robot, random_configuration(robot, random), poses);
        for (Pair& pair : pairs) {
            const Link& first = robot.links[at(pair.first)];
            const Link& second = robot.links[at(pair.second)];
            const Pose relative = poses[at(pair.first)].inverse() * poses[at(pair.second)];
            if (clearance({first.bound}, {second.bound}, relative) > kFar) continue;
            const double distance = clearance(first.balls, second.balls, relative);
            pair.meetings += distance <= 0 ? 1U : 0U;
            pair.came_near = pair.came_near || distance <= kFar;
        }
    }
    robot.allowed_collisions.insert(robot.allowed_collisions.end(), rigid.begin(), rigid.end());
    for (const Pair& pair : pairs) {
        if (samples == 0) break;
        if (!pair.came_near || pair.meetings == samples) {
            robot.allowed_collisions.emplace_back(pair.first, pair.second);
        }
    }
    allow_neighbours(robot);
}

}  // namespace praxis::tamp
