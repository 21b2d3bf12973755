#include "search/improve/neighbourhood.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <queue>

#include "search/improve/plan_execution.hpp"
#include "search/state/state_registry.hpp"

namespace praxis {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr std::uint32_t kStatesBetweenLooks = 64;
constexpr std::uint32_t kPopsBetweenLooks = 4096;
// The time that finding the cheapest ways takes at most, as a share of the time that making the graph took.
constexpr double kShareOfWays = 0.3;

class NeighbourhoodSearch {
  public:
    NeighbourhoodSearch(const PreparedTask::Parts& parts, const Query& query, const Budget& budget,
                        const NeighbourhoodLimits& limits)
        : parts_(parts),
          execution_(parts, query),
          budget_(budget),
          limits_(limits),
          registry_(parts.packer, 0),
          values_(parts.task->variable_count()) {}

    Neighbourhood run(std::vector<OperatorId> plan) {
        const auto trace = execution_.trace(plan);
        if (!trace) return {std::move(plan), false};
        add_plan(plan, *trace);
        expand_all();
        find_cheapest_ways();
        if (goal_ == kNone || nodes_[goal_].cost >= cost_of(*parts_.task, plan)) {
            return {std::move(plan), complete_};
        }
        return {steps_to(goal_), complete_};
    }

  private:
    struct Edge {
        std::uint32_t to;
        OperatorId op;
    };
    struct Node {
        PlanCost cost{std::numeric_limits<std::int64_t>::max(), 0};
        std::uint32_t parent = kNone;
        OperatorId op;
    };

    struct QueueEntry {
        PlanCost cost;
        std::uint32_t state;
        friend auto operator<=>(const QueueEntry&, const QueueEntry&) = default;
    };

    // The states of the plan come first; of each state's steps the last counts.
    void add_plan(const std::vector<OperatorId>& plan, const std::vector<std::uint32_t>& trace) {
        const std::size_t words = registry_.word_count();
        std::vector<std::uint32_t> ids;
        for (std::size_t i = 0; i <= plan.size(); ++i) {
            const std::uint32_t* state = trace.data() + i * words;
            ids.push_back(registry_.intern(state, registry_.hash(state)).first.index());
        }
        plan_edges_.resize(registry_.size(), {kNone, OperatorId()});
        for (std::size_t i = 0; i < plan.size(); ++i) plan_edges_[ids[i]] = {ids[i + 1], plan[i]};
    }

    // Expands states in the order of their ids until the limits are met.
    void expand_all() {
        complete_ = true;
        for (std::uint32_t state = 0; state < registry_.size(); ++state) {
            if (complete_ && full(state)) complete_ = false;
            if (complete_) {
                expand(state);
            } else if (state < plan_edges_.size()) {
                is_goal_.push_back(plan_edges_[state].to == kNone);
                if (plan_edges_[state].to != kNone) edges_.push_back(plan_edges_[state]);
            } else {
                return;
            }
            first_edge_.push_back(edges_.size());
        }
    }

    void expand(std::uint32_t state) {
        execution_.read(registry_.words(StateId(state)), values_);
        is_goal_.push_back(execution_.goal(values_));
        parts_.generator.for_each(values_.data(), [&](OperatorId op) {
            parts_.transitions.apply(op, values_.data(), registry_.candidate_from(StateId(state)));
            const std::uint32_t to = registry_.intern().first.index();
            if (to != state) edges_.push_back({to, op});
        });
    }

    bool full(std::uint32_t state) {
        if (registry_.size() >= limits_.max_states) return true;
        if (state % kStatesBetweenLooks != 0) return false;
        const std::size_t bytes = registry_.memory() + edges_.capacity() * sizeof(Edge) +
                                  registry_.size() * (sizeof(Node) + sizeof(QueueEntry));
        if (bytes > limits_.max_bytes || budget_.exhausted() != Stop::none) return true;
        const std::chrono::duration<double> spent = Budget::Clock::now() - start_;
        return budget_.seconds_left() < spent.count() * kShareOfWays;
    }

    // Dijkstra's algorithm from the initial state, whose id is 0, to the first goal state.
    void find_cheapest_ways() {
        nodes_.resize(registry_.size());
        nodes_[0].cost = {};
        std::priority_queue<QueueEntry, std::vector<QueueEntry>, std::greater<>> queue;
        queue.push({{}, 0});
        for (std::uint32_t pops = 1; !queue.empty(); ++pops) {
            if (pops % kPopsBetweenLooks == 0 && budget_.exhausted() != Stop::none) {
                complete_ = false;
                return;
            }
            const QueueEntry entry = queue.top();
            queue.pop();
            if (entry.cost > nodes_[entry.state].cost) continue;
            if (is_goal(entry.state)) {
                goal_ = entry.state;
                return;
            }
            if (entry.state >= is_goal_.size()) continue;
            for (std::size_t i = first_edge_[entry.state]; i < first_edge_[entry.state + 1]; ++i) {
                const Edge edge = edges_[i];
                const PlanCost cost = entry.cost + execution_.cost(edge.op);
                if (cost >= nodes_[edge.to].cost) continue;
                nodes_[edge.to] = {cost, entry.state, edge.op};
                queue.push({cost, edge.to});
            }
        }
    }

    // States that were not expanded are only now looked at.
    bool is_goal(std::uint32_t state) {
        if (state < is_goal_.size()) return is_goal_[state];
        execution_.read(registry_.words(StateId(state)), values_);
        return execution_.goal(values_);
    }

    std::vector<OperatorId> steps_to(std::uint32_t state) const {
        std::vector<OperatorId> steps;
        for (; nodes_[state].parent != kNone; state = nodes_[state].parent) steps.push_back(nodes_[state].op);
        std::ranges::reverse(steps);
        return steps;
    }

    const PreparedTask::Parts& parts_;
    PlanExecution execution_;
    const Budget& budget_;
    Budget::Clock::time_point start_ = Budget::Clock::now();
    NeighbourhoodLimits limits_;
    StateRegistry registry_;
    bool complete_ = false;
    std::vector<Edge> plan_edges_;            // by state of the plan
    std::vector<Edge> edges_;                 // those of one state one after the other
    std::vector<std::size_t> first_edge_{0};  // by expanded state; one more
    std::vector<bool> is_goal_;               // by expanded state
    std::vector<Node> nodes_;                 // by state
    std::uint32_t goal_ = kNone;
    std::vector<std::int32_t> values_;
};

}  // namespace

Neighbourhood search_neighbourhood(const PreparedTask& prepared, const Query& query,
                                   std::vector<OperatorId> plan, const Budget& budget,
                                   const NeighbourhoodLimits& limits) {
    return NeighbourhoodSearch(prepared.parts(), query, budget, limits).run(std::move(plan));
}

}  // namespace praxis
