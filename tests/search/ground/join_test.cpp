// Join plans against the enumeration of all assignments.
#include "search/ground/join.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <random>

namespace praxis::grounding {
namespace {

using Values = std::vector<Object>;
using Matches = std::map<Values, int>;  ///< how often each came

class Query {
  public:
    explicit Query(std::uint32_t seed) : random_(seed) {
        make_task();
        make_body();
    }

    std::size_t below(std::size_t n) { return random_() % n; }
    bool chance(unsigned percent) { return random_() % 100 < percent; }

    /// The values of the variables that have some; others are zero.
    Values projected(const Values& binding) const {
        Values result = binding;
        for (std::size_t v = 0; v < result.size(); ++v)
            if (!start.bound[v] && !mentioned(v) && !start.needed[v]) result[v] = 0;
        return result;
    }

    bool mentioned(std::size_t variable) const {
        const auto is = [&](Term term) { return term.is_variable() && term.variable_index() == variable; };
        for (const BodyAtom& atom : body.atoms)
            if (std::any_of(atom.terms.begin(), atom.terms.end(), is)) return true;
        for (const auto* pairs : {&body.equal, &body.unequal})
            for (const auto& [a, b] : *pairs)
                if (is(a) || is(b)) return true;
        return false;
    }

    Matches naive(const Relations& relations, const Values& binding) const {
        Matches result;
        Values values = binding;
        enumerate(relations, 0, values, result);
        return result;
    }

    LiftedTask task;
    Body body;
    std::vector<TypeId> types;
    JoinPlan::Start start;

  private:
    void make_task() {
        const std::size_t objects = 1 + below(5);
        for (std::size_t t = 0; t < 3; ++t) {
            Type& type = task.types.emplace_back();
            type.contains.resize(objects);
            for (std::size_t o = 0; o < objects; ++o) {
                type.contains[o] = t == 0 || chance(60);
                if (type.contains[o]) type.objects.emplace_back(o);
            }
        }
        task.objects.resize(objects);
        for (std::size_t p = 0; p < 4; ++p) {
            Predicate& predicate = task.predicates.emplace_back();
            Relation& relation = task.initial_atoms.emplace_back();
            relation.arity = static_cast<std::uint32_t>(below(4));
            for (std::uint32_t c = 0; c < relation.arity; ++c) predicate.parameters.emplace_back(below(3));
            const bool misplaced = chance(20);  // objects outside the declared types
            std::size_t tuples = 1;
            for (std::uint32_t c = 0; c < relation.arity; ++c) tuples *= objects;
            for (std::size_t code = 0; code < tuples; ++code) {
                std::vector<ObjectId> tuple;
                bool fits = true;
                for (std::size_t rest = code, c = 0; c < relation.arity; ++c, rest /= objects) {
                    tuple.emplace_back(rest % objects);
                    fits = fits && task.types[predicate.parameters[c].index()].contains[rest % objects];
                }
                if ((!fits && !misplaced) || !chance(relation.arity > 2 ? 20 : 50)) continue;
                relation.arguments.insert(relation.arguments.end(), tuple.begin(), tuple.end());
                ++relation.count;
            }
        }
    }

    Term term() {
        return chance(80) ? Term::variable(below(types.size()))
                          : Term::object(ObjectId(below(task.objects.size())));
    }

    void make_body() {
        for (std::size_t i = 1 + below(5); i > 0; --i) types.emplace_back(below(3));
        for (std::size_t i = below(4); i > 0; --i) {
            BodyAtom& atom = body.atoms.emplace_back();
            atom.relation = static_cast<RelationId>(below(task.predicates.size()));
            for (std::size_t c = 0; c < task.predicates[atom.relation].parameters.size(); ++c)
                atom.terms.push_back(term());
            atom.negated = chance(20);
        }
        for (std::size_t i = chance(40); i > 0; --i) body.equal.emplace_back(term(), term());
        for (std::size_t i = chance(40); i > 0; --i) body.unequal.emplace_back(term(), term());
        start.bound.assign(types.size(), false);
        for (std::size_t v = 0; v < types.size(); ++v) start.needed.push_back(chance(50));
    }

    static Object value(Term term, const Values& values) {
        return term.is_variable() ? values[term.variable_index()] : term.object_id().index();
    }

    void enumerate(const Relations& relations, std::size_t v, Values& values, Matches& result) const {
        if (v == types.size()) {
            if (holds(relations, values)) result.emplace(values, 1);
            return;
        }
        if (start.bound[v]) return enumerate(relations, v + 1, values, result);
        if (!mentioned(v) && !start.needed[v]) {
            values[v] = 0;
            return enumerate(relations, v + 1, values, result);
        }
        for (const ObjectId object : task.types[types[v].index()].objects) {
            values[v] = object.index();
            enumerate(relations, v + 1, values, result);
        }
    }

