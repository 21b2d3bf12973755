#include "tests/search/ground/equivalence.hpp"

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "search/ground/ground.hpp"
#include "tests/search/ground/state_space.hpp"

namespace praxis::test {

namespace {

/// Follows the lifted task's states in the ground task.
class Lockstep {
  public:
    Lockstep(const LiftedTask& task, const LiftedSpace& space, const FiniteDomainTask& ground)
        : task_(task), space_(space), ground_(ground) {}

    std::string run() {
        if (std::string problem = match_facts(); !problem.empty()) return problem;
        if (std::string problem = match_operators(); !problem.empty()) return problem;
        values_.resize(space_.states.size());
        values_[0] = initial_state(ground_);
        std::set<Values> distinct;
        for (std::size_t i = 0; i < space_.edges.size(); ++i) {
            std::string problem = compare_state(i);
            if (problem.empty()) problem = compare_successors(i);
            if (!problem.empty()) return problem + " in the state {" + describe(i) + "}";
        }
        // Those that were not expanded still must look right.
        for (std::size_t i = space_.edges.size(); i < values_.size(); ++i) {
            if (values_[i].empty()) continue;
            const std::string problem = compare_state(i);
            if (!problem.empty()) return problem + " in the state {" + describe(i) + "}";
        }
        return "";
    }

    bool shadowed() const { return shadowed_; }

  private:
    std::string match_facts() {
        std::map<std::string, std::size_t> atoms;
        for (std::size_t a = 0; a < space_.semantics.atom_count(); ++a)
            atoms.emplace(space_.semantics.atom_name(a), a);
        represented_.assign(atoms.size(), false);
        for (std::int32_t v = 0; v < static_cast<std::int32_t>(ground_.variable_count()); ++v) {
            for (std::int32_t value = 0; value < ground_.domain_sizes[at(v)]; ++value) {
                using Form = FiniteDomainTask::FactForm;
                const std::uint32_t number = ground_.fact_number({v, value});
                if (ground_.fact_forms[number] == Form::none_of_those) continue;
                const std::string name = ground_.fact_names.words(number);
                if (name.starts_with("auxiliary-")) continue;
                const auto found = atoms.find(name);
                if (found == atoms.end()) return "unknown fact " + name;
                const bool positive = ground_.fact_forms[number] == Form::atom;
                facts_.push_back({{v, value}, found->second, positive});
                shadowed_ = shadowed_ || (positive && represented_[found->second]);
                represented_[found->second] = true;
            }
        }
        return "";
    }

    std::string match_operators() {
        std::map<std::string, std::size_t> numbers;
        for (std::size_t a = 0; a < space_.instances.size(); ++a)
            numbers.emplace(space_.instances[a].name, a);
        operators_of_.resize(space_.instances.size());
        for (std::size_t o = 0; o < ground_.operator_count(); ++o) {
            const std::string name = ground_.operator_names.words(o);
            const auto found = numbers.find(name);
            if (found == numbers.end()) return "unknown operator " + name;
            operators_of_[found->second].push_back(OperatorId(o));
            if (Rational(ground_.costs[o], ground_.cost_scale) != space_.instances[found->second].cost)
                return "wrong cost of " + name;
        }
        return "";
    }

    std::string compare_state(std::size_t i) const {
        const NaiveSemantics::State& state = space_.states[i];
        const Values& values = values_[i];
        for (const auto& [fact, atom, positive] : facts_)
            if ((values[at(fact.variable)] == fact.value) != (state[atom] == positive))
                return ground_.fact_name(fact) + (state[atom] == positive ? " is not" : " is") + " so";
        const auto& first = space_.semantics.first();
        for (std::size_t p = 0; p < task_.predicates.size(); ++p)
            for (std::size_t a = first[p]; a < first[p + 1] && !task_.predicates[p].derived; ++a)
                if (!represented_[a] && state[a] != space_.states[0][a])
                    return space_.semantics.atom_name(a) + " changes but is no fact";
        if (holds(ground_.goal, values) != space_.goal[i]) return "the goal differs";
        for (std::size_t g = 0; g < ground_.mutex_groups.size(); ++g) {
            int true_facts = 0;
            for (const Fact fact : ground_.mutex_groups[g])
                true_facts += values[at(fact.variable)] == fact.value;
            if (true_facts > 1) return "mutex group " + std::to_string(g) + " is violated";
        }
        return "";
    }

