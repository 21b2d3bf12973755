#include "search/state/axiom_evaluator.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace praxis {

AxiomEvaluator::AxiomEvaluator(const FiniteDomainTask& task) {
    std::map<std::int32_t, std::vector<Derived>> by_layer;
    for (std::uint32_t variable = 0; variable < task.variable_count(); ++variable) {
        if (task.axiom_layers[variable] < 0) continue;
        const std::int32_t value = task.initial_values[variable];
        by_layer[task.axiom_layers[variable]].push_back(
            {variable, task.fact_number({static_cast<std::int32_t>(variable), value}), value});
    }
    for (auto& layer : by_layer) layers_.push_back(std::move(layer.second));
    if (layers_.empty()) return;

    std::vector<bool> occurs(task.variable_count(), false);
    first_watcher_.assign(task.fact_count() + 1, 0);
    for (const Fact& fact : task.axiom_bodies.items()) {
        ++first_watcher_[task.fact_number(fact)];
        occurs[static_cast<std::size_t>(fact.variable)] = true;
    }
    std::partial_sum(first_watcher_.begin(), first_watcher_.end(), first_watcher_.begin());
    watchers_.resize(task.axiom_bodies.total());
    for (std::uint32_t axiom = 0; axiom < task.axioms.size(); ++axiom) {
        const Fact head = task.axioms[axiom].head;
        heads_.push_back({static_cast<std::uint32_t>(head.variable), head.value, task.fact_number(head)});
        const auto body = task.axiom_bodies[axiom];
        body_sizes_.push_back(static_cast<std::uint32_t>(body.size()));
        if (body.empty()) unconditional_.push_back(axiom);
        for (const Fact& fact : body) watchers_[--first_watcher_[task.fact_number(fact)]] = axiom;
    }
    for (std::uint32_t variable = 0; variable < task.variable_count(); ++variable) {
        if (occurs[variable] && task.axiom_layers[variable] < 0) {
            basic_.push_back({variable, task.first_fact[variable]});
        }
    }
}

void AxiomEvaluator::derive(std::int32_t* values, Scratch& scratch) const {
    for (const auto& layer : layers_) {
        for (const Derived& derived : layer) values[derived.variable] = derived.default_value;
    }
    scratch.unsatisfied_.resize(body_sizes_.size());
    std::copy(body_sizes_.begin(), body_sizes_.end(), scratch.unsatisfied_.begin());
    scratch.queue_.clear();

    const auto fire = [&](std::uint32_t axiom) {
        const Head& head = heads_[axiom];
        if (values[head.variable] == head.value) return;
        values[head.variable] = head.value;
        scratch.queue_.push_back(head.fact);
    };
    const auto make_true = [&](std::uint32_t fact) {
        for (std::uint32_t i = first_watcher_[fact]; i < first_watcher_[fact + 1]; ++i) {
            if (--scratch.unsatisfied_[watchers_[i]] == 0) fire(watchers_[i]);
        }
    };
    const auto close = [&] {
        while (!scratch.queue_.empty()) {
            const std::uint32_t fact = scratch.queue_.back();
            scratch.queue_.pop_back();
            make_true(fact);
        }
    };

    for (std::uint32_t axiom : unconditional_) fire(axiom);
    for (const Basic& basic : basic_)
        make_true(basic.first_fact + static_cast<std::uint32_t>(values[basic.variable]));
    close();
    for (const auto& layer : layers_) {
        for (const Derived& derived : layer) {
            if (values[derived.variable] == derived.default_value) make_true(derived.default_fact);
        }
        close();
    }
}

std::size_t AxiomEvaluator::memory() const {
    std::size_t bytes = basic_.capacity() * sizeof(Basic) + heads_.capacity() * sizeof(Head) +
                        (body_sizes_.capacity() + unconditional_.capacity() + first_watcher_.capacity() +
                         watchers_.capacity()) *
                            sizeof(std::uint32_t);
    for (const auto& layer : layers_) bytes += layer.capacity() * sizeof(Derived);
    return bytes;
}

}  // namespace praxis
