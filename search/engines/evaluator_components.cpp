// The evaluators that search expressions can name.
#include "search/engines/search_plan.hpp"
#include "search/evaluators/blind.hpp"
#include "search/evaluators/ff.hpp"
#include "search/evaluators/goal_count.hpp"
#include "search/evaluators/hadd.hpp"
#include "search/evaluators/hmax.hpp"
#include "search/evaluators/lmcut.hpp"
#include "search/evaluators/novelty.hpp"
#include "search/evaluators/relaxed_counter.hpp"
#include "search/evaluators/relaxed_task.hpp"
#include "search/landmarks/landmark_sum.hpp"

namespace praxis {

namespace {

constexpr std::int64_t kLargeNumber = 1'000'000'000;

std::shared_ptr<const RelaxedTask> relaxed_task(Workshop& workshop, CostType cost_type) {
    const std::string name = "relaxed task " + std::to_string(static_cast<int>(cost_type));
    return workshop.shared().get<RelaxedTask>(name, [&] {
        return std::make_shared<const RelaxedTask>(workshop.task(), workshop.goal(), cost_type,
                                                   RelaxedTask::Dominance::drop);
    });
}

template <class HeuristicEvaluator, bool kCheap>
Key heuristic_key(const Call& call, Workshop& workshop) {
    const CostType cost_type = cost_type_of(call);
    return Key::heuristic(workshop.heuristic(call, cost_type, kCheap, [&] {
        using Relaxed = std::shared_ptr<const RelaxedTask>;
        if constexpr (std::is_constructible_v<HeuristicEvaluator, const FiniteDomainTask&, Relaxed>) {
            return std::make_unique<HeuristicEvaluator>(workshop.task(), relaxed_task(workshop, cost_type));
        } else {
            return std::make_unique<HeuristicEvaluator>(workshop.task(),
                                                        std::span<const Fact>(workshop.goal()), cost_type);
        }
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

Key landmark_sum_key(const Call& call, Workshop& workshop) {
    const CostType cost_type = cost_type_of(call);
    return Key::heuristic(workshop.heuristic(call, cost_type, false, [&] {
        LandmarkOptions options;
        options.disjunctive = call.flag("disjunctive");
        options.reasonable = call.flag("reasonable");
        options.budget = workshop.budget();
        const std::string name = std::string("landmarks") + (options.disjunctive ? " disjunctive" : "") +
                                 (options.reasonable ? " reasonable" : "");
        return std::make_unique<LandmarkSumEvaluator>(
            workshop.task(), workshop.goal(),
            workshop.shared().get<LandmarkGraph>(
                name,
                [&] {
                    return std::make_shared<const LandmarkGraph>(make_landmark_graph(
                        workshop.task(), workshop.goal(), workshop.initial_values(), options));
                }),
            cost_type);
    }));
}

Component landmark_sum() {
    Component component;
    component.description = {
        "landmark_sum",
        ComponentKind::evaluator,
        "cost of the landmarks still to reach (Richter and Westphal 2010); operators that reach one are "
        "preferred",
        {cost_type_option("normal", "how the evaluator counts operator costs"),
         {"disjunctive", OptionType::boolean, "true", "use landmarks that are one of several facts"},
         {"reasonable", OptionType::boolean, "true", "use reasonable orderings"}},
        "supported",
        "supported (relaxed)",
        "yes",
        "no",
        "no"};
    component.key = landmark_sum_key;
    return component;
}

Key novelty_key(const Call& call, Workshop& workshop) {
    std::vector<Key> partition = workshop.keys(call["evals"]);
    NoveltyOptions options;
    options.width = static_cast<int>(call.integer("width"));
    options.forget = call.flag("forget");
    options.memory = static_cast<std::size_t>(call.integer("memory")) << 20;
    options.sample = static_cast<std::size_t>(call.integer("sample"));
    return Key::heuristic(workshop.heuristic(
        call, CostType::one, false,
        [&] { return std::make_unique<NoveltyEvaluator>(workshop.task(), options); }, std::move(partition)));
}

Component novelty() {
    Component component;
    component.description = {
        "novelty",
        ComponentKind::evaluator,
        "1 or 2 for a fact or a pair of facts not seen before by states of the same partition, else one more "
        "than the width (Lipovetzky and Geffner 2017)",
        {{"evals", OptionType::evaluators, "[]", "states that agree in these are compared"},
         {"width", OptionType::integer, "2", "largest set of facts to look at", {}, 1, 2},
         {"forget", OptionType::boolean, "false", "start anew when one of `evals` reaches a new best value"},
         {"memory",
          OptionType::integer,
          "128",
          "MiB for tables; when full, partitions share them",
          {},
          1,
          1 << 20},
         {"sample",
          OptionType::integer,
          "infinity",
          "pairs to look at in a state, taken evenly from all (approximate novelty)",
          {},
          1}},
        "supported",
        "supported",
        "yes",
        "no",
        "no"};
    component.key = novelty_key;
    return component;
}

Component relaxed_counter() {
    Component component;
    component.description = {
        "relaxed_counter",
        ComponentKind::evaluator,
        "how many facts of a relaxed plan have been reached since the goals last got fewer; "
        "partitions novelty (Lipovetzky and Geffner 2017)",
        {},
        "supported (relaxed)",
        "supported (relaxed)",
        "yes",
        "no",
        "no"};
    component.key = [](const Call& call, Workshop& workshop) {
        return Key::heuristic(workshop.heuristic(call, CostType::one, false, [&] {
            return std::make_unique<RelaxedCounterEvaluator>(workshop.task(),
                                                             std::span<const Fact>(workshop.goal()),
                                                             relaxed_task(workshop, CostType::one));
        }));
    };
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
    all.push_back(landmark_sum());
    all.push_back(novelty());
    all.push_back(relaxed_counter());
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