    std::string compare_successors(std::size_t i) {
        std::vector<std::size_t> target(space_.instances.size(), kNone);
        for (const LiftedSpace::Edge& edge : space_.edges[i]) target[edge.instance] = edge.target;
        for (std::size_t a = 0; a < target.size(); ++a) {
            bool applicable = false;
            for (const OperatorId op : operators_of_[a]) {
                if (!holds(ground_.preconditions[op.index()], values_[i])) continue;
                applicable = true;
                const std::string& name = space_.instances[a].name;
                if (target[a] == kNone) return "(" + name + ") should not be applicable";
                const Values next = successor(ground_, values_[i], op);
                Values& expected = values_[target[a]];
                if (expected.empty()) expected = next;
                if (expected != next)
                    return "another way to {" + describe(target[a]) + "} than (" + name + ")";
            }
            // Actions that change nothing need not be there.
            if (!applicable && target[a] != kNone && target[a] != i)
                return "(" + space_.instances[a].name + ") should be applicable";
        }
        return "";
    }

    std::string describe(std::size_t i) const {
        std::string text;
        for (std::size_t a = 0; a < space_.states[i].size(); ++a)
            if (space_.states[i][a]) text += "(" + space_.semantics.atom_name(a) + ")";
        return text;
    }

    struct MatchedFact {
        Fact fact;
        std::size_t atom;
        bool positive;
    };
    static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

    const LiftedTask& task_;
    const LiftedSpace& space_;
    const FiniteDomainTask& ground_;
    std::vector<MatchedFact> facts_;
    std::vector<bool> represented_;  ///< by atom
    bool shadowed_ = false;
    std::vector<std::vector<OperatorId>> operators_of_;
    std::vector<Values> values_;  ///< by lifted state; empty: not met yet
};

std::string compare_plans(const LiftedSpace& space, const FiniteDomainTask& ground, std::size_t most) {
    const Distance distance = ground_distance(ground, most);
    const auto text = [](const Distance& d) {
        return d.shortest ? std::to_string(*d.shortest) : "none up to " + std::to_string(d.looked_at);
    };
    if (distance.contradicts(space.distance))
        return "shortest plan: " + text(space.distance) + " lifted, " + text(distance) + " ground";
    if (!space.distance.complete) return "";
    const std::int64_t found = cheapest_plan_cost(ground);
    const std::optional<Rational> expected = space.cheapest();
    if (found < 0) return expected ? "no plan though there is one" : "";
    const Rational cost(found, ground.cost_scale);
    if (!expected || *expected != cost)
        return "a cheapest plan costs " + (expected ? expected->to_string() : "infinitely much") + ", not " +
               cost.to_string();
    return "";
}

Equivalence compare_as_it_is(const LiftedTask& task, std::size_t most) {
    Equivalence result;
    const LiftedSpace space(task, most);
    result.states = space.states.size();
    result.complete = space.distance.complete;
    result.solvable = space.distance.shortest.has_value();

    GroundOptions whole;
    whole.prune_irrelevant = false;
    const auto full = ground(task, whole).task;
    const auto pruned = ground(task).task;
    result.proved_unsolvable = full->proved_unsolvable;
    result.derived = full->has_axioms();
    result.conditional = full->has_conditional_effects();
    result.mutex_groups = full->mutex_groups.size() > 0;
    for (const std::int32_t size : full->domain_sizes) result.multi_valued |= size > 2;

    if ((full->proved_unsolvable || pruned->proved_unsolvable) && result.solvable) {
        result.difference = "not unsolvable";
        return result;
    }
    if (!full->proved_unsolvable) {
        Lockstep lockstep(task, space, *full);
        result.difference = lockstep.run();
        result.shadowed = lockstep.shadowed();
    }
    if (result.difference.empty()) result.difference = compare_plans(space, *pruned, most);
    return result;
}

}  // namespace

Equivalence compare(const LiftedTask& task, std::size_t most) {
    const Equivalence result = compare_as_it_is(task, most);
    if (!result.proved_unsolvable || !result.difference.empty()) return result;
    LiftedTask open = task;
    open.goal = Formula();
    Equivalence second = compare_as_it_is(open, most);
    second.solvable = false;
    second.proved_unsolvable = true;
    return second;
}

}  // namespace praxis::test
