#include "search/ground/encode.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "search/ground/refuse.hpp"
#include "search/ground/relevance.hpp"
#include "search/ground/simplify.hpp"
#include "search/ground/variables.hpp"

namespace praxis::grounding {
namespace {

class Encoder {
  public:
    Encoder(const LiftedTask& lifted, const PropositionTask& task, const MutexGroups& mutex_groups,
            const Relations& relations, const std::vector<RelationId>& actions, const Budget& budget)
        : lifted_(lifted),
          task_(task),
          mutex_groups_(mutex_groups),
          relations_(relations),
          actions_(actions),
          budget_(budget),
          variables_(choose_variables(task, mutex_groups.groups)) {}

    FiniteDomainTask run(bool prune) {
        layers_ = axiom_layers(task_);  // stratified, or simplify_axioms would have said so
        encode_variables();
        if (!encode_list(task_.goal, made_.goal)) task_reachable_ = false;
        if (!task_reachable_) return unsolvable();
        encode_operators();
        encode_axioms();
        encode_mutex_groups();
        if (budget_.exhausted() != Stop::none) return std::move(made_);
        if (prune) made_ = without_irrelevant(std::move(made_));
        return std::move(made_);
    }

    FiniteDomainTask unsolvable() {
        FiniteDomainTask task;
        task.domain_sizes = {2};
        task.axiom_layers = {-1};
        task.initial_values = {0};
        task.first_fact = {0, 2};
        task.fact_names.symbols = {"unreachable-goal"};
        for (int i = 0; i < 2; ++i) task.fact_names.names.append(std::vector<std::uint32_t>{0});
        task.fact_forms = {FiniteDomainTask::FactForm::negated_atom, FiniteDomainTask::FactForm::atom};
        task.conditions.close();
        task.goal = {{0, 1}};
        task.proved_unsolvable = true;
        task.unit_cost = !lifted_.minimize_cost;
        return task;
    }

  private:
    Fact fact(AtomId atom) const { return variables_.fact_of[atom]; }

    /// The fact that says that a literal holds.
    Fact encode(Literal literal) const {
        const AtomId atom = atom_of(literal);
        const Fact fact = variables_.fact_of[atom];
        if (!is_negative(literal)) return fact;
        if (variables_.shadow_of[atom] != Variables::kNone) return {variables_.shadow_of[atom], 1};
        return {fact.variable, 1 - fact.value};
    }

    /// Sorted by variable; false if two different values of one variable are asked for.
    bool encode_list(std::span<const Literal> literals, std::vector<Fact>& facts) const {
        facts.clear();
        for (Literal literal : literals)
            if (!is_negative(literal)) facts.push_back(fact(atom_of(literal)));
        const std::size_t positives = facts.size();
        for (Literal literal : literals) {
            if (!is_negative(literal)) continue;
            const Fact own = fact(atom_of(literal));
            const auto same =
                std::find_if(facts.begin(), facts.begin() + static_cast<std::ptrdiff_t>(positives),
                             [&](Fact other) { return other.variable == own.variable; });
            if (same != facts.begin() + static_cast<std::ptrdiff_t>(positives)) {
                if (same->value == own.value) return false;
                continue;
            }
            facts.push_back(encode(literal));
        }
        std::sort(facts.begin(), facts.end());
        facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
        for (std::size_t i = 1; i < facts.size(); ++i)
            if (facts[i].variable == facts[i - 1].variable) return false;
        return true;
    }

    void encode_variables() {
        using Form = FiniteDomainTask::FactForm;
        std::uint32_t next_fact = 0;
        name_symbols(made_.fact_names, lifted_.predicates);
        const auto none_symbol = static_cast<std::uint32_t>(made_.fact_names.symbols.size());
        made_.fact_names.symbols.emplace_back("<none of those>");
        std::vector<std::uint32_t> words;
        for (std::size_t v = 0; v < variables_.count(); ++v) {
            const auto members = variables_.members[v];
            const bool derived = task_.derived[members.front()];
            made_.domain_sizes.push_back(variables_.size_of(v));
            made_.axiom_layers.push_back(derived ? layers_[members.front()] : -1);
            made_.first_fact.push_back(next_fact);
            next_fact += static_cast<std::uint32_t>(variables_.size_of(v));
            std::int32_t initial = variables_.none_of(v);
            for (std::size_t value = 0; value < members.size(); ++value) {
                if (task_.initial[members[value]]) initial = static_cast<std::int32_t>(value);
                name_atom(members[value], words);
                made_.fact_names.names.append(words);
                made_.fact_forms.push_back(Form::atom);
            }
            if (variables_.has_none[v]) {
                if (members.size() > 1) words.assign(1, none_symbol);
                made_.fact_names.names.append(words);
                made_.fact_forms.push_back(members.size() > 1 ? Form::none_of_those : Form::negated_atom);
            }
            made_.initial_values.push_back(initial);
        }
        made_.first_fact.push_back(next_fact);
    }

