// The delete relaxation as its definition says it, by fixpoint iteration over all facts: what the fast ones
// must agree with.
#pragma once

#include <algorithm>
#include <functional>
#include <set>

#include "tests/search/evaluators/random_task.hpp"

namespace praxis::test {

class NaiveRelaxation {
  public:
    NaiveRelaxation(const FiniteDomainTask& task, std::vector<std::int32_t> costs, bool sum)
        : task_(task), costs_(std::move(costs)), sum_(sum) {
        for (std::size_t v = 0; v < task.variable_count(); ++v) {
            recursive_.push_back(depends(static_cast<std::int32_t>(v), static_cast<std::int32_t>(v)));
        }
    }

    /// Only these operators may be used.
    void restrict_to(std::set<std::size_t> operators) {
        restricted_ = true;
        operators_ = std::move(operators);
    }

    Estimate goal_cost(const State& state) {
        cost_.assign(task_.fact_count(), kInfinite);
        for (std::size_t v = 0; v < state.size(); ++v) {
            const auto variable = static_cast<std::int32_t>(v);
            cost_[task_.fact_number({variable, state[v]})] = 0;
            if (task_.derived(variable) && recursive_[v]) {
                cost_[task_.fact_number({variable, task_.initial_values[v]})] = 0;
            }
        }
        do {
            changed_ = false;
            apply_operators();
            apply_axioms();
            apply_defaults();
        } while (changed_);
        const std::int64_t cost = combined(task_.goal, {});
        return cost >= kInfinite ? kDeadEnd : static_cast<Estimate>(cost);
    }

  private:
    static constexpr std::int64_t kInfinite = std::int64_t{1} << 40;

    std::int64_t cost(Fact fact) const { return cost_[task_.fact_number(fact)]; }

    void offer(Fact fact, std::int64_t offered) {
        std::int64_t& known = cost_[task_.fact_number(fact)];
        if (offered >= known) return;
        known = offered;
        changed_ = true;
    }

    std::int64_t join(std::int64_t a, std::int64_t b) const {
        return std::min(kInfinite, sum_ ? a + b : std::max(a, b));
    }

    std::int64_t combined(std::span<const Fact> a, std::span<const Fact> b) const {
        std::set<Fact> facts(a.begin(), a.end());
        facts.insert(b.begin(), b.end());
        std::int64_t total = 0;
        std::int32_t last = -1;
        for (const Fact fact : facts) {
            if (fact.variable == last) return kInfinite;
            last = fact.variable;
            total = join(total, cost(fact));
        }
        return total;
    }

    void apply_operators() {
        for (std::size_t op = 0; op < task_.operator_count(); ++op) {
            if (restricted_ && !operators_.contains(op)) continue;
            for (const GroundEffect& effect : task_.effects[op]) {
                const std::int64_t needed =
                    combined(task_.preconditions[op], task_.conditions[effect.condition]);
                if (needed < kInfinite) offer(effect.fact, needed + costs_[op]);
            }
        }
    }

    void apply_axioms() {
        for (std::size_t i = 0; i < task_.axioms.size(); ++i) {
            offer(task_.axioms[i].head, combined(task_.axiom_bodies[i], {}));
        }
    }

    void apply_defaults() {
        for (std::int32_t v = 0; v < static_cast<std::int32_t>(task_.variable_count()); ++v) {
            if (!task_.derived(v) || recursive_[static_cast<std::size_t>(v)]) continue;
            std::int64_t total = 0;
            for (std::size_t i = 0; i < task_.axioms.size(); ++i) {
                if (task_.axioms[i].head.variable == v) total = join(total, failure_cost(i));
            }
            offer({v, task_.initial_values[static_cast<std::size_t>(v)]}, total);
        }
    }

    std::int64_t failure_cost(std::size_t axiom) const {
        std::int64_t best = kInfinite;
        for (const Fact fact : task_.axiom_bodies[axiom]) {
            for (std::int32_t value = 0; value < task_.domain_sizes[static_cast<std::size_t>(fact.variable)];
                 ++value) {
                if (value != fact.value) best = std::min(best, cost({fact.variable, value}));
            }
        }
        return best;
    }

    /// Whether `from` needs the non-default value of `to`, directly or not.
    bool depends(std::int32_t from, std::int32_t to) const {
        std::set<std::int32_t> seen;
        std::vector<std::int32_t> open{from};
        while (!open.empty()) {
            const std::int32_t variable = open.back();
            open.pop_back();
            for (std::size_t i = 0; i < task_.axioms.size(); ++i) {
                if (task_.axioms[i].head.variable != variable) continue;
                for (const Fact fact : task_.axiom_bodies[i]) {
                    const auto v = static_cast<std::size_t>(fact.variable);
                    if (task_.axiom_layers[v] < 0 || fact.value == task_.initial_values[v]) continue;
                    if (fact.variable == to) return true;
                    if (seen.insert(fact.variable).second) open.push_back(fact.variable);
                }
            }
        }
        return false;
    }

    const FiniteDomainTask& task_;
    std::vector<std::int32_t> costs_;
    bool sum_;
    bool restricted_ = false;
    std::set<std::size_t> operators_;
    std::vector<char> recursive_;
    std::vector<std::int64_t> cost_;
    bool changed_ = false;
};

}  // namespace praxis::test
