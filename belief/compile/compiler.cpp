#include "belief/compile/compiler.hpp"

#include <utility>

namespace praxis::belief {

void Compiler::run() {
    implied_.resize(physical_.fact_count());
    implied_done_.assign(physical_.fact_count(), false);
    find_changeable();
    collect_axioms();
    make_variables();
    make_axioms();
    find_moments();
    find_needed();
    make_operators();
    make_sensors();
    for (const Fact& fact : physical_.goal) task_->goal.push_back(known(fact));
    std::sort(task_->goal.begin(), task_->goal.end());
    add_mutex_groups();
    number_facts();
    task_->unit_cost = false;
    task_->cost_scale = physical_.cost_scale * kActionUnit;
    task_->proved_unsolvable = physical_.proved_unsolvable;
    result_.task_ = std::move(task_);
}

std::optional<Compiler::Condition> Compiler::conjunction(Condition facts) {
    std::sort(facts.begin(), facts.end());
    facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
    for (std::size_t i = 1; i < facts.size(); ++i)
        if (facts[i - 1].variable == facts[i].variable) return std::nullopt;
    return facts;
}

Compilation::Compilation(std::shared_ptr<const BeliefTask> belief, const CompilationOptions& options)
    : belief_(std::move(belief)),
      options_(options),
      components_(find_components(*belief_, options.most_cases)) {
    Compiler(*this).run();
}

}  // namespace praxis::belief