    template <class Named>
    void name_symbols(NameTable& table, const std::vector<Named>& kinds) const {
        for (const auto& object : lifted_.objects) table.symbols.push_back(object.name);
        for (const Named& kind : kinds) table.symbols.push_back(kind.name);
    }

    void name_atom(AtomId atom, std::vector<std::uint32_t>& words) {
        words.clear();
        if (atom >= task_.auxiliary_begin()) {
            words.push_back(static_cast<std::uint32_t>(made_.fact_names.symbols.size()));
            made_.fact_names.symbols.push_back("auxiliary-" + std::to_string(atom - task_.auxiliary_begin()));
            return;
        }
        const auto next = std::upper_bound(task_.first_atom.begin(), task_.first_atom.end(), atom);
        const auto predicate = static_cast<std::uint32_t>(next - task_.first_atom.begin() - 1);
        words.push_back(static_cast<std::uint32_t>(lifted_.objects.size()) + predicate);
        const TupleStore& store = relations_[predicate];
        const Object* row = store.row(atom - task_.first_atom[predicate]);
        words.insert(words.end(), row, row + store.arity());
    }

    void encode_operators() {
        name_symbols(made_.operator_names, lifted_.schemas);
        made_.unit_cost = !lifted_.minimize_cost;
        scale_costs();
        made_.conditions.close();
        std::vector<std::uint32_t> words;
        const auto reserve = task_.operator_count();
        made_.preconditions.reserve(reserve, task_.preconditions.total());
        made_.effects.reserve(reserve, task_.effects.total());
        for (std::size_t o = 0; o < task_.operator_count(); ++o) {
            if (o % 4096 == 0 && budget_.exhausted() != Stop::none) return;
            if (!encode_list(task_.preconditions[o], precondition_)) continue;
            encode_effects(o);
            if (effects_.empty()) continue;
            made_.preconditions.append(precondition_);
            made_.effects.append(effects_);
            made_.costs.push_back(cost_of(o));
            const TupleStore& store = relations_[actions_[task_.schemas[o]]];
            const Object* row = store.row(task_.rows[o]);
            words.assign(1, static_cast<std::uint32_t>(lifted_.objects.size()) + task_.schemas[o]);
            words.insert(words.end(), row, row + store.arity());
            made_.operator_names.names.append(words);
        }
    }

    void scale_costs() {
        std::int64_t scale = 1;
        for (const Rational& cost : task_.costs) {
            const std::int64_t factor = cost.denominator() / std::gcd(scale, cost.denominator());
            if (__builtin_mul_overflow(scale, factor, &scale)) scale = 0;
            if (scale == 0) break;
        }
        Rational largest;
        for (const Rational& cost : task_.costs) largest = std::max(largest, cost);
        try {
            if (scale == 0 ||
                largest * Rational(scale) > Rational(std::numeric_limits<std::int32_t>::max() / 2))
                throw std::overflow_error("costs");
        } catch (const std::overflow_error&) {
            refuse(lifted_, cost_place(),
                   "action costs, brought to a common denominator, are larger than 2^30 (the largest is " +
                       largest.to_string() + ")");
        }
        made_.cost_scale = scale;
    }

    Location cost_place() const {
        for (const Schema& schema : lifted_.schemas)
            if (schema.cost) return schema.cost->where;
        return lifted_.goal.where;
    }

    std::int32_t cost_of(std::size_t o) const {
        if (task_.costs.empty()) return 1;
        const Rational scaled = task_.costs[o] * Rational(made_.cost_scale);
        return static_cast<std::int32_t>(scaled.numerator());
    }

    const Fact* required(std::int32_t variable) const {
        const auto found = std::lower_bound(precondition_.begin(), precondition_.end(), Fact{variable, 0});
        return found != precondition_.end() && found->variable == variable ? &*found : nullptr;
    }

