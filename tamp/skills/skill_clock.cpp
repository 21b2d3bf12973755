#include "tamp/skills/skill_clock.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace praxis::tamp {

namespace {

constexpr int kHalvings = 20;
constexpr double kSlack = 1e-6;  // relative, of limits

}  // namespace

SkillClock::SkillClock(const RefinedSkill& skill, std::vector<double> accelerations, double period)
    : skill_(&skill), accelerations_(std::move(accelerations)), period_(period) {
    const std::size_t variables = skill.command(0).positions.size();
    if (accelerations_.size() != variables)
        throw std::invalid_argument("limits of " + std::to_string(accelerations_.size()) +
                                    " variables for a motion of " + std::to_string(variables));
}

RobotCommand SkillClock::at(double time, double rate) const {
    RobotCommand command = skill_->command(time);
    for (double& velocity : command.velocities) velocity *= rate;
    return command;
}

SkillClock::Step SkillClock::arrive(double target, double seconds) {
    time_ = target;
    rate_ = 0;
    return {at(target, 0), seconds};
}

SkillClock::Step SkillClock::run(double target) {
    const double left = target - time_;
    if (std::abs(left) <= period_) return arrive(target, std::abs(left));
    rate_ = left > 0 ? 1 : -1;
    time_ += rate_ * period_;
    return {at(time_, rate_), period_};
}

bool SkillClock::within_limits(const RobotCommand& now, const RobotCommand& next, double rate) const {
    for (std::size_t v = 0; v < accelerations_.size(); ++v)
        if (std::abs(rate * next.velocities[v] - rate_ * now.velocities[v]) >
            (1 + kSlack) * accelerations_[v] * period_)
            return false;
    return true;
}

SkillClock::Step SkillClock::brake(double target) {
    const RobotCommand now = skill_->command(time_);
    const auto bounded = [&](double time) {
        return rate_ > 0 ? std::min(time, target) : std::max(time, target);
    };
    const auto time_with = [&](double rate) { return bounded(time_ + period_ * (rate_ + rate) / 2); };
    const auto possible = [&](double share) {
        const double rate = share * rate_;
        return within_limits(now, skill_->command(time_with(rate)), rate);
    };
    double share = 0;
    if (!possible(0)) {
        double low = 0;
        share = 1;
        for (int i = 0; i < kHalvings; ++i) {
            const double middle = (low + share) / 2;
            (possible(middle) ? share : low) = middle;
        }
    }
    const double rate = share * rate_;
    const double next = time_with(rate);
    if (next == target) return arrive(target, period_);
    time_ = next;
    rate_ = rate;
    return {at(time_, rate_), period_};
}

}  // namespace praxis::tamp
