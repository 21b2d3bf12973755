// An environment seen through its PDDL text: ground skills, abstract states, and what PDDL promises of
// skills.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "practice/environment.hpp"
#include "search/engines/search.hpp"

namespace praxis::practice::test {

class AbstractTask {
  public:
    /// By variable of the ground task.
    using Values = std::vector<std::int32_t>;

    explicit AbstractTask(const SimulatedEnvironment& environment);

    const SimulatedEnvironment& environment() const { return environment_; }
    /// By operator of the ground task.
    const std::vector<GroundSkill>& skills() const { return skills_; }
    std::size_t parameter_count(std::size_t skill) const;
    const std::string& schema_name(std::size_t skill) const;
    std::string name(std::size_t skill) const { return ground_->operator_names.words(skill); }
    /// Of a skill by its name, such as "move c0 c1".
    std::size_t find(const std::string& name) const;

    /// The values of a state; none (and a failure) if a variable has two of its atoms true, or none where one
    /// has to be.
    std::optional<Values> values(const State& state) const;
    bool applicable(const Values& values, std::size_t skill) const;
    /// The state that PDDL promises.
    Values successor(const Values& values, std::size_t skill) const;
    bool reached(const State& state, const std::vector<GroundAtom>& goal) const;

    /// The number of states that PDDL promises to reach; stops at `limit`.
    std::size_t reachable(const State& from, std::size_t limit) const;
    /// The length of a shortest plan that does without the schemas named; none if there is no plan.
    std::optional<std::int64_t> distance(const PracticeTask& task,
                                         const std::vector<std::string>& without = {}) const;
    /// The length of a shortest plan to the precondition of a skill; none if there is none.
    std::optional<std::int64_t> steps_before(const State& from, std::size_t skill) const;
    /// Some plan; empty if there is none.
    std::vector<std::size_t> plan(const Values& from, std::span<const Fact> goal) const;
    using Choice = std::function<std::vector<double>(const State& state, std::size_t skill)>;
    /// Executes shortest plans, the next one where a skill did not do what PDDL promises; whether the goal is
    /// reached within the horizon.
    bool solves(const PracticeTask& task, const Choice& parameters, Random& random) const;
    /// The share of `count` tasks that are solved.
    double solved_share(int count, const Choice& parameters, Random& random) const;
    /// Fails for ground skills to whose precondition PDDL knows no way.
    void expect_practice_goes_on(const State& from) const;
    std::vector<Fact> facts(const std::vector<GroundAtom>& atoms) const;

  private:
    struct FactAtom {
        GroundAtom atom;
        FiniteDomainTask::FactForm form = FiniteDomainTask::FactForm::atom;
    };
    bool fact_holds(const State& state, std::size_t fact) const;

    const SimulatedEnvironment& environment_;
    std::shared_ptr<const FiniteDomainTask> ground_;
    std::unique_ptr<PreparedTask> prepared_;
    std::vector<GroundSkill> skills_;
    std::vector<FactAtom> facts_;
};

}  // namespace praxis::practice::test
