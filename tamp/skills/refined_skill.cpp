#include "tamp/skills/refined_skill.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace praxis::tamp {

namespace {

using Document = TrajectoryDocument;

constexpr double kRest = 1e-6;  // of velocities: less is rest
constexpr double kTime = 1e-9;

std::string text_of(const Document::Action& action) {
    std::string text = "(" + action.name;
    for (const std::string& argument : action.arguments) text += " " + argument;
    return text + ")";
}

std::string text_of(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", number);
    return text;
}

}  // namespace

RefinedSkill::RefinedSkill(std::shared_ptr<const RefinedMotion> motion, std::size_t step)
    : motion_(std::move(motion)), step_(step) {
    const Document& document = motion_->document();
    if (step >= document.plan.size())
        throw std::invalid_argument("there is no step " + std::to_string(step) + " in a plan of " +
                                    std::to_string(document.plan.size()));
    duration_ = action().end - action().start;
    finger_.resize(document.robot.variables.size());
    turns_.resize(finger_.size());
    for (const Document::Link& link : document.robot.links)
        if (link.variable >= 0)
            turns_[static_cast<std::size_t>(link.variable)] = link.type == JointType::continuous;
    for (const Document::Segment& segment : document.segments) {
        if (segment.kind == Document::Motion::gripper)
            for (const int variable : segment.variables) finger_[static_cast<std::size_t>(variable)] = true;
        if (static_cast<std::size_t>(segment.action) != step) continue;
        if (segment.attach || segment.detach)
            events_.push_back({segment.end - action().start, segment.attach, segment.detach});
    }
    std::ranges::stable_sort(events_, {}, &Event::time);
    check();
}

void RefinedSkill::check() const {
    const auto refuse = [&](const std::string& what) {
        throw std::invalid_argument(text_of(action()) + " is not a skill of its own: " + what);
    };
    for (const Document::Segment& segment : motion_->document().segments) {
        if (static_cast<std::size_t>(segment.action) == step_) {
            if (segment.start < action().start - kTime || segment.end > action().end + kTime)
                refuse("it moves before its start or after its end");
        } else if (segment.start < action().end - kTime && segment.end > action().start + kTime) {
            refuse("another one moves at the same time");
        }
    }
    const auto check_rest = [&](double time, const char* when) {
        for (const double moment : {std::max(0.0, time - kTime), time})
            for (const double velocity : command(moment).velocities)
                if (std::abs(velocity) > kRest) refuse(std::string("the robot is not at rest ") + when);
    };
    check_rest(0, "at its start");
    check_rest(duration_, "at its end");
    for (const Event& event : events_) {
        if (event.time <= 0) refuse("the gripper acts at its start");
        check_rest(event.time, "when the gripper acts");
    }
}

std::vector<std::pair<std::string, Document::Value>> RefinedSkill::parameters() const {
    std::vector<std::pair<std::string, Document::Value>> result;
    for (const std::string& argument : arguments())
        if (const auto value = motion_->document().values.find(argument);
            value != motion_->document().values.end())
            result.push_back(*value);
    return result;
}

bool RefinedSkill::is(const ActionName& words) const {
    if (words.words.empty() || words.words[0] != name()) return false;
    std::size_t next = 1;
    for (const std::string& argument : arguments()) {
        if (next < words.words.size() && words.words[next] == argument)
            ++next;
        else if (!motion_->document().values.contains(argument))
            return false;
    }
    return next == words.words.size();
}

std::optional<std::string> RefinedSkill::refusal(std::span<const double> positions, const BodyPoses& bodies,
                                                 const SkillTolerance& tolerance) const {
    const Document& document = motion_->document();
    const Replay& replay = motion_->replay();
    const double start = action().start;
    const Deviation deviation = this->deviation(0, positions, replay.held_at(start).empty());
    if (!(deviation.amount <= tolerance.robot))
        return "the robot is not where " + text_of(action()) +
               " begins: " + document.robot.variables[deviation.variable] + " is off by " +
               text_of(deviation.amount);
    const std::vector<Pose> planned = replay.bodies_at(start);
    for (const auto& [name, pose] : bodies) {
        const int number = document.find_body(name);
        if (number < 0) continue;
        const Pose& expected = planned[static_cast<std::size_t>(number)];
        const double off = (pose.translation() - expected.translation()).norm();
        const double turned = Eigen::AngleAxisd(expected.linear().transpose() * pose.linear()).angle();
        if (!(off <= tolerance.body))
            return name + " is " + text_of(off) + " m from where " + text_of(action()) + " has it";
        if (!(turned <= tolerance.turn))
            return name + " is turned by " + text_of(turned) + " against how " + text_of(action()) +
                   " has it";
    }
    return std::nullopt;
}

RobotCommand RefinedSkill::command(double time) const {
    RobotMotion motion = motion_->replay().motion_at(action().start + time);
    return {std::move(motion.positions), std::move(motion.velocities)};
}

RefinedSkill::Deviation RefinedSkill::deviation(double time, std::span<const double> positions,
                                                bool fingers) const {
    const Configuration planned = command(time).positions;
    if (positions.size() != planned.size())
        throw std::invalid_argument("positions of " + std::to_string(positions.size()) + " variables, of " +
                                    std::to_string(planned.size()));
    Deviation worst;
    for (std::size_t v = 0; v < planned.size(); ++v) {
        if (finger_[v] && !fingers) continue;
        double amount = positions[v] - planned[v];
        if (turns_[v]) amount = std::remainder(amount, 2 * std::numbers::pi);
        if (std::isnan(amount)) return {v, std::numeric_limits<double>::infinity()};
        if (std::abs(amount) > worst.amount) worst = {v, std::abs(amount)};
    }
    return worst;
}

std::vector<RefinedSkill> refined_skills(TrajectoryDocument document) {
    const auto motion = std::make_shared<const RefinedMotion>(std::move(document));
    std::vector<RefinedSkill> result;
    for (std::size_t step = 0; step < motion->document().plan.size(); ++step)
        result.emplace_back(motion, step);
    return result;
}

}  // namespace praxis::tamp
