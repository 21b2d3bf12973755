// The language of search expressions, and what it says of itself.
#include <gtest/gtest.h>

#include <set>

#include "search/engines/call.hpp"
#include "search/engines/registry.hpp"
#include "search/engines/search.hpp"
#include "search/engines/search_plan.hpp"
#include "tests/search/state/random_task.hpp"

namespace praxis {
namespace {

std::string error_of(const std::string& expression) {
    try {
        configuration(expression);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Expression, IsAccepted) {
    for (const char* expression :
         {"astar(blind())", "ASTAR( Blind ( ) )", "astar(eval=blind(cost_type=one),bound=7)",
          "lazy_greedy([goalcount()],preferred=[],boost=0,randomize_successors=true)",
          "eager_greedy(goalcount())", "eager(single(g()))",
          "lazy(alt([single(g()),single(const(3),pref_only=true)],boost=5),\n reopen_closed=true)",
          "eager(tiebreaking([sum([g(),weight(blind(),3)]),max([blind(),goalcount()])],unsafe_pruning=false)"
          ")",
          "lazy_wastar([blind()],w=5,bound=infinity,max_time=2.5)",
          "eager(type_based([g(),goalcount()],random_seed=4))"}) {
        EXPECT_EQ(error_of(expression), "") << expression;
    }
}

TEST(Expression, ErrorsNamePlaceAndMend) {
    EXPECT_EQ(error_of("lazy_greedy([goalcount()],preferd=[])"),
              "search expression:27: 'lazy_greedy' has no option 'preferd'\n"
              "  lazy_greedy([goalcount()],preferd=[])\n"
              "                            ^~~~~~~ did you mean 'preferred'?");
    const std::vector<std::pair<std::string, std::string>> cases{
        {"", "expected a name"},
        {"astar(blind()", "expected ',' or ')'"},
        {"astar(blind()))", "expected the end"},
        {"astar(blind)", "write 'blind()'"},
        {"astar()", "needs a value for 'eval'"},
        {"astra(blind())", "did you mean 'astar'?"},
        {"astar(blnd())", "did you mean 'blind'?"},
        {"astar(single(g()))", "but 'single' is an open list"},
        {"blind()", "but 'blind' is an evaluator"},
        {"astar([blind()])", "not a list"},
        {"lazy_greedy([])", "at least one evaluator is needed"},
        {"astar(blind(),bound=-1)", "at least 0"},
        {"astar(blind(),bound=1.5)", "needs an integer"},
        {"astar(blind(),bound=99999999999999999999)", "needs an integer"},
        {"astar(blind(),bound=blind())", "needs integer"},
        {"astar(blind(),bound=1,bound=2)", "given twice"},
        {"astar(blind(),eval=blind())", "given twice"},
        {"astar(eval=blind(),normal)", "without a name after one with a name"},
        {"astar(blind(),normal,infinity,infinity,infinity,1)", "takes 5 arguments at most"},
        {"astar(blind(),max_work=-1)", "needs a number"},
        {"astar(blind(cost_type=two))", "is one of normal, one, plusone"},
        {"lazy_greedy([blind()],randomize_successors=maybe)", "true or false"},
        {"astar(blind(),max_time=soon)", "needs a number"},
        {"astar(blind(),max_time=-1)", "needs a number"},
        {"astar(const(infinity))", "out of range"},
        {"astar(blind();)", "expected ',' or ')'"},
    };
    for (const auto& [expression, part] : cases) {
        EXPECT_NE(error_of(expression).find(part), std::string::npos)
            << expression << "\n"
            << error_of(expression) << "\nlacks: " << part;
    }
    EXPECT_NE(error_of(std::string(100000, '[')).find("nested too deeply"), std::string::npos);
    EXPECT_NE(error_of(std::string(100000, 'a') + "(").find("expected"), std::string::npos);
}

TEST(Expression, EqualEvaluatorsAreShared) {
    FiniteDomainTask task;
    test::add_variable(task, 2, 0);
    test::add_operator(task, {}, {{{0, 1}, {}}});
    const Query query = task_query(task);
    const PreparedTask prepared(std::make_shared<FiniteDomainTask>(task));
    SharedParts shared;
    const Budget budget;
    const SearchCallbacks callbacks;
    const Incumbent incumbent;
    Workshop workshop({prepared, query, shared, incumbent, 0, 1, budget, callbacks, kInfinity});
    workshop.search_plan(
        check_expression("lazy_greedy([goalcount(), sum([g(), GoalCount(cost_type=normal)]), "
                         "blind()],preferred=[goalcount(normal)])"));
    EXPECT_EQ(workshop.take_heuristics().size(), 2u);
}

TEST(Registry, DescribesEveryComponent) {
    std::set<std::pair<ComponentKind, std::string>> names;
    for (const ComponentDescription& component : list_components()) {
        EXPECT_TRUE(names.insert({component.kind, component.name}).second) << component.name;
        EXPECT_FALSE(component.summary.empty()) << component.name;
        EXPECT_FALSE(component.conditional_effects.empty()) << component.name;
        EXPECT_FALSE(component.axioms.empty()) << component.name;
        if (component.kind == ComponentKind::evaluator) {
            EXPECT_FALSE(component.safe.empty() || component.admissible.empty() ||
                         component.consistent.empty())
                << component.name;
        }
        for (const OptionDescription& option : component.options) {
            EXPECT_FALSE(option.help.empty()) << component.name << ' ' << option.name;
        }
    }
    for (const char* engine :
         {"astar", "eager_wastar", "eager_greedy", "eager", "lazy_greedy", "lazy_wastar", "lazy"}) {
        EXPECT_TRUE(names.contains({ComponentKind::engine, engine})) << engine;
    }
    for (const char* evaluator :
         {"blind", "goalcount", "hmax", "add", "ff", "lmcut", "g", "sum", "weight", "max"}) {
        EXPECT_TRUE(names.contains({ComponentKind::evaluator, evaluator})) << evaluator;
    }
}

TEST(Registry, AliasesAreValid) {
    for (const AliasDescription& description : list_aliases()) {
        EXPECT_EQ(alias(description.name).expression, description.expression);
        EXPECT_FALSE(description.summary.empty());
    }
    EXPECT_THROW(alias("agille"), std::invalid_argument);
    try {
        alias("agille");
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("did you mean 'agile'?"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace praxis
