// The engines that search expressions can name. All of them are eager or lazy search with some open list and
// some settings.
#include "search/engines/search_plan.hpp"

namespace praxis {

namespace {

using Options = std::vector<OptionDescription>;

Component engine(std::string name, std::string summary, Options options,
                 SearchPlan (*plan)(const Call&, Workshop&)) {
    Component component;
    component.description.name = std::move(name);
    component.description.kind = ComponentKind::engine;
    component.description.summary = std::move(summary);
    component.description.options = std::move(options);
    component.description.conditional_effects = "supported";
    component.description.axioms = "supported";
    component.search_plan = plan;
    return component;
}

/// An engine that is made of others.
Component composite(std::string name, std::string summary, Options options,
                    Outcome (*run)(const SearchRun&, const Call&)) {
    Component component = engine(std::move(name), std::move(summary), std::move(options), nullptr);
    component.composite = run;
    return component;
}

const OptionDescription kEvaluators{"evals", OptionType::evaluators, "",
                                    "heuristics; each gets an open list of its own"};
const OptionDescription kPreferred{"preferred", OptionType::evaluators, "[]",
                                   "heuristics whose preferred operators count"};
const OptionDescription kRandomize{"randomize_successors", OptionType::boolean, "false",
                                   "shuffle the operators of a state"};
const OptionDescription kPreferredFirst{"preferred_successors_first", OptionType::boolean, "false",
                                        "look at preferred operators first"};
const OptionDescription kSeed{
    "random_seed", OptionType::integer, "-1", "negative: the seed of the search", {}, -1};

const OptionDescription kGoOn{"go_on", OptionType::boolean, "false",
                              "after a plan, go on where the search stands, for cheaper ones"};

OptionDescription reopen_option(std::string default_value) {
    return {"reopen_closed", OptionType::boolean, std::move(default_value),
            "look again at states reached more cheaply"};
}

OptionDescription boost_option(std::string default_value) {
    return {"boost",
            OptionType::integer,
            std::move(default_value),
            "turns that lists of preferred states gain when a heuristic reaches a new best value",
            {},
            0,
            1'000'000'000};
}

OptionDescription weight_option() {
    return {"w", OptionType::integer, "1", "weight of the heuristic", {}, 0, 1'000'000'000};
}

Options with_common(Options options) {
    options.push_back(cost_type_option("normal", "how g counts operator costs"));
    options.push_back({"bound", OptionType::integer, "infinity", "find only plans that cost less", {}, 0});
    options.push_back({"max_time", OptionType::real, "infinity", "seconds that the search may take"});
    options.push_back({"max_work", OptionType::real, "infinity",
                       "the same in counted steps, a nanosecond each, so that runs can be repeated"});
    return options;
}

bool has_option(const Call& call, std::string_view name) {
    for (const OptionDescription& option : call.component->description.options) {
        if (option.name == name) return true;
    }
    return false;
}

/// The settings that the engine's component declares; the others keep their defaults.
SearchPlan common_plan(const Call& call, Workshop& workshop, Expansion expansion) {
    SearchPlan plan;
    plan.expansion = expansion;
    plan.bound = call.integer("bound");
    plan.max_time = call["max_time"].real;
    plan.max_work = call["max_work"].real;
    plan.seed = workshop.seed();
    plan.cost_type = cost_type_of(call);
    if (has_option(call, "reopen_closed")) plan.reopen_closed = call.flag("reopen_closed");
    if (has_option(call, "randomize_successors")) {
        plan.randomize_successors = call.flag("randomize_successors");
        plan.preferred_successors_first = call.flag("preferred_successors_first");
        if (call.integer("random_seed") >= 0)
            plan.seed = static_cast<std::uint64_t>(call.integer("random_seed"));
    }
    if (has_option(call, "go_on")) plan.go_on = call.flag("go_on");
    if (has_option(call, "preferred")) plan.preferred = workshop.heuristics_in(call["preferred"]);
    return plan;
}

/// One list for each key, and one of the preferred states if there are preferred operators.
OpenListPlan one_list_a_key(const std::vector<Key>& keys, bool preferred, std::int64_t boost) {
    OpenListPlan plan;
    plan.kind = OpenListPlan::Kind::alternation;
    plan.boost = boost;
    for (const Key& key : keys) {
        OpenListPlan part;
        part.keys = {key};
        plan.lists.push_back(part);
        if (!preferred) continue;
        part.preferred_only = true;
        plan.lists.push_back(part);
    }
    return plan.lists.size() == 1 ? plan.lists[0] : plan;
}

template <Expansion kExpansion>
SearchPlan with_open_list(const Call& call, Workshop& workshop) {
    OpenListPlan open = workshop.open_list(call["open"].calls[0]);
    SearchPlan plan = common_plan(call, workshop, kExpansion);
    plan.open = std::move(open);
    return plan;
}

template <Expansion kExpansion>
SearchPlan greedy(const Call& call, Workshop& workshop) {
    const std::vector<Key> keys = workshop.keys(call["evals"]);
    SearchPlan plan = common_plan(call, workshop, kExpansion);
    plan.open = one_list_a_key(keys, !plan.preferred.empty(), call.integer("boost"));
    return plan;
}

template <Expansion kExpansion>
SearchPlan wastar(const Call& call, Workshop& workshop) {
    std::vector<Key> keys = workshop.keys(call["evals"]);
    for (Key& key : keys)
        key = Key::sum({Key::cost_so_far(), Key::weighted(std::move(key), call.integer("w"))});
    SearchPlan plan = common_plan(call, workshop, kExpansion);
    plan.open = one_list_a_key(keys, !plan.preferred.empty(), call.integer("boost"));
    return plan;
}

SearchPlan astar(const Call& call, Workshop& workshop) {
    const Key h = workshop.key(call["eval"].calls[0]);
    SearchPlan plan = common_plan(call, workshop, Expansion::eager);
    plan.open.keys = {Key::sum({Key::cost_so_far(), h}), h};
    plan.reopen_closed = true;
    plan.optimal = plan.cost_type == CostType::normal && workshop.admissible(h);
    return plan;
}

}  // namespace

std::vector<Component> engine_components() {
    const OptionDescription open{"open", OptionType::open_list, "", "what to look at next"};
    std::vector<Component> all;
    all.push_back(engine("astar", "A* with reopening: the cheapest plan, if the heuristic is admissible",
                         with_common({{"eval", OptionType::evaluator, "", "the heuristic"}}), astar));
    all.push_back(engine(
        "eager_wastar", "weighted A*: sorts by g + w * h; evaluates states when generated",
        with_common({kEvaluators, kPreferred, reopen_option("true"), boost_option("0"), weight_option()}),
        wastar<Expansion::eager>));
    all.push_back(engine("eager_greedy", "greedy best-first search; evaluates states when generated",
                         with_common({kEvaluators, kPreferred, boost_option("0")}),
                         greedy<Expansion::eager>));
    all.push_back(engine("eager", "best-first search with any open list; evaluates states when generated",
                         with_common({open, reopen_option("false"), kPreferred}),
                         with_open_list<Expansion::eager>));
    all.push_back(engine("lazy_greedy", "greedy best-first search; evaluates states when their turn comes",
                         with_common({kEvaluators, kPreferred, reopen_option("false"), boost_option("1000"),
                                      kRandomize, kPreferredFirst, kSeed}),
                         greedy<Expansion::lazy>));
    all.push_back(engine("lazy_wastar",
                         "weighted A*: sorts by g + w * h; evaluates states when their turn comes",
                         with_common({kEvaluators, kPreferred, reopen_option("true"), boost_option("1000"),
                                      weight_option(), kRandomize, kPreferredFirst, kSeed, kGoOn}),
                         wastar<Expansion::lazy>));
    all.push_back(
        engine("lazy", "best-first search with any open list; evaluates states when their turn comes",
               with_common({open, reopen_option("false"), kPreferred, kRandomize, kPreferredFirst, kSeed}),
               with_open_list<Expansion::lazy>));
    all.push_back(composite(
        "iterated", "engines one after the other, each looking for a plan cheaper than those before",
        {{"searches", OptionType::engines, "", "the engines"},
         {"first", OptionType::boolean, "false", "end with the first plan"},
         {"repeat_last", OptionType::boolean, "true", "repeat the last engine as long as it finds plans"},
         {"share", OptionType::boolean, "true",
          "once there is a plan, an engine but the last may take as long as all before it, at least 2 s"},
         {"improve", OptionType::boolean, "true",
          "improve each plan by action elimination and plan neighbourhoods"}},
        run_iterated));
    all.push_back(composite(
        "portfolio",
        "engines side by side: as many at once as there are threads, the others wait for their turns; each "
        "looks for plans cheaper than those found by any",
        {{"searches", OptionType::engines, "", "the engines"},
         {"first", OptionType::boolean, "false", "end with the first plan"},
         {"turn", OptionType::real, "1",
          "how long the first turn of each engine lasts, in seconds, about; later turns are longer"}},
        run_portfolio));
    all.push_back(composite(
        "polish",
        "makes the best plan found so far cheaper by action elimination and plan neighbourhoods, again and "
        "again with larger ones",
        {{"first", OptionType::integer, "50000", "states of the first neighbourhoods", {}, 1},
         {"states", OptionType::integer, "10000000", "states of the largest neighbourhoods", {}, 1}},
        run_polish));
    all.push_back(
        composite("h2",
                  "an engine on the task without the operators and effects that cannot be part of a "
                  "plan by mutexes of pairs (Alcazar and Torralba 2015)",
                  {{"search", OptionType::engine, "", "the engine"},
                   {"seconds", OptionType::real, "5", "what the search for mutexes may take"}},
                  run_pruned));
    return all;
}

}  // namespace praxis
