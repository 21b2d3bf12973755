// Applicable actions, changes, derived atoms and goals of random lifted tasks, in one state after the other,
// against the textbook semantics over all bindings.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

#include "search/lifted/actions.hpp"
#include "search/lifted/axioms.hpp"
#include "search/lifted/goal.hpp"
#include "tests/search/ground/moving_task.hpp"
#include "tests/search/ground/state_space.hpp"
#include "tests/search/support/random_task.hpp"

namespace praxis {
namespace {

/// The lifted view of a task's states, asked state by state.
class Comparison {
  public:
    Comparison(const LiftedTask& task, const test::LiftedSpace& space)
        : task_(task),
          space_(space),
          database_(task),
          solver_(database_, budget_),
          axioms_(database_, solver_),
          actions_(database_, solver_),
          goal_(database_, solver_) {
        database_.finish();
        axioms_.finish();
        goal_.finish();
        for (std::size_t i = 0; i < space.instances.size(); ++i)
            instances_.emplace(std::pair(space.instances[i].schema, space.instances[i].arguments), i);
    }

    std::string run() {
        for (std::size_t i = 0; i < space_.edges.size(); ++i)
            if (std::string problem = compare(i); !problem.empty())
                return problem + " in state " + std::to_string(i);
        return "";
    }

  private:
    using Bits = test::NaiveSemantics::State;

    std::vector<lifted::AtomNumber> atoms_of(const Bits& state) {
        std::vector<lifted::AtomNumber> atoms;
        for_each_tuple([&](std::size_t bit, std::size_t p, const test::NaiveSemantics::Tuple& tuple) {
            if (state[bit] && task_.predicates[p].fluent)
                atoms.push_back(database_.intern(static_cast<lifted::PredicateNumber>(p), tuple.data()));
        });
        std::ranges::sort(atoms);
        return atoms;
    }

    template <class Visit>
    void for_each_tuple(const Visit& visit) const {
        const auto& first = space_.semantics.first();
        for (std::size_t p = 0; p < task_.predicates.size(); ++p) {
            const std::size_t arity = task_.predicates[p].parameters.size();
            test::NaiveSemantics::Tuple tuple(arity, 0);
            for (std::size_t n = first[p]; n < first[p + 1]; ++n) {
                visit(space_.semantics.atom(PredicateId(p), tuple), p, tuple);
                for (std::size_t c = arity; c-- > 0;) {
                    if (++tuple[c] < task_.objects.size()) break;
                    tuple[c] = 0;
                }
            }
        }
    }

    std::string compare(std::size_t i) {
        const std::vector<lifted::AtomNumber> atoms = atoms_of(space_.states[i]);
        database_.load(atoms);
        axioms_.derive();
        std::string problem;
        for_each_tuple([&](std::size_t bit, std::size_t p, const test::NaiveSemantics::Tuple& tuple) {
            if (database_.holds(static_cast<lifted::PredicateNumber>(p), tuple.data()) !=
                space_.states[i][bit])
                problem = space_.semantics.atom_name(bit) + " differs";
        });
        if (!problem.empty()) return problem;
        const std::uint32_t literals = goal_.literals_missing(atoms);
        const bool goal = !goal_.impossible() && literals + goal_.conditions_missing() == 0;
        if (goal != space_.goal[i]) return "the goal differs";

        std::map<std::size_t, std::size_t> expected;
        for (const auto& edge : space_.edges[i]) expected.emplace(edge.instance, edge.target);
        std::set<std::size_t> met;
        actions_.for_each_applicable([&](std::uint32_t schema, const lifted::ObjectNumber* arguments) {
            const Schema& lifted_schema = task_.schemas[schema];
            const test::NaiveSemantics::Tuple tuple(arguments,
                                                    arguments + lifted_schema.scope.parameter_count);
            const auto instance = instances_.find({&lifted_schema, tuple});
            if (instance == instances_.end() || !expected.contains(instance->second)) {
                problem = lifted_schema.name + " should not be applicable";
                return;
            }
            met.insert(instance->second);
            const std::vector<lifted::AtomNumber> after = atoms_of(space_.states[expected[instance->second]]);
            const lifted::Change& change = actions_.change(schema);
            lifted::Change wanted;
            std::ranges::set_difference(after, atoms, std::back_inserter(wanted.added));
            std::ranges::set_difference(atoms, after, std::back_inserter(wanted.deleted));
            if (change.added != wanted.added || change.deleted != wanted.deleted)
                problem = lifted_schema.name + " makes another change";
            if (goal_.literals_missing(literals, change) != goal_.literals_missing(after))
                problem = lifted_schema.name + " changes the goals in another way";
            if (actions_.cost(schema) != space_.instances[instance->second].cost)
                problem = lifted_schema.name + " costs something else";
        });
        if (problem.empty() && met.size() != expected.size()) problem = "an action should be applicable";
        return problem;
    }

    const LiftedTask& task_;
    const test::LiftedSpace& space_;
    Budget budget_;
    lifted::Database database_;
    lifted::QuerySolver solver_;
    lifted::Axioms axioms_;
    lifted::Actions actions_;
    lifted::Goal goal_;
    std::map<std::pair<const Schema*, test::NaiveSemantics::Tuple>, std::size_t> instances_;
};

TEST(LiftedSuccessors, AgreeWithAllBindingsForAnyFormula) {
    std::size_t edges = 0, derived = 0;
    ASSERT_TRUE(rc::check([&] {
        const auto first = *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
        for (std::uint32_t seed = first; seed != first + 10; ++seed) {
            const test::RandomTask random = test::random_task(seed);
            const test::LiftedSpace space(random.task, 20);
            const std::string difference = Comparison(random.task, space).run();
            if (!difference.empty()) RC_LOG() << "random_task(" << seed << ")";
            RC_ASSERT(difference == "");
            for (const auto& list : space.edges) edges += list.size();
            derived += !random.task.axioms.empty();
        }
    }));
    EXPECT_GT(edges, 1000u);
    EXPECT_GT(derived, 100u);
}

TEST(LiftedSuccessors, AgreeWithAllBindingsWhereThingsMove) {
    std::size_t edges = 0;
    ASSERT_TRUE(rc::check([&] {
        const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
        const test::MovingTask moving = test::moving_task(seed);
        const test::LiftedSpace space(*moving.task, 40);
        const std::string difference = Comparison(*moving.task, space).run();
        if (!difference.empty()) RC_LOG() << moving.domain << "\n" << moving.problem;
        RC_ASSERT(difference == "");
        for (const auto& list : space.edges) edges += list.size();
    }));
    EXPECT_GT(edges, 1000u);
}

}  // namespace
}  // namespace praxis
