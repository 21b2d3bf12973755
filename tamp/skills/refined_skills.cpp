#include "tamp/skills/refined_skills.hpp"

#include <stdexcept>
#include <utility>

#include "tamp/skills/skill_clock.hpp"

namespace praxis::tamp {

namespace {

using Status = Execution::Status;

std::string text_of(const ActionName& action) {
    std::string text;
    for (const std::string& word : action.words) text += (text.empty() ? "(" : " ") + word;
    return text + ")";
}

/// One execution of one skill.
class SkillRun {
  public:
    SkillRun(const RefinedSkill& skill, const std::vector<double>& accelerations, RobotDriver& driver,
             const SkillExecution& options, const std::stop_token& stop)
        : skill_(skill),
          driver_(driver),
          options_(options),
          stop_(stop),
          clock_(skill, accelerations, options.period),
          deadline_(driver.seconds()) {}

    Execution run() {
        bool changed = false;
        for (const RefinedSkill::Event& event : skill_.events()) {
            if (Execution moved = go(event.time); moved.status != Status::done) return moved;
            Execution gripped = grip(event);
            if (gripped.status != Status::done) return changed ? failure(gripped) : undo(event, gripped);
            changed = true;
        }
        return go(skill_.duration());
    }

  private:
    static Execution failure(const Execution& reported) { return {Status::failed, reported.message}; }

    /// Moves to a time at which the skill rests.
    Execution go(double target) {
        while (clock_.time() != target) {
            if (stop_.stop_requested()) return halt(target, "told to stop");
            const SkillClock::Step step = clock_.run(target);
            if (Execution sent = send(step); sent.status != Status::done) return failure(sent);
            const RefinedSkill::Deviation off = skill_.deviation(clock_.time(), driver_.positions());
            if (!(off.amount <= options_.tracking))
                return halt(target, "the robot is off its path: " + skill_.variable(off.variable) + " by " +
                                        std::to_string(off.amount));
        }
        return {};
    }

    Execution halt(double target, const std::string& why) {
        while (!clock_.at_rest())
            if (Execution sent = send(clock_.brake(target)); sent.status != Status::done)
                return failure(sent);
        return {Status::failed, why};
    }

    Execution send(const SkillClock::Step& step) {
        Execution sent = driver_.command(step.command);
        deadline_ += step.seconds;
        driver_.wait_until(deadline_);
        return sent;
    }

    Execution grip(const RefinedSkill::Event& event) {
        Execution gripped = event.attach ? driver_.grasp(*event.attach) : driver_.release(*event.detach);
        deadline_ = driver_.seconds();
        return gripped;
    }

    Execution undo(const RefinedSkill::Event& event, const Execution& why) {
        if (event.attach) driver_.open();
        deadline_ = driver_.seconds();
        const Execution back = go(0);
        return {Status::failed,
                back.status == Status::done ? why.message : why.message + "; " + back.message};
    }

    const RefinedSkill& skill_;
    RobotDriver& driver_;
    const SkillExecution& options_;
    const std::stop_token& stop_;
    SkillClock clock_;
    double deadline_;  ///< of the last command
};

}  // namespace

SkillRefiner planned(TrajectoryDocument document) {
    return [skills = refined_skills(std::move(document))](
               const ActionName&, std::span<const double> parameters, const Situation&) {
        return parameters.empty() ? skills : std::vector<RefinedSkill>();
    };
}

RefinedSkills::RefinedSkills(SkillRefiner refiner, const Robot& robot, RobotDriver& driver,
                             const SkillExecution& options)
    : refiner_(std::move(refiner)), driver_(&driver), options_(options) {
    if (!(options.period > 0) || !(options.tracking > 0))
        throw std::invalid_argument("the period and the tolerance of tracking must be positive");
    for (const Variable& variable : robot.variables) accelerations_.push_back(variable.max_acceleration);
}

Execution RefinedSkills::execute(const ActionName& action, std::span<const double> parameters,
                                 std::stop_token stop) {
    const Situation now{driver_->positions(), driver_->bodies()};
    std::string why = "no motion is known for " + text_of(action);
    bool first = true;
    for (const RefinedSkill& skill : refiner_(action, parameters, now)) {
        if (!skill.is(action)) continue;
        const std::optional<std::string> refusal = skill.refusal(now.positions, now.bodies, options_.start);
        if (!refusal) return SkillRun(skill, accelerations_, *driver_, options_, stop).run();
        if (std::exchange(first, false)) why = *refusal;
    }
    return {Status::illegal, std::move(why)};
}

}  // namespace praxis::tamp
