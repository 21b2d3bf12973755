// The open lists that search expressions can name.
#include "search/engines/search_plan.hpp"

namespace praxis {

namespace {

Component open_list(std::string name, std::string summary, std::vector<OptionDescription> options,
                    OpenListPlan (*plan)(const Call&, Workshop&)) {
    Component component;
    component.description.name = std::move(name);
    component.description.kind = ComponentKind::open_list;
    component.description.summary = std::move(summary);
    component.description.options = std::move(options);
    component.description.conditional_effects = "supported";
    component.description.axioms = "supported";
    component.open_list = plan;
    return component;
}

const OptionDescription kPreferredOnly{"pref_only", OptionType::boolean, "false",
                                       "take only states reached by preferred operators"};

OpenListPlan single(const Call& call, Workshop& workshop) {
    OpenListPlan plan;
    plan.keys = {workshop.key(call["eval"].calls[0])};
    plan.preferred_only = call.flag("pref_only");
    return plan;
}

OpenListPlan tiebreaking(const Call& call, Workshop& workshop) {
    OpenListPlan plan;
    plan.keys = workshop.keys(call["evals"]);
    plan.preferred_only = call.flag("pref_only");
    plan.unsafe_pruning = call.flag("unsafe_pruning");
    return plan;
}

OpenListPlan alternation(const Call& call, Workshop& workshop) {
    OpenListPlan plan;
    plan.kind = OpenListPlan::Kind::alternation;
    plan.lists = workshop.open_lists(call["sublists"]);
    plan.boost = call.integer("boost");
    return plan;
}

OpenListPlan type_based(const Call& call, Workshop& workshop) {
    OpenListPlan plan;
    plan.kind = OpenListPlan::Kind::type_based;
    plan.keys = workshop.keys(call["evals"]);
    const std::int64_t seed = call.integer("random_seed");
    plan.seed = seed < 0 ? workshop.seed() : static_cast<std::uint64_t>(seed);
    return plan;
}

}  // namespace

std::vector<Component> open_list_components() {
    std::vector<Component> all;
    all.push_back(open_list("single", "sorted by one evaluator, first in first out among equals",
                            {{"eval", OptionType::evaluator, "", "what to sort by"}, kPreferredOnly},
                            single));
    all.push_back(open_list("tiebreaking", "sorted by several evaluators, the first counting most",
                            {{"evals", OptionType::evaluators, "", "what to sort by"},
                             kPreferredOnly,
                             {"unsafe_pruning", OptionType::boolean, "true",
                              "drop states whose first estimate is infinite, even if that is no proof"}},
                            tiebreaking));
    all.push_back(
        open_list("alt", "takes turns among open lists",
                  {{"sublists", OptionType::open_lists, "", "the open lists"},
                   {"boost",
                    OptionType::integer,
                    "0",
                    "turns that lists of preferred states gain when a heuristic reaches a new best value",
                    {},
                    0,
                    1'000'000'000}},
                  alternation));
    all.push_back(
        open_list("type_based", "a random state of a random type; states of a type agree in all evaluators",
                  {{"evals", OptionType::evaluators, "", "what makes a type"},
                   {"random_seed", OptionType::integer, "-1", "negative: the seed of the search", {}, -1}},
                  type_based));
    return all;
}

}  // namespace praxis