    bool holds(const Relations& relations, const Values& values) const {
        for (const auto& [a, b] : body.equal)
            if (value(a, values) != value(b, values)) return false;
        for (const auto& [a, b] : body.unequal)
            if (value(a, values) == value(b, values)) return false;
        return std::all_of(body.atoms.begin(), body.atoms.end(), [&](const BodyAtom& atom) {
            const TupleStore& store = relations[atom.relation];
            bool found = false;
            for (Row row = 0; row < store.size(); ++row) {
                bool same = true;
                for (std::size_t c = 0; c < atom.terms.size(); ++c)
                    same = same && store.row(row)[c] == value(atom.terms[c], values);
                found = found || (same && (atom.negated || row < store.published()));
            }
            return found != atom.negated;
        });
    }

    std::mt19937 random_;
};

std::uint32_t any_seed() {
    return *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
}

TEST(JoinPlan, MeetsEachMatchOnce) {
    std::size_t queries = 0;
    std::size_t with_matches = 0;
    EXPECT_TRUE(rc::check([&] {
        const std::uint32_t first = any_seed();
        for (std::uint32_t seed = first; seed != first + 100; ++seed) {
            Query query(seed);
            const Budget budget;
            Relations relations(query.task, budget);
            Values binding(query.types.size());
            for (std::size_t v = 0; v < binding.size(); ++v) {
                const auto& objects = query.task.types[query.types[v].index()].objects;
                query.start.bound[v] = !objects.empty() && query.chance(25);
                if (query.start.bound[v]) binding[v] = objects[query.below(objects.size())].index();
            }
            // Plans may be older than the rows; not all rows need be visible.
            const bool early = query.chance(50);
            JoinPlan plan;
            if (early) plan = JoinPlan(relations, query.body, query.types, query.start);
            for (RelationId r = 0; r < relations.size(); ++r)
                relations[r].publish(static_cast<Row>(
                    query.chance(70) ? relations[r].size() : query.below(relations[r].size() + 1)));
            if (!early) plan = JoinPlan(relations, query.body, query.types, query.start);
            const Matches expected = query.naive(relations, binding);
            Matches found;
            RC_ASSERT(plan.run(relations, binding.data(), kNoRow, [&] {
                ++found[query.projected(binding)];
                return true;
            }));
            RC_ASSERT(found == expected);
            ++queries;
            with_matches += !expected.empty();
            if (expected.size() > 1) {
                std::size_t seen = 0;
                RC_ASSERT(!plan.run(relations, binding.data(), kNoRow, [&] { return ++seen < 2; }));
                RC_ASSERT(seen == 2U);
            }
        }
    }));
    EXPECT_GT(with_matches, queries * 15 / 100);
}

TEST(JoinPlan, TriggersTogetherMeetEachMatchOnce) {
    std::size_t queries = 0;
    std::size_t triggered = 0, with_matches = 0;
    EXPECT_TRUE(rc::check([&] {
        const std::uint32_t first = any_seed();
        for (std::uint32_t seed = first; seed != first + 100; ++seed) {
            ++queries;
            Query query(seed);
            const Budget budget;
            Relations relations(query.task, budget);
            std::vector<bool> dynamic;
            for (RelationId r = 0; r < relations.size(); ++r) {
                dynamic.push_back(query.chance(60));
                if (!dynamic.back()) relations[r].publish(relations[r].size());
            }
            std::vector<std::size_t> triggers;
            for (std::size_t a = 0; a < query.body.atoms.size(); ++a)
                if (!query.body.atoms[a].negated && dynamic[query.body.atoms[a].relation])
                    triggers.push_back(a);
            if (triggers.empty()) continue;
            triggered += triggers.size() > 1;
            std::map<std::size_t, JoinPlan> plans;
            const auto make_plans = [&] {
                for (const std::size_t atom : triggers) {
                    query.start.trigger = atom;
                    plans[atom] = JoinPlan(relations, query.body, query.types, query.start);
                }
            };
            make_plans();
            Values binding(query.types.size());
            Matches found;
            for (;;) {
                std::vector<RelationId> waiting;
                for (RelationId r = 0; r < relations.size(); ++r)
                    if (relations[r].published() < relations[r].size()) waiting.push_back(r);
                if (waiting.empty()) break;
                const RelationId relation = waiting[query.below(waiting.size())];
                const Row row = relations[relation].published();
                relations[relation].publish(row + 1);
                if (query.chance(10)) make_plans();
                for (const std::size_t atom : triggers) {
                    if (query.body.atoms[atom].relation != relation) continue;
                    plans[atom].run(relations, binding.data(), row, [&] {
                        ++found[query.projected(binding)];
                        return true;
                    });
                }
            }
            const Matches expected = query.naive(relations, binding);
            RC_ASSERT(found == expected);
            with_matches += !expected.empty();
        }
    }));
    EXPECT_GT(triggered, queries * 3 / 100);
    EXPECT_GT(with_matches, queries * 5 / 100);
}

}  // namespace
}  // namespace praxis::grounding
