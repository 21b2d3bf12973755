#include "search/ground/ground.hpp"

#include <utility>

#include "search/ground/encode.hpp"
#include "search/ground/instantiate.hpp"
#include "search/ground/invariants.hpp"
#include "search/ground/mutex_pruning.hpp"
#include "search/ground/reach.hpp"
#include "search/ground/refuse.hpp"
#include "search/ground/relations.hpp"
#include "search/ground/simplify.hpp"
#include "search/thread_time.hpp"

namespace praxis {
namespace {

class PhaseTimer {
  public:
    explicit PhaseTimer(std::vector<PhaseStatistics>& phases) : phases_(phases), start_(thread_seconds()) {}

    void done(std::string name, std::vector<std::pair<std::string, std::size_t>> counts) {
        const double now = thread_seconds();
        phases_.push_back({std::move(name), now - start_, peak_memory(), std::move(counts)});
        start_ = now;
    }

  private:
    std::vector<PhaseStatistics>& phases_;
    double start_;
};

std::size_t tuples_of(const grounding::Relations& relations, const std::vector<grounding::RelationId>& ids) {
    std::size_t count = 0;
    for (grounding::RelationId id : ids) count += relations[id].size();
    return count;
}

[[noreturn]] void refuse_unstratified(const LiftedTask& task) {
    const Location where = task.axioms.empty() ? task.goal.where : task.axioms.front().where;
    grounding::refuse(task, where, "the derived predicates depend on their own negation (no stratification)");
}

}  // namespace

GroundResult ground(const LiftedTask& lifted, const GroundOptions& options, const Budget& budget) {
    using namespace grounding;
    GroundResult result;
    PhaseTimer timer(result.phases);
    const auto out_of_budget = [&] {
        result.stop = budget.exhausted();
        return std::move(result);
    };

    const NormalTask normal = normalise(lifted);
    Relations relations(lifted, budget);
    timer.done("normalise", {{"schemas", lifted.schemas.size()}, {"axioms", lifted.axioms.size()}});

    const Reached reached = reach(normal, relations);
    if (!reached.complete) return out_of_budget();
    timer.done("reach",
               {{"derivations", reached.derivations}, {"actions", tuples_of(relations, reached.actions)}});

    Instantiated instantiated = instantiate(normal, reached, relations);
    if (!instantiated.complete) return out_of_budget();
    PropositionTask& propositions = instantiated.task;
    timer.done("instantiate", {{"atoms", propositions.atom_count},
                               {"operators", propositions.operator_count()},
                               {"axioms", propositions.heads.size()}});

    if (budget.exhausted() != Stop::none) return out_of_budget();
    if (!simplify_axioms(propositions)) refuse_unstratified(lifted);
    timer.done("simplify",
               {{"operators", propositions.operator_count()}, {"axioms", propositions.heads.size()}});

    MutexGroups groups = find_mutex_groups(propositions, relations, budget.within(options.invariant_seconds));
    if (budget.exhausted() != Stop::none) return out_of_budget();
    std::vector<std::pair<std::string, std::size_t>> counts{{"candidates", groups.candidates},
                                                            {"invariants", groups.invariants},
                                                            {"mutex groups", groups.groups.size()}};
    if (groups.left > 0) counts.emplace_back("candidates left", groups.left);
    timer.done("invariants", std::move(counts));

    prune_with_mutexes(propositions, groups);
    if (budget.exhausted() != Stop::none) return out_of_budget();
    timer.done("prune",
               {{"operators", propositions.operator_count()}, {"mutex groups", groups.groups.size()}});

    auto task = std::make_shared<FiniteDomainTask>(
        encode(lifted, propositions, groups, relations, reached.actions, options.prune_irrelevant, budget));
    if (budget.exhausted() != Stop::none) return out_of_budget();
    timer.done("encode", {{"variables", task->variable_count()},
                          {"facts", task->fact_count()},
                          {"operators", task->operator_count()},
                          {"axioms", task->axioms.size()}});
    result.task = std::move(task);
    return result;
}

}  // namespace praxis
