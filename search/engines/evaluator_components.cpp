// The evaluators that search expressions can name.
#include "search/engines/search_plan.hpp"
#include "search/evaluators/blind.hpp"
#include "search/evaluators/ff.hpp"
#include "search/evaluators/goal_count.hpp"
#include "search/evaluators/hadd.hpp"
#include "search/evaluators/hmax.hpp"
#include "search/evaluators/lmcut.hpp"

namespace praxis {

namespace {

constexpr std::int64_t kLargeNumber = 1'000'000'000;

template <class HeuristicEvaluator, bool kCheap>
Key heuristic_key(const Call& call, Workshop& workshop) {
    const CostType cost_type = cost_type_of(call);
    return Key::heuristic(workshop.heuristic(call, cost_type, kCheap, [&] {
        return std::make_unique<HeuristicEvaluator>(workshop.task(), std::span<const Fact>(workshop.goal()),
                                                    cost_type);
    }));
}

struct Notes {
    const char* axioms;
    const char* safe;
    const char* admissible;
    const char* consistent;
};

template <class HeuristicEvaluator, bool kCheap = false>
Component heuristic(std::string name, std::string summary, const Notes& notes) {
    Component component;
    component.description = {
        std::move(name),    ComponentKind::evaluator,
        std::move(summary), {cost_type_option("normal", "how the evaluator counts operator costs")},
        "supported",        notes.axioms,
        notes.safe,         notes.admissible,
        notes.consistent};
    component.key = heuristic_key<HeuristicEvaluator, kCheap>;
    return component;
}

Component arithmetic(std::string name, std::string summary, std::vector<OptionDescription> options,
                     Key (*key)(const Call&, Workshop&), std::string admissible = "no") {
    Component component;
    component.description = {std::move(name),
                             ComponentKind::evaluator,
                             std::move(summary),
                             std::move(options),
                             "supported",
                             "supported",
                             "yes",
                             std::move(admissible),
                             "no"};
    component.key = key;
    return component;
}

const OptionDescription kEvaluators{"evals", OptionType::evaluators, "", "what to combine"};

}  // namespace

std::vector<Component> evaluator_components() {
    std::vector<Component> all;
    all.push_back(heuristic<BlindEvaluator, true>(
        "blind", "0 in goal states, elsewhere the cost of the cheapest operator",
        {"supported", "yes", "yes", "yes"}));
    all.push_back(heuristic<GoalCountEvaluator, true>(
        "goalcount", "the number of goal facts that do not hold", {"supported", "yes", "no", "no"}));
    all.push_back(heuristic<HmaxEvaluator>(
        "hmax", "cost of the dearest goal fact under delete relaxation (Bonet and Geffner 1999)",
        {"supported (relaxed)", "yes", "yes", "yes"}));
    all.push_back(heuristic<AddEvaluator>(
        "add", "sum of the goal facts' costs under delete relaxation (Bonet and Geffner 1999)",
        {"supported (relaxed)", "yes", "no", "no"}));
    all.push_back(heuristic<FFEvaluator>(
        "ff", "cost of a relaxed plan (Hoffmann and Nebel 2001); its first operators are preferred",
        {"supported (relaxed)", "yes", "no", "no"}));
    all.push_back(heuristic<LMCutEvaluator>("lmcut",
                                            "cost of disjoint landmark cuts (Helmert and Domshlak 2009)",
                                            {"supported (relaxed)", "yes", "yes", "no"}));
    all.push_back(arithmetic("g", "cost of the way to the state, as the search counts costs", {},
                             [](const Call&, Workshop&) { return Key::cost_so_far(); }));
    all.push_back(arithmetic(
        "const", "a number", {{"value", OptionType::integer, "1", "the number", {}, 0, kLargeNumber}},
        [](const Call& call, Workshop&) { return Key::constant(call.integer("value")); }));
    all.push_back(arithmetic(
        "sum", "sum of evaluators", {kEvaluators},
        [](const Call& call, Workshop& workshop) { return Key::sum(workshop.keys(call["evals"])); }));
    all.push_back(arithmetic(
        "max", "largest of evaluators", {kEvaluators},
        [](const Call& call, Workshop& workshop) { return Key::maximum(workshop.keys(call["evals"])); },
        "if all of them are"));
    all.push_back(arithmetic("weight", "a multiple of an evaluator",
                             {{"eval", OptionType::evaluator, "", "what to multiply"},
                              {"weight", OptionType::integer, "", "by how much", {}, 0, kLargeNumber}},
                             [](const Call& call, Workshop& workshop) {
                                 return Key::weighted(workshop.key(call["eval"].calls[0]),
                                                      call.integer("weight"));
                             }));
    return all;
}

}  // namespace praxis
