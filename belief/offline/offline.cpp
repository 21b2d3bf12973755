#include "belief/offline/offline.hpp"

#include <array>
#include <string>
#include <utility>

#include "belief/agent.hpp"
#include "belief/offline/check_conditional_plan.hpp"
#include "belief/offline/conditional_planner.hpp"
#include "belief/offline/optimal_policy.hpp"
#include "belief/offline/state_table.hpp"

namespace praxis::belief {
namespace {

using Reuse = ConditionalPlannerOptions::Reuse;

struct Way {
    std::string name;
    ConditionalPlannerOptions options;
};

std::vector<Way> ways(const OfflineOptions& options) {
    const AgentOptions agent = default_agent_options();
    ConditionalPlannerOptions base;
    base.first = options.search.value_or(agent.first);
    base.second = options.search.value_or(agent.second);
    base.first.seed = base.second.seed = options.seed;
    base.plan_seconds = agent.plan_seconds;
    std::vector<std::pair<std::string, ConditionalPlannerOptions>> searches{{"greedy plans", base}};
    if (options.search) {
        searches[0].first = "the given search";
    } else {
        ConditionalPlannerOptions careful = base;
        careful.first = configuration("astar(lmcut())");
        careful.first.seed = options.seed;
        careful.second = base.first;
        careful.plan_seconds = 0.5;
        searches.emplace_back("optimal plans", careful);
    }
    std::vector<Way> result;
    for (auto& [name, search] : searches) {
        for (const auto& [how, reuse] : {std::pair{", parts shared after answers", Reuse::after_answers},
                                         std::pair{", no parts shared", Reuse::never},
                                         std::pair{", parts shared everywhere", Reuse::everywhere}}) {
            search.reuse = reuse;
            result.push_back({name + how, search});
        }
    }
    return result;
}

class Offline {
  public:
    Offline(const KnowledgePlanner& planner, const OfflineOptions& options, const Budget& budget)
        : planner_(planner),
          task_(planner.compilation().shared_belief()),
          options_(options),
          budget_(budget),
          improving_(budget.within(options.improve_seconds)) {}

    OfflineResult operator()() {
        const double start = processor_seconds();
        if (!certain_outcomes(*task_)) {
            result_.status = OfflineStatus::unsupported;
            result_.message = "actions with effects of chance, or readings with errors: no plan can be sure";
        } else if (task_->physical->proved_unsolvable) {
            result_.status = OfflineStatus::unsolvable;
            result_.message = "no plan reaches the goal, whatever is read";
        } else if (choose_worlds()) {
            make();
        }
        result_.seconds = processor_seconds() - start;
        return std::move(result_);
    }

  private:
    bool choose_worlds() {
        all_ = enumerate_worlds(*task_, options_.most_worlds);
        if (all_) {
            worlds_ = *all_;
        } else {
            Random random(options_.seed);
            for (std::size_t i = 0; i < options_.samples; ++i) {
                std::optional<WorldState> world = sample_world(*task_, random);
                if (!world) break;
                worlds_.push_back(std::move(*world));
            }
        }
        if (!worlds_.empty()) return true;
        result_.status = all_ ? OfflineStatus::unsolvable : OfflineStatus::not_found;
        result_.message = "no first state satisfies the initial description";
        return false;
    }

    void make() {
        for (const Way& way : ways(options_)) {
            const bool found = result_.status == OfflineStatus::found;
            if (found && improving_.exhausted() != Stop::none) break;
            try_way(way, found ? improving_ : budget_);
        }
        if (all_ && options_.optimum_seconds > 0) try_optimum();
    }

    void try_way(const Way& way, const Budget& budget) {
        ConditionalPlanResult made = make_conditional_plan(planner_, all_, way.options, budget);
        result_.plans += made.plans;
        if (made.status == ConditionalPlanResult::Status::found) {
            consider(std::move(made.plan), way.name);
        } else if (result_.status != OfflineStatus::found) {
            result_.message = std::move(made.message);
            // From a belief on the way, no plan may lead on; from the first one, another way may.
            result_.status = made.status == ConditionalPlanResult::Status::limit ? OfflineStatus::limit
                                                                                 : OfflineStatus::not_found;
        }
    }

    void try_optimum() {
        OptimalPolicyOptions limits;
        const bool worst = options_.prefer == OfflineOptions::Prefer::worst_cost;
        if (worst) limits.criterion = OptimalPolicyOptions::Criterion::worst_cost;
        OptimalPolicy best = optimal_policy(task_, *all_, limits, budget_.within(options_.optimum_seconds));
        if (best.status == OptimalPolicy::Status::optimal) {
            const PlanCosts costs = best.costs;
            consider(std::move(best.plan), "the optimum");
            result_.optimal = result_.status == OfflineStatus::found &&
                              (worst ? result_.costs.worst <= costs.worst : result_.costs.mean <= costs.mean);
        } else if (best.status == OptimalPolicy::Status::unsolvable &&
                   result_.status != OfflineStatus::found) {
            result_.status = OfflineStatus::unsolvable;
            result_.message = "no plan reaches the goal in all first states";
        }
    }

    std::array<double, 3> value(const ConditionalPlan& plan, const PlanCosts& costs) const {
        const auto nodes = static_cast<double>(plan.action_nodes());
        switch (options_.prefer) {
            case OfflineOptions::Prefer::worst_cost:
                return {costs.worst, costs.mean, nodes};
            case OfflineOptions::Prefer::fewest_nodes:
                return {nodes, costs.mean, costs.worst};
            case OfflineOptions::Prefer::mean_cost:
                break;
        }
        return {costs.mean, nodes, costs.worst};
    }

    /// Keeps the plan if it is valid and better than what there is.
    void consider(ConditionalPlan plan, const std::string& way) {
        std::optional<PlanCosts> costs = plan_costs(task_, plan, worlds_);
        if (result_.status == OfflineStatus::found &&
            (!costs || value(plan, *costs) >= value(result_.plan, result_.costs)))
            return;
        const ConditionalVerdict verdict = check_conditional_plan(task_, plan, worlds_, budget_);
        if (!verdict.valid || !costs) {
            if (result_.status != OfflineStatus::found) {
                const bool refuted = !verdict.reason.empty();
                result_.status = refuted ? OfflineStatus::not_found : OfflineStatus::limit;
                result_.message = refuted ? "the plan fails " + verdict.reason : "no time to check the plan";
            }
            return;
        }
        result_.status = OfflineStatus::found;
        result_.message.clear();
        result_.plan = std::move(plan);
        result_.costs = std::move(*costs);
        result_.checked = verdict.checked;
        result_.all_worlds = all_.has_value() && verdict.checked == worlds_.size();
        result_.way = way;
    }

    const KnowledgePlanner& planner_;
    std::shared_ptr<const BeliefTask> task_;
    const OfflineOptions& options_;
    const Budget& budget_;
    Budget improving_;
    std::optional<std::vector<WorldState>> all_;
    std::vector<WorldState> worlds_;
    OfflineResult result_;
};

}  // namespace

const char* to_string(OfflineStatus status) {
    switch (status) {
        case OfflineStatus::found:
            return "found";
        case OfflineStatus::unsolvable:
            return "unsolvable";
        case OfflineStatus::not_found:
            return "not found";
        case OfflineStatus::limit:
            return "limit";
        case OfflineStatus::unsupported:
            return "unsupported";
    }
    return "";
}

OfflineResult plan_offline(const KnowledgePlanner& planner, const OfflineOptions& options,
                           const Budget& budget) {
    return Offline(planner, options, budget)();
}

}  // namespace praxis::belief