    void encode_effects(std::size_t o) {
        effects_.clear();
        for (const PropositionEffect& effect : task_.effects[o]) {
            const AtomId atom = atom_of(effect.literal);
            if (!encode_list(task_.conditions[effect.condition], condition_)) continue;
            if (!simplify_condition()) continue;
            if (variables_.shadow_of[atom] != Variables::kNone)
                add_effect({variables_.shadow_of[atom], is_negative(effect.literal) ? 1 : 0});
            if (!is_negative(effect.literal))
                add_effect(fact(atom));
            else if (!overridden(task_, variables_, o, effect))
                add_delete(atom);
        }
        drop_idle_effects();
    }

    /// Leaves out what the precondition says; false if it says the contrary.
    bool simplify_condition() {
        std::size_t kept = 0;
        for (Fact fact : condition_) {
            const Fact* known = required(fact.variable);
            if (known == nullptr)
                condition_[kept++] = fact;
            else if (known->value != fact.value)
                return false;
        }
        condition_.resize(kept);
        return true;
    }

    void add_delete(AtomId atom) {
        const Fact lost = fact(atom);
        const Fact none{lost.variable, variables_.none_of(static_cast<std::size_t>(lost.variable))};
        if (variables_.members[static_cast<std::size_t>(lost.variable)].size() == 1) return add_effect(none);
        if (const Fact* known = required(lost.variable)) {
            if (known->value == lost.value) add_effect(none);
            return;
        }
        const auto same = std::find_if(condition_.begin(), condition_.end(),
                                       [&](Fact fact) { return fact.variable == lost.variable; });
        if (same != condition_.end()) {
            if (same->value == lost.value) add_effect(none);
            return;
        }
        const std::vector<Fact> outer = condition_;
        condition_.insert(std::lower_bound(condition_.begin(), condition_.end(), lost), lost);
        add_effect(none);
        condition_ = outer;
    }

    void add_effect(Fact fact) {
        std::uint32_t condition = 0;
        if (!condition_.empty()) {
            condition = static_cast<std::uint32_t>(made_.conditions.size());
            made_.conditions.append(condition_);
        }
        effects_.push_back({fact, condition});
    }

    /// Effects that set what the precondition requires, where nothing else touches the variable.
    void drop_idle_effects() {
        kept_effects_.clear();
        for (const GroundEffect& effect : effects_) {
            const Fact* known = required(effect.fact.variable);
            const bool idle = known != nullptr && known->value == effect.fact.value &&
                              std::none_of(effects_.begin(), effects_.end(), [&](const GroundEffect& other) {
                                  return other.fact.variable == effect.fact.variable &&
                                         other.fact.value != effect.fact.value;
                              });
            if (!idle) kept_effects_.push_back(effect);
        }
        effects_.swap(kept_effects_);
    }

    void encode_axioms() {
        std::vector<Fact> body;
        for (std::size_t a = 0; a < task_.heads.size(); ++a) {
            if (!encode_list(task_.bodies[a], body)) continue;
            made_.axioms.push_back({fact(task_.heads[a])});
            made_.axiom_bodies.append(body);
        }
    }

    void encode_mutex_groups() {
        std::vector<Fact> facts;
        for (std::size_t g = 0; g < mutex_groups_.groups.size(); ++g) {
            facts.clear();
            for (AtomId atom : mutex_groups_.groups[g]) facts.push_back(fact(atom));
            const bool one_variable = std::all_of(facts.begin(), facts.end(), [&](Fact fact) {
                return fact.variable == facts.front().variable;
            });
            if (one_variable) continue;
            std::sort(facts.begin(), facts.end());
            made_.mutex_groups.append(facts);
        }
    }

    const LiftedTask& lifted_;
    const PropositionTask& task_;
    const MutexGroups& mutex_groups_;
    const Relations& relations_;
    const std::vector<RelationId>& actions_;
    const Budget& budget_;
    Variables variables_;
    std::vector<std::int32_t> layers_;
    FiniteDomainTask made_;
    bool task_reachable_ = true;

    std::vector<Fact> precondition_;
    std::vector<Fact> condition_;
    std::vector<GroundEffect> effects_;
    std::vector<GroundEffect> kept_effects_;
};

}  // namespace

FiniteDomainTask encode(const LiftedTask& lifted, const PropositionTask& task,
                        const MutexGroups& mutex_groups, const Relations& relations,
                        const std::vector<RelationId>& actions, bool prune_irrelevant, const Budget& budget) {
    Encoder encoder(lifted, task, mutex_groups, relations, actions, budget);
    return task.goal_reachable ? encoder.run(prune_irrelevant) : encoder.unsolvable();
}

}  // namespace praxis::grounding
