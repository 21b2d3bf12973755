#include "search/ground/simplify.hpp"

#include <algorithm>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/strong_components.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "search/ground/ground_condition.hpp"
#include "search/ground/operator_rewriter.hpp"

namespace praxis::grounding {
namespace {

using Graph = boost::compressed_sparse_row_graph<boost::directedS>;

/// Bodies longer than this are not copied into what reads them.
constexpr std::size_t kLongestInlined = 32;

/// Components of derived atoms in an order in which each comes after those that its axioms read.
struct Strata {
    std::vector<std::size_t> component;  ///< by atom
    std::size_t count = 0;
    bool stratified = true;
};

Strata strata(const PropositionTask& task) {
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for (std::size_t a = 0; a < task.heads.size(); ++a)
        for (Literal literal : task.bodies[a])
            if (task.derived[atom_of(literal)]) edges.emplace_back(task.heads[a], atom_of(literal));
    const Graph graph(boost::edges_are_unsorted_multi_pass, edges.begin(), edges.end(), task.atom_count);
    Strata result;
    result.component.resize(task.atom_count);
    const auto map =
        boost::make_iterator_property_map(result.component.begin(), boost::get(boost::vertex_index, graph));
    result.count = boost::strong_components(graph, map);
    for (std::size_t a = 0; a < task.heads.size(); ++a)
        for (Literal literal : task.bodies[a])
            if (is_negative(literal) && task.derived[atom_of(literal)] &&
                result.component[task.heads[a]] == result.component[atom_of(literal)])
                result.stratified = false;
    return result;
}

class AxiomSimplifier {
  public:
    explicit AxiomSimplifier(PropositionTask& task) : task_(task) {}

    bool run() {
        if (task_.heads.empty() &&
            std::find(task_.derived.begin(), task_.derived.end(), true) == task_.derived.end())
            return true;
        strata_ = strata(task_);
        if (!strata_.stratified) return false;
        decide();
        find_substitutes();
        rewrite();
        return true;
    }

  private:
    enum class Value : std::uint8_t { open, no, yes };
    enum class Bound : std::uint8_t { lower, upper };
    static constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();

    std::optional<bool> value(Literal literal) const {
        const Value value = values_[atom_of(literal)];
        if (value == Value::open) return std::nullopt;
        return (value == Value::yes) != is_negative(literal);
    }

    void decide() {
        values_.assign(task_.atom_count, Value::open);
        marked_.assign(task_.atom_count, 0);
        missing_.assign(task_.heads.size(), 0);
        readers_.resize(task_.atom_count);
        for (std::size_t a = 0; a < task_.heads.size(); ++a)
            for (Literal literal : task_.bodies[a])
                if (inner(a, atom_of(literal)))
                    readers_[atom_of(literal)].push_back(static_cast<std::uint32_t>(a));
        std::vector<std::vector<std::uint32_t>> axioms(strata_.count);
        for (std::size_t a = 0; a < task_.heads.size(); ++a)
            axioms[strata_.component[task_.heads[a]]].push_back(static_cast<std::uint32_t>(a));
        std::vector<std::vector<AtomId>> atoms(strata_.count);
        for (AtomId atom = 0; atom < task_.atom_count; ++atom)
            if (task_.derived[atom]) atoms[strata_.component[atom]].push_back(atom);
        for (std::size_t s = 0; s < strata_.count; ++s) {
            if (atoms[s].empty()) continue;
            fixpoint(axioms[s], Bound::lower);
            for (AtomId atom : atoms[s])
                if (std::exchange(marked_[atom], char{0})) values_[atom] = Value::yes;
            fixpoint(axioms[s], Bound::upper);
            for (AtomId atom : atoms[s])
                if (!std::exchange(marked_[atom], char{0}) && values_[atom] == Value::open)
                    values_[atom] = Value::no;
        }
    }

    /// Marks what the axioms of one stratum derive when open literals are taken as false (lower) or true
    /// (upper).
    void fixpoint(const std::vector<std::uint32_t>& axioms, Bound bound) {
        std::vector<AtomId> queue;
        const auto derive = [&](AtomId head) {
            if (marked_[head]) return;
            marked_[head] = 1;
            queue.push_back(head);
        };
        for (std::uint32_t a : axioms) {
            missing_[a] = 0;
            for (Literal literal : task_.bodies[a]) {
                const AtomId atom = atom_of(literal);
                if (inner(a, atom) && values_[atom] == Value::open)
                    ++missing_[a];
                else if (!value(literal).value_or(bound == Bound::upper))
                    missing_[a] = kNever;
                if (missing_[a] == kNever) break;
            }
            if (missing_[a] == 0) derive(task_.heads[a]);
        }
        for (std::size_t next = 0; next < queue.size(); ++next)
            for (std::uint32_t a : readers_[queue[next]])
                if (missing_[a] != kNever && missing_[a] > 0 && values_[queue[next]] == Value::open &&
                    --missing_[a] == 0)
                    derive(task_.heads[a]);
    }

    /// The atom is derived in the stratum of the axiom's head.
    bool inner(std::size_t axiom, AtomId atom) const {
        return task_.derived[atom] && strata_.component[atom] == strata_.component[task_.heads[axiom]];
    }

