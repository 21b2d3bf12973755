// The states a search has met, how they came about and what they cost.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "search/engines/node.hpp"
#include "search/engines/prepared_parts.hpp"
#include "search/engines/search_plan.hpp"
#include "search/state/state_registry.hpp"

namespace praxis {

class SearchSpace {
  public:
    /// Remembers `estimates` estimates a state. Refers to all arguments.
    SearchSpace(const PreparedTask::Parts& parts, const Query& query, const SearchPlan& plan,
                std::size_t estimates);

    const FiniteDomainTask& task() const { return *parts_->task; }
    const SuccessorGenerator& generator() const { return parts_->generator; }
    std::uint32_t size() const { return registry_.size(); }

    /// The initial state, stored as an open node.
    StateId insert_initial();
    /// Writes the state after `op`, stores it if it is new, and says whether it is; its node is then
    /// unspecified. `values` are those of `state`, complete; they may be null unless `needs_values(op)`.
    std::pair<StateId, bool> successor(StateId state, OperatorId op, const std::int32_t* values) {
        parts_->transitions.apply(op, values, registry_.candidate_from(state));
        return registry_.intern();
    }
    /// Makes the states after up to kBatch operators and brings what `successor(i)` will look at into the
    /// cache: misses of several look-ups overlap.
    static constexpr std::size_t kBatch = 16;
    void prepare_successors(StateId state, std::span<const OperatorId> operators, const std::int32_t* values);
    /// Stores the state after the i-th of them as `successor` does.
    std::pair<StateId, bool> successor(std::size_t i) {
        return registry_.intern(batch_.data() + i * registry_.word_count(), batch_hashes_[i]);
    }
    bool needs_values(OperatorId op) const { return parts_->transitions.conditional(op); }
    /// The complete values of a stored state.
    void read(StateId state, std::vector<std::int32_t>& values) {
        parts_->packer.unpack(registry_.words(state), values.data());
        parts_->axioms.complete(values.data(), scratch_);
    }
    /// The complete values of the state after `op`, from those before.
    void read_successor(const std::vector<std::int32_t>& before, OperatorId op,
                        std::vector<std::int32_t>& values) {
        std::copy(before.begin(), before.end(), values.begin());
        parts_->transitions.apply(op, before.data(), values.data());
        parts_->axioms.complete(values.data(), scratch_);
    }
    /// A buffer for the values of one state.
    std::vector<std::int32_t> buffer() const { return std::vector<std::int32_t>(task().variable_count(), 0); }
    bool goal_holds(const std::vector<std::int32_t>& values) const {
        return all_hold(query_->goal, values.data());
    }

    /// What g adds for an operator.
    std::int64_t cost(OperatorId op) const { return cost_factor_ * task().costs[op.index()] + cost_summand_; }
    /// Plans cost less than this from now on.
    void lower_bound(std::int64_t bound) { bound_ = std::min(bound_, bound); }
    bool uniform_costs() const { return cost_factor_ == 0 || uniform_costs_; }
    /// A way of real cost `cost` and then `op` is not below the bound.
    bool exceeds_bound(std::int64_t cost, OperatorId op) const {
        const std::int64_t least = bound();
        return least != kInfinity && cost + task().costs[op.index()] >= least;
    }
    bool bounded() const { return bound() != kInfinity; }

    const NodeLayout& layout() const { return layout_; }
    std::uint32_t* node(StateId state) { return registry_.node(state); }
    std::int64_t g(StateId state) const { return layout_.g(registry_.node(state)); }
    std::int64_t real_cost(StateId state) const { return layout_.real_cost(registry_.node(state)); }
    NodeStatus status(StateId state) const { return layout_.status(registry_.node(state)); }
    void set_status(StateId state, NodeStatus status) { layout_.set_status(registry_.node(state), status); }

    /// The operators from the initial state to `state`; of several between two states a cheapest.
    std::vector<OperatorId> plan_to(StateId state);

    /// Packed state, node and set, without what is allocated ahead.
    double bytes_per_state() const { return registry_.bytes_per_state(); }

  private:
    std::int64_t bound() const {
        if (shared_bound_ == nullptr) return bound_;
        return std::min(bound_, shared_bound_->load(std::memory_order_relaxed));
    }
    OperatorId operator_between(StateId parent, StateId child);

    const PreparedTask::Parts* parts_;
    const Query* query_;
    std::int64_t cost_factor_ = 1;
    std::int64_t cost_summand_ = 0;
    bool uniform_costs_;
    std::int64_t bound_;
    const SharedBound* shared_bound_;
    NodeLayout layout_;
    StateRegistry registry_;
    AxiomEvaluator::Scratch scratch_;
    std::vector<std::uint32_t> batch_;
    std::array<std::uint64_t, kBatch> batch_hashes_{};
};

}  // namespace praxis
