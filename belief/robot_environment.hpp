// A robot as an environment: its skills and its observer, joined.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "belief/atom_names.hpp"
#include "belief/environment.hpp"

namespace praxis::belief {

class RobotEnvironment : public Environment {
  public:
    /// Refers to the robot's parts. `pending`: what is already perceived at the start, instead of looking.
    RobotEnvironment(std::shared_ptr<const BeliefTask> task, Skills& skills, Observer& observer,
                     std::optional<Percept> pending = std::nullopt);

    Execution execute(std::uint32_t action, std::stop_token stop) override;
    /// Asks about what the action reads and about what sensors may read; after a failure also about what the
    /// action may have changed. Readings of atoms that the task does
    /// not have are passed over; "unknown" is no answer.
    std::vector<Answer> observe(std::uint32_t action, std::stop_token stop) override;
    bool found_objects() const override { return !found_.empty(); }

    /// Objects detected, or spoken of by a reading that says "true", which the task does not have; with
    /// what was detected of them (a reading leaves the type empty).
    const std::vector<Detection>& found() const { return found_; }
    /// The last percept.
    const Percept& percept() const { return percept_; }

  private:
    void ask_for_effects(std::uint32_t action, std::vector<AtomName>& questions) const;
    void note_new(const Detection& detection);

    std::shared_ptr<const BeliefTask> task_;
    Skills* skills_;
    Observer* observer_;
    AtomNames names_;
    std::vector<std::string> objects_;
    std::vector<AtomName> sensed_;             ///< by sensor: what it reads
    std::vector<std::vector<AtomName>> read_;  ///< by action
    std::optional<Percept> pending_;
    bool failed_ = false;  ///< the last action did
    Percept percept_;
    std::vector<Detection> found_;
};

}  // namespace praxis::belief