    /// For each open derived atom: conjunctions that can stand for it, or for its negation.
    void find_substitutes() {
        std::vector<std::vector<std::uint32_t>> axioms(task_.atom_count);
        for (std::size_t a = 0; a < task_.heads.size(); ++a)
            if (values_[task_.heads[a]] == Value::open && possible(a))
                axioms[task_.heads[a]].push_back(static_cast<std::uint32_t>(a));
        for_positive_.resize(task_.atom_count);
        for_negative_.resize(task_.atom_count);
        std::vector<AtomId> order;
        for (AtomId atom = 0; atom < task_.atom_count; ++atom)
            if (task_.derived[atom] && values_[atom] == Value::open) order.push_back(atom);
        std::sort(order.begin(), order.end(),
                  [&](AtomId a, AtomId b) { return strata_.component[a] < strata_.component[b]; });
        for (AtomId atom : order) {
            std::vector<Conjunction> bodies;
            bool recursive = false;
            for (std::uint32_t a : axioms[atom]) {
                for (Literal literal : task_.bodies[a])
                    recursive |= task_.derived[atom_of(literal)] &&
                                 strata_.component[atom_of(literal)] == strata_.component[atom];
                if (recursive) break;
                Conjunction body;
                if (rewritten(task_.bodies[a], body)) bodies.push_back(std::move(body));
            }
            if (recursive || bodies.empty()) continue;
            if (bodies.size() == 1 && bodies[0].size() <= kLongestInlined) for_positive_[atom] = bodies[0];
            if (bodies.size() <= kLongestInlined &&
                std::all_of(bodies.begin(), bodies.end(),
                            [](const Conjunction& body) { return body.size() == 1; })) {
                Conjunction negation;
                for (const Conjunction& body : bodies) negation.push_back(opposite(body.front()));
                for_negative_[atom] = std::move(negation);
            }
        }
    }

    bool possible(std::size_t axiom) const {
        const auto body = task_.bodies[axiom];
        return std::all_of(body.begin(), body.end(),
                           [&](Literal literal) { return value(literal).value_or(true); });
    }

    /// The list with what is decided left out and substitutes put in; false if it cannot hold.
    bool rewritten(std::span<const Literal> list, Conjunction& result) const {
        result.clear();
        for (Literal literal : list) {
            const AtomId atom = atom_of(literal);
            if (!task_.derived[atom]) {
                result.push_back(literal);
                continue;
            }
            if (const auto known = value(literal)) {
                if (!*known) return false;
                continue;
            }
            const auto& substitute = is_negative(literal) ? for_negative_[atom] : for_positive_[atom];
            if (substitute)
                result.insert(result.end(), substitute->begin(), substitute->end());
            else
                result.push_back(literal);
        }
        return tidy(result);
    }

    void rewrite() {
        rewrite_operators();
        rewrite_axioms();
        Conjunction goal;
        task_.goal_reachable = task_.goal_reachable && rewritten(task_.goal, goal);
        task_.goal = std::move(goal);
        for (AtomId atom = 0; atom < task_.atom_count; ++atom)
            if (values_[atom] == Value::yes) task_.constant[atom] = true;
    }

    void rewrite_operators() {
        OperatorRewriter rewriter(task_);
        Conjunction precondition;
        Conjunction condition;
        std::vector<PropositionEffect> effects;
        for (std::size_t o = 0; o < task_.operator_count(); ++o) {
            if (!rewritten(task_.preconditions[o], precondition)) continue;
            effects.clear();
            for (PropositionEffect effect : task_.effects[o]) {
                if (effect.condition != 0) {
                    if (!rewritten(task_.conditions[effect.condition], condition)) continue;
                    effect.condition = rewriter.condition(condition);
                }
                effects.push_back(effect);
            }
            if (!effects.empty()) rewriter.keep(o, precondition, effects);
        }
        rewriter.finish();
    }

    void rewrite_axioms() {
        std::vector<AtomId> heads;
        PackedLists<Literal> bodies;
        Conjunction body;
        for (std::size_t a = 0; a < task_.heads.size(); ++a) {
            if (values_[task_.heads[a]] != Value::open || !rewritten(task_.bodies[a], body)) continue;
            heads.push_back(task_.heads[a]);
            bodies.append(body);
        }
        task_.heads = std::move(heads);
        task_.bodies = std::move(bodies);
    }

    PropositionTask& task_;
    Strata strata_;
    std::vector<Value> values_;
    std::vector<char> marked_;
    std::vector<std::uint32_t> missing_;  ///< by axiom: same-stratum literals not derived yet, or kNever
    std::vector<std::vector<std::uint32_t>> readers_;  ///< by atom: axioms of its stratum that read it
    std::vector<std::optional<Conjunction>> for_positive_;
    std::vector<std::optional<Conjunction>> for_negative_;
};

}  // namespace

bool simplify_axioms(PropositionTask& task) {
    return AxiomSimplifier(task).run();
}

std::vector<std::int32_t> axiom_layers(const PropositionTask& task) {
    const Strata order = strata(task);
    if (!order.stratified) return {};
    std::vector<std::vector<std::uint32_t>> axioms(order.count);
    for (std::size_t a = 0; a < task.heads.size(); ++a)
        axioms[order.component[task.heads[a]]].push_back(static_cast<std::uint32_t>(a));
    std::vector<std::int32_t> layer_of(order.count, 0);
    for (std::size_t s = 0; s < order.count; ++s)
        for (std::uint32_t a : axioms[s])
            for (Literal literal : task.bodies[a]) {
                if (!task.derived[atom_of(literal)] || order.component[atom_of(literal)] == s) continue;
                layer_of[s] = std::max(layer_of[s], layer_of[order.component[atom_of(literal)]] +
                                                        (is_negative(literal) ? 1 : 0));
            }
    std::vector<std::int32_t> result(task.atom_count, -1);
    for (AtomId atom = 0; atom < task.atom_count; ++atom)
        if (task.derived[atom]) result[atom] = layer_of[order.component[atom]];
    return result;
}

}  // namespace praxis::grounding
