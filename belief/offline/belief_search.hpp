// The AND/OR search behind `optimal_policy`, over beliefs with numbers.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <queue>
#include <span>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "belief/offline/conditional_plan.hpp"
#include "belief/offline/optimal_policy.hpp"
#include "belief/offline/state_graph.hpp"

namespace praxis::belief {

class BeliefSearch {
  public:
    using Criterion = OptimalPolicyOptions::Criterion;
    /// Number of a belief.
    using BeliefIndex = std::uint32_t;
    /// A state, and how many first states led to it (always 1 for the worst cost).
    struct Member {
        StateIndex state;
        std::uint32_t worlds;
        friend auto operator<=>(const Member&, const Member&) = default;
    };

    /// Refers to its arguments.
    BeliefSearch(const StateGraph& graph, const FiniteDomainTask& task, Criterion criterion,
                 std::size_t most_beliefs, const Budget& budget);

    BeliefIndex add(std::vector<Member> members);
    /// The cost of the best policy from a belief, summed over the first states, or of the worst of them;
    /// StateGraph::kUnreachable if there is no policy. Nothing if the limits were reached.
    std::optional<std::int64_t> solve(BeliefIndex belief);
    /// Adds the best policy to a plan. After `solve`, with the result not unreachable.
    std::uint32_t write(BeliefIndex belief, PlanDraft& draft);
    std::size_t beliefs() const { return values_.size(); }

  private:
    struct Part {
        std::uint32_t observation;
        BeliefIndex belief;
    };
    /// An action whose reading splits a belief.
    struct Exit {
        BeliefIndex from;
        std::uint32_t action;
        std::int64_t cost;  ///< from the root of the level, the action included
        std::vector<Part> parts;
    };
    struct Item {
        std::int64_t estimate;
        std::int64_t cost;   ///< from the root of the level
        BeliefIndex belief;  ///< where
        std::uint32_t exit;  ///< kNone: the belief itself
        friend bool operator>(const Item& a, const Item& b) { return a.estimate > b.estimate; }
    };
    static constexpr std::uint32_t kNone = 0xffffffff;
    struct Reached {
        std::int64_t cost = 0;
        BeliefIndex parent = kNone;
        std::uint32_t action = kNone;
        bool expanded = false;
    };
    /// A* from one belief over the actions that keep it together, which can be paused.
    struct Level {
        std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
        std::unordered_map<BeliefIndex, Reached> reached;
        std::vector<Exit> exits;
    };
    struct Value {
        std::int64_t lower;
        bool solved = false;
        std::uint32_t action = kNone;  ///< solved: the best action; kNone in the goal
    };
    struct Hash {
        const BeliefSearch* search;
        std::size_t operator()(BeliefIndex belief) const;
    };
    struct Equal {
        const BeliefSearch* search;
        bool operator()(BeliefIndex a, BeliefIndex b) const;
    };

    std::span<const Member> members(BeliefIndex belief) const {
        return {members_.data() + begin_[belief], members_.data() + begin_[belief + 1]};
    }
    bool goal(BeliefIndex belief) const;
    std::int64_t estimate(std::span<const Member> members) const;
    std::int64_t price(std::uint32_t action, BeliefIndex belief) const;
    std::int64_t lower(const Exit& exit) const;
    /// The parts into which an action and what is read after it lead; nothing if it is not always possible.
    bool apply(BeliefIndex belief, std::uint32_t action, std::vector<Part>& parts);
    void expand(Level& level, BeliefIndex belief, std::int64_t cost);
    /// Goes on until the belief is solved or its cost is known to exceed `limit`.
    void advance(BeliefIndex root, std::int64_t limit);
    void advance_part(const Exit& exit, std::int64_t slack);
    void solved(BeliefIndex root, Level& level, BeliefIndex last, std::int64_t cost);
    bool exhausted();

    const StateGraph* graph_;
    const FiniteDomainTask* task_;
    Criterion criterion_;
    std::size_t most_beliefs_;
    const Budget* budget_;
    bool stopped_ = false;
    std::vector<Member> members_;
    std::vector<std::uint32_t> begin_{0};
    std::vector<Value> values_;
    std::unordered_set<BeliefIndex, Hash, Equal> index_;
    std::unordered_map<BeliefIndex, std::unique_ptr<Level>> levels_;
    std::unordered_map<BeliefIndex, std::uint32_t> written_;
    std::vector<std::pair<std::uint32_t, Member>> successors_;
    std::vector<Part> parts_;
};

}  // namespace praxis::belief
