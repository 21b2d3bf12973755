#include "search/landmarks/landmark_sum.hpp"

#include <algorithm>

#include "search/evaluators/operator_costs.hpp"

namespace praxis {

LandmarkSumEvaluator::LandmarkSumEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal,
                                           std::span<const std::int32_t> initial_values, CostType cost_type,
                                           const LandmarkOptions& options)
    : LandmarkSumEvaluator(
          task, goal,
          std::make_shared<const LandmarkGraph>(make_landmark_graph(task, goal, initial_values, options)),
          cost_type) {}

LandmarkSumEvaluator::LandmarkSumEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal,
                                           std::shared_ptr<const LandmarkGraph> graph, CostType cost_type)
    : task_(task),
      goal_(goal.begin(), goal.end()),
      graph_(std::move(graph)),
      status_(*graph_),
      past_(status_.words()),
      required_again_(status_.words()),
      wanted_(status_.words()) {
    find_achievers();
    price(cost_type);
}

void LandmarkSumEvaluator::find_achievers() {
    constexpr std::uint32_t kNone = ~std::uint32_t{0};
    // No fact is in two landmarks.
    std::vector<std::uint32_t> landmark_of(task_.fact_count(), kNone);
    for (std::uint32_t landmark = 0; landmark < graph_->size(); ++landmark) {
        for (const Fact fact : graph_->facts[landmark]) landmark_of[task_.fact_number(fact)] = landmark;
    }
    std::vector<std::vector<Achiever>> achievers(graph_->size());
    for (std::size_t op = 0; op < task_.operator_count(); ++op) {
        for (const GroundEffect& effect : task_.effects[op]) {
            const std::uint32_t landmark = landmark_of[task_.fact_number(effect.fact)];
            if (landmark != kNone) achievers[landmark].push_back({OperatorId(op), effect.condition});
        }
    }
    for (const std::vector<Achiever>& list : achievers) achievers_.append(list);
}

void LandmarkSumEvaluator::price(CostType cost_type) {
    const std::vector<std::int32_t> costs = operator_costs(task_, cost_type);
    const std::int32_t cheapest = costs.empty() ? 0 : *std::ranges::min_element(costs);
    for (std::size_t landmark = 0; landmark < graph_->size(); ++landmark) {
        std::int32_t first = kDeadEnd, any = kDeadEnd;
        for (const std::uint32_t op : graph_->first_achievers[landmark]) first = std::min(first, costs[op]);
        for (const Achiever& achiever : achievers_[landmark]) any = std::min(any, costs[achiever.op.index()]);
        if (graph_->derived[landmark]) first = any = cheapest;  // any operator may be the one
        // Without achievers the landmark is out of reach, or holds at the start.
        first_costs_.push_back(first == kDeadEnd ? cheapest : first);
        costs_.push_back(any == kDeadEnd ? cheapest : any);
    }
    const auto is_one = [](std::int32_t cost) { return cost == 1; };
    unit_ = std::ranges::all_of(first_costs_, is_one) && std::ranges::all_of(costs_, is_one);
}

void LandmarkSumEvaluator::start(StateId initial, StateView state) {
    status_.start(initial, state);
}

void LandmarkSumEvaluator::follow(StateId parent, OperatorId /*op*/, StateId child, StateView state) {
    status_.follow(parent, child, state);
}

Estimate LandmarkSumEvaluator::evaluate(StateView state) {
    preferred_.clear();
    looks_ = 0;
    if (goal_reached(state)) return 0;
    if (at_.valid() && status_.known(at_)) {
        status_.past(at_, past_);
    } else {
        status_.initial_past(state, past_);
    }
    status_.required_again(state, past_, required_again_);
    if (preferred_requested_) prefer(state);
    return std::max(sum(), 1);
}

Estimate LandmarkSumEvaluator::sum() const {
    std::int64_t sum = 0;
    std::size_t past_count = 0, again_count = 0;
    for (std::size_t word = 0; word < past_.size(); ++word) {
        past_count += static_cast<std::size_t>(std::popcount(past_[word]));
        again_count += static_cast<std::size_t>(std::popcount(required_again_[word]));
    }
    if (unit_) {
        sum = static_cast<std::int64_t>(graph_->size() - past_count + again_count);
    } else {
        for (std::size_t landmark = 0; landmark < graph_->size(); ++landmark) {
            if (!has_landmark(past_, landmark)) {
                sum += first_costs_[landmark];
            } else if (has_landmark(required_again_, landmark)) {
                sum += costs_[landmark];
            }
        }
    }
    return static_cast<Estimate>(std::min<std::int64_t>(sum, kDeadEnd - 1));
}

void LandmarkSumEvaluator::prefer(StateView state) {
    std::ranges::fill(wanted_, LandmarkWord{0});
    bool all_past = true;
    for (std::size_t landmark = 0; landmark < graph_->size(); ++landmark) {
        if (has_landmark(past_, landmark)) continue;
        all_past = false;
        if (!graph_->holds(landmark, state) && status_.leaf(landmark, past_)) {
            add_landmark(wanted_, landmark);
        }
    }
    if (all_past) wanted_ = required_again_;
    ++stamp_;
    if (stamps_.empty()) stamps_.resize(task_.operator_count(), 0);
    prefer(state, wanted_, false);
    if (preferred_.empty()) prefer(state, wanted_, true);
}

void LandmarkSumEvaluator::prefer(StateView state, LandmarkBits wanted, bool disjunctive) {
    for (std::size_t word = 0; word < wanted.size(); ++word) {
        for_each_landmark(wanted[word], word, [&](std::size_t landmark) {
            if (graph_->disjunctive(landmark) != disjunctive) return;
            looks_ += achievers_[landmark].size();
            for (const Achiever& achiever : achievers_[landmark]) {
                std::uint32_t& stamp = stamps_[achiever.op.index()];
                if (stamp == stamp_ || !all_hold(task_.preconditions[achiever.op.index()], state.data()) ||
                    !all_hold(task_.conditions[achiever.condition], state.data())) {
                    continue;
                }
                stamp = stamp_;
                preferred_.push_back(achiever.op);
            }
        });
    }
}

}  // namespace praxis
