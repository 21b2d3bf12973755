// The symbolic side of an environment: its ground task, whose operators are the ground skills.
//
// Grounded once; tasks differ in their initial values and goals only. Ground skills are numbered as the
// operators of the ground task are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "parser/task.hpp"
#include "practice/environment.hpp"
#include "search/atom_index.hpp"
#include "search/engines/prepared_parts.hpp"

namespace praxis::practice {

/// A ground skill by its number.
using SkillIndex = std::uint32_t;

class SkillTask {
  public:
    /// Grounds the domain of the environment, which must outlive this. Throws InputError for wrong PDDL, and
    /// std::invalid_argument where description and domain disagree.
    explicit SkillTask(const Environment& environment);

    const Environment& environment() const { return *environment_; }
    const FiniteDomainTask& task() const { return prepared_->task(); }
    const std::shared_ptr<const PreparedTask>& prepared() const { return prepared_; }

    std::size_t size() const { return skills_.size(); }
    const GroundSkill& skill(SkillIndex i) const { return skills_[i]; }
    const SkillSchema& schema(SkillIndex i) const;
    /// "(place ring table)".
    std::string name(SkillIndex i) const { return task().operator_name(OperatorId(i)); }
    /// The skill of that name; throws std::invalid_argument.
    SkillIndex find(const std::string& name) const;

    /// What holds in a state, by variable (derived ones too). Throws std::logic_error where the environment's
    /// atoms contradict the domain (a robot at two places).
    void read(const State& state, std::vector<std::int32_t>& values) const;
    /// The facts of a goal, sorted. Throws std::invalid_argument where an atom's numbers are none of the
    /// description's, or no skills can make it true.
    std::vector<Fact> goal(std::span<const GroundAtom> atoms) const;
    bool holds(std::span<const Fact> facts, const State& state) const;
    std::span<const Fact> precondition(SkillIndex i) const { return task().preconditions[i]; }
    bool applicable(SkillIndex i, const std::vector<std::int32_t>& values) const {
        return all_hold(precondition(i), values.data());
    }
    /// Whether the skill, executed where `before` held, has succeeded: all that it was to make true is true.
    /// (What it was to make false is not looked at.)
    bool succeeded(SkillIndex i, const std::vector<std::int32_t>& before,
                   const std::vector<std::int32_t>& after) const;
    /// Calls visit(SkillIndex) for each skill whose precondition holds.
    template <class Visit>
    void for_each_applicable(const std::vector<std::int32_t>& values, Visit&& visit) const;

  private:
    struct Place {
        std::int32_t value;
        GroundAtom atom;
    };
    void bind_skills();
    void bind_variables();

    const Environment* environment_;
    Task lifted_;
    std::shared_ptr<const PreparedTask> prepared_;
    std::unique_ptr<const AtomIndex> atoms_;
    std::vector<GroundSkill> skills_;
    std::vector<std::vector<Place>> places_;  // by variable: the atoms that its values are
    std::vector<std::int32_t> empty_values_;  // by variable: its value where none of them holds, or -1
};

template <class Visit>
void SkillTask::for_each_applicable(const std::vector<std::int32_t>& values, Visit&& visit) const {
    prepared_->parts().generator.for_each(values.data(),
                                          [&](OperatorId id) { visit(static_cast<SkillIndex>(id.index())); });
}

}  // namespace praxis::practice
