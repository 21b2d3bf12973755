#include "search/validate/derived.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <iterator>
#include <set>

#include "parser/diagnostic.hpp"

namespace praxis::validation {

namespace {

using Kind = Condition::Kind;
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
constexpr std::uint32_t kNone = FactTable::kNone;

/// Calls visit(predicate, positive) for each atom, seen from outside the condition.
template <class Visit>
void visit_atoms(const Condition& condition, bool positive, const Visit& visit) {
    if (condition.kind == Kind::atom) visit(condition.predicate, condition.positive == positive);
    const bool inside = condition.kind == Kind::none ? !positive : positive;
    for (const Condition& child : condition.children) visit_atoms(child, inside, visit);
}

}  // namespace

DerivedPredicates::DerivedPredicates(const LiftedTask& task, std::vector<FactTable>& tables,
                                     Evaluator& evaluator)
    : task_(task), tables_(tables), evaluator_(evaluator), component_of_(task.predicates.size(), kNone) {
    rules_.reserve(task.axioms.size());
    for (const Axiom& axiom : task.axioms) {
        Rule& rule = rules_.emplace_back();
        rule.axiom = &axiom;
        rule.body = compile(axiom.body);
        for (std::uint32_t i = 0; i < axiom.scope.parameter_count; ++i) rule.head.push_back(i);
    }
    find_components();
    check_strata();
    find_occurrences();
    find_inputs();
}

void DerivedPredicates::find_components() {
    Graph graph(task_.predicates.size());
    for (const Rule& rule : rules_) {
        std::vector<PredicateId> used;
        collect_predicates(rule.body, used);
        for (const PredicateId predicate : used)
            add_edge(rule.axiom->predicate.index(), predicate.index(), graph);
    }
    std::vector<std::uint32_t> number(task_.predicates.size());
    if (!number.empty()) strong_components(graph, number.data());

    // The numbers are in reverse topological order: what a component uses has a lower number.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> derived;
    std::vector<bool> has_rule(task_.predicates.size(), false);
    for (const Rule& rule : rules_) has_rule[rule.axiom->predicate.index()] = true;
    for (std::uint32_t p = 0; p < task_.predicates.size(); ++p) {
        if (has_rule[p] || task_.predicates[p].derived) derived.emplace_back(number[p], p);
    }
    std::sort(derived.begin(), derived.end());
    for (std::size_t i = 0; i < derived.size(); ++i) {
        if (i == 0 || derived[i].first != derived[i - 1].first) components_.emplace_back();
        components_.back().predicates.emplace_back(derived[i].second);
        component_of_[derived[i].second] = static_cast<std::uint32_t>(components_.size() - 1);
    }
    for (std::uint32_t i = 0; i < rules_.size(); ++i) {
        components_[component_of_[rules_[i].axiom->predicate.index()]].rules.push_back(i);
    }
}

void DerivedPredicates::check_strata() const {
    for (const Rule& rule : rules_) {
        const std::uint32_t own = component_of_[rule.axiom->predicate.index()];
        visit_atoms(rule.body, true, [&](PredicateId predicate, bool positive) {
            if (positive || component_of_[predicate.index()] != own) return;
            Diagnostic diagnostic;
            diagnostic.severity = Severity::unsupported;
            diagnostic.where = rule.axiom->where;
            diagnostic.message =
                "derived predicate '" + task_.predicates[rule.axiom->predicate.index()].name +
                "' depends on its own negation through '" + task_.predicates[predicate.index()].name +
                "', so it has no stratified meaning";
            const Sources none;
            diagnostic.placed = task_.sources && diagnostic.where.file < task_.sources->files.size();
            throw UnsupportedError(to_string(diagnostic, task_.sources ? *task_.sources : none),
                                   {diagnostic});
        });
    }
}

void DerivedPredicates::locate(const Condition& condition, Occurrence path, Component& component,
                               std::uint32_t index) {
    const auto own = [&](PredicateId predicate) {
        return std::find(component.predicates.begin(), component.predicates.end(), predicate) !=
               component.predicates.end();
    };
    switch (condition.kind) {
        case Kind::atom:
            if (!own(condition.predicate)) return;
            path.rule = index;
            path.atom = &condition;
            component.occurrences.push_back(std::move(path));
            return;
        case Kind::all:
            for (const Condition& child : condition.children) {
                Occurrence inside = path;
                for (const Condition& sibling : condition.children) {
                    if (&sibling != &child) inside.rest.push_back(&sibling);
                }
                locate(child, std::move(inside), component, index);
            }
            return;
        case Kind::exists:
            path.variables.insert(path.variables.end(), condition.variables.begin(),
                                  condition.variables.end());
            locate(condition.children.front(), std::move(path), component, index);
            return;
        case Kind::none:
            visit_atoms(condition, true, [&](PredicateId predicate, bool) {
                if (own(predicate)) rules_[index].again = true;
            });
            return;
        default:
            for (const Condition& child : condition.children) locate(child, path, component, index);
    }
}

void DerivedPredicates::find_occurrences() {
    for (Component& component : components_) {
        for (const std::uint32_t rule : component.rules) locate(rules_[rule].body, {}, component, rule);
    }
}

void DerivedPredicates::find_inputs() {
    for (std::uint32_t c = 0; c < components_.size(); ++c) {
        std::set<std::uint32_t> needs;
        std::set<PredicateId> inputs;
        for (const std::uint32_t rule : components_[c].rules) {
            std::vector<PredicateId> used;
            collect_predicates(rules_[rule].body, used);
            for (const PredicateId predicate : used) {
                const std::uint32_t other = component_of_[predicate.index()];
                if (other == kNone) {
                    inputs.insert(predicate);
                } else if (other != c) {
                    needs.insert(components_[other].needs.begin(), components_[other].needs.end());
                    inputs.insert(components_[other].inputs.begin(), components_[other].inputs.end());
                }
            }
        }
        needs.insert(c);
        components_[c].needs.assign(needs.begin(), needs.end());
        components_[c].inputs.assign(inputs.begin(), inputs.end());
    }
}

std::vector<std::uint32_t> DerivedPredicates::components_for(const Condition& condition) const {
    std::vector<PredicateId> used;
    collect_predicates(condition, used);
    std::set<std::uint32_t> result;
    for (const PredicateId predicate : used) {
        const std::uint32_t component = component_of_[predicate.index()];
        if (component == kNone) continue;
        result.insert(components_[component].needs.begin(), components_[component].needs.end());
    }
    return {result.begin(), result.end()};
}

std::uint64_t DerivedPredicates::version(const Component& component) const {
    std::uint64_t sum = 1;
    for (const PredicateId input : component.inputs) sum += tables_[input.index()].version();
    return sum;
}

void DerivedPredicates::update(std::span<const std::uint32_t> components) {
    for (const std::uint32_t number : components) {
        Component& component = components_[number];
        const std::uint64_t now = version(component);
        if (component.computed_at == now) continue;
        compute(component);
        component.computed_at = now;
    }
}

void DerivedPredicates::compute(Component& component) {
    queue_predicates_.clear();
    queue_rows_.clear();
    for (const PredicateId predicate : component.predicates) tables_[predicate.index()].clear();
    for (const std::uint32_t rule : component.rules) {
        const Condition* body = &rules_[rule].body;
        evaluator_.enter(rules_[rule].axiom->scope);
        run(rules_[rule], {&body, 1});
    }
    for (std::size_t next = 0;;) {
        for (; next < queue_rows_.size(); ++next) join(component, queue_predicates_[next], queue_rows_[next]);
        for (const std::uint32_t rule : component.rules) {
            if (!rules_[rule].again) continue;
            const Condition* body = &rules_[rule].body;
            evaluator_.enter(rules_[rule].axiom->scope);
            run(rules_[rule], {&body, 1});
        }
        if (next == queue_rows_.size()) return;
    }
}

void DerivedPredicates::run(const Rule& rule, std::span<const Condition* const> conditions) {
    const PredicateId predicate = rule.axiom->predicate;
    FactTable& table = tables_[predicate.index()];
    tuple_.resize(rule.head.size() + 1);
    const auto fill = [&] {
        for (std::size_t i = 0; i < rule.head.size(); ++i) tuple_[i] = evaluator_.value(rule.head[i]);
    };
    const Evaluator::Sink known = [&] {
        fill();
        return table.contains(tuple_.data());
    };
    const Evaluator::Sink sink = [&] {
        fill();
        if (table.insert(tuple_.data())) {
            queue_predicates_.push_back(predicate);
            queue_rows_.push_back(table.find(tuple_.data()));
        }
        return false;
    };
    evaluator_.enumerate(conditions, rule.head, sink, &known);
}

void DerivedPredicates::join(const Component& component, PredicateId predicate, std::uint32_t row) {
    for (const Occurrence& occurrence : component.occurrences) {
        if (occurrence.atom->predicate != predicate) continue;
        const Rule& rule = rules_[occurrence.rule];
        evaluator_.enter(rule.axiom->scope);
        if (!evaluator_.inhabited(occurrence.variables)) continue;
        if (!evaluator_.unify(*occurrence.atom, tables_[predicate.index()].row(row))) continue;
        run(rule, occurrence.rest);
    }
}

}  // namespace praxis::validation
