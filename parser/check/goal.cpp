#include "parser/check/goal.hpp"

#include <algorithm>

#include "parser/check/conditions.hpp"

namespace praxis::check {
namespace {

using syntax::Node;
using syntax::NodeKind;
using syntax::Word;

class StaticGoals {
  public:
    StaticGoals(Context& context, const std::vector<TupleIndex>& initial_atoms)
        : context_(context), initial_atoms_(initial_atoms) {}

    void check(const Formula& formula, bool wanted = true) {
        if (formula.kind == Connective::conjunction && wanted) {
            for (const Formula& child : formula.children) check(child, true);
        } else if (formula.kind == Connective::negation) {
            check(formula.children.front(), !wanted);
        } else if (formula.kind == Connective::atom) {
            check_atom(formula, wanted);
        }
    }

  private:
    void check_atom(const Formula& atom, bool wanted) {
        const Predicate& predicate = context_.task.predicates[atom.predicate.index()];
        if (predicate.fluent || predicate.derived) return;
        tuple_.clear();
        std::string fact = predicate.name;
        for (const Term term : atom.terms) {
            if (term.is_variable()) return;
            tuple_.push_back(term.object_id());
            fact += ' ' + context_.task.objects[term.object_id().index()].name;
        }
        const bool holds = initial_atoms_[atom.predicate.index()].find(tuple_) != TupleIndex::kNone;
        if (holds == wanted) return;
        context_.reporter.warning(atom.where, std::string("the goal cannot be reached: (") + fact + ") is " +
                                                  (holds ? "true" : "false") + " and no action changes it");
    }

    Context& context_;
    const std::vector<TupleIndex>& initial_atoms_;
    std::vector<ObjectId> tuple_;
};

}  // namespace

void check_goal(Context& context, const syntax::Tree& problem) {
    if (problem.goals.empty()) {
        const Location where = problem.name ? problem.where(*problem.name) : Location{problem.file, 0, 0};
        context.reporter.error(where, "the problem has no ':goal'");
        return;
    }
    for (std::size_t i = 1; i < problem.goals.size(); ++i) {
        context.reporter.error(problem.where(problem.nodes[problem.goals[i]]), "a second goal",
                               "join them with 'and'");
    }
    ScopeBuilder scope(context, problem, context.task.goal_scope);
    context.task.goal = check_condition(scope, problem.goals.front());
}

void check_metric(Context& context, const syntax::Tree& problem) {
    for (std::size_t i = 0; i < problem.metrics.size(); ++i) {
        const syntax::Metric& metric = problem.metrics[i];
        const Node& node = problem.nodes[metric.expression];
        if (i > 0) {
            context.reporter.error(problem.where(metric.direction), "a second metric");
            continue;
        }
        const bool plain =
            node.kind == NodeKind::word || (node.kind == NodeKind::atom && node.arguments.empty());
        const bool minimize = metric.direction.symbol == Word::minimize;
        if (plain && minimize && node.head.symbol == Word::total_cost) {
            context.task.minimize_cost = true;
            context.use(Feature::action_costs, problem.where(metric.direction));
        } else if (plain && minimize && node.head.symbol == Word::total_time) {
            context.reporter.warning(problem.where(node), "the task has no durations; each action costs one");
        } else {
            context.reporter.unsupported(problem.where(metric.direction),
                                         "metrics other than 'minimize (total-cost)'");
        }
    }
}

void check_static_goals(Context& context, const std::vector<TupleIndex>& initial_atoms) {
    if (!context.reporter.has_errors()) StaticGoals(context, initial_atoms).check(context.task.goal);
}

}  // namespace praxis::check
