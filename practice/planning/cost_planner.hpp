// Plans that are most likely to succeed, and what they would cost if a skill were better.
//
// One planner serves a whole run of practice: the states are expanded once (`StateGraph`, one for each set of
// variables that matter for a goal), then a plan for changed costs, from a changed state, to a changed goal
// is a shortest path, exact. Where a task has more states than `most_states`, plans come from the search
// given by `search`, with costs rounded to 2^-20 nat.
//
// What is known about goals is kept for the `kMostGoals` that were asked about last, and states as long as
// one of these goals needs them: a robot may be given new goals for ever.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "practice/planning/improved_paths.hpp"
#include "practice/planning/shortest_paths.hpp"

namespace praxis::practice {

struct SkillPlan {
    std::vector<SkillIndex> skills;
    Cost cost = 0;
};

/// A task in symbols.
struct Situation {
    std::vector<std::int32_t> values;  ///< by variable, derived ones too
    std::vector<Fact> goal;            ///< sorted
    friend bool operator==(const Situation&, const Situation&) = default;
};

struct CostPlannerOptions {
    std::size_t most_states = 200'000;
    std::string search = "astar(lmcut())";  ///< for tasks with more states
    double search_seconds = 10;             ///< for each such search
    int threads = 1;                        ///< for many situations or improvements
};

class CostPlanner {
  public:
    static constexpr std::size_t kMostGoals = 256;

    /// Throws std::invalid_argument for a wrong search.
    explicit CostPlanner(const SkillTask& skills, const CostPlannerOptions& options = {});
    ~CostPlanner();

    /// A cheapest plan; `costs` by skill. None: there is no plan, or (beyond `most_states`) none was found in
    /// time.
    std::optional<SkillPlan> plan(const Situation& situation, std::span<const Cost> costs);

    /// The mean cost in nats of the situations' cheapest plans, for each improvement alone. Situations
    /// without a plan are left out; if none has one, the mean is infinite.
    std::vector<double> expected_costs(std::span<const Situation> situations, std::span<const Cost> costs,
                                       std::span<const Improvement> improvements);

    CostPlanner(const CostPlanner&) = delete;
    CostPlanner& operator=(const CostPlanner&) = delete;

    /// Symbolic states that are kept; those of goals for which different variables matter are different
    /// states.
    std::size_t states() const;
    /// Goals that are kept: at most `kMostGoals`, besides those that are new in the last question.
    std::size_t goals() const { return tables_.size(); }

  private:
    struct Scratch;
    struct Space;
    struct GoalTable;
    /// The situations of one goal and state.
    struct Task {
        NodeIndex from;
        GoalTable* goal;
        double weight;  ///< how many there are
        GoalBound bound = {};
    };
    struct Question {
        std::span<const Cost> costs;
        std::span<const Cost> least;  ///< by skill, with all improvements
        std::span<const Improvement> improvements;
    };
    /// What the plan of a task costs in nats, times its weight, by improvement. False: there is no plan.
    static bool weigh(Scratch& scratch, const Task& task, const Question& question, std::span<double> result);
    /// Forgets the goals that were not asked about for longest; begins each question.
    void forget();
    GoalTable& table(const std::vector<Fact>& goal);
    Space& space(const std::vector<Fact>& goal);
    /// The node of the values in the goal's graph. False: the graph is too large.
    static bool reach(GoalTable& table, const std::vector<std::int32_t>& values, NodeIndex& node);
    /// Takes in that the graph has grown.
    static void refresh(GoalTable& table);
    static void update(GoalTable& table, std::span<const Cost> costs);
    static std::optional<SkillPlan> descend(const GoalTable& table, NodeIndex node,
                                            std::span<const Cost> costs);
    std::optional<SkillPlan> search(const Situation& situation, std::span<const Cost> costs) const;
    std::vector<double> search_costs(std::span<const Situation> situations, std::span<const Cost> costs,
                                     std::span<const Improvement> improvements) const;

    const SkillTask* skills_;
    CostPlannerOptions options_;
    std::vector<std::unique_ptr<Space>> spaces_;
    std::vector<std::unique_ptr<GoalTable>> tables_;  // the last asked about first
};

}  // namespace praxis::practice
