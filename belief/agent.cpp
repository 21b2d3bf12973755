#include "belief/agent.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "belief/evidence.hpp"

namespace praxis::belief {

AgentOptions default_agent_options(std::size_t axioms) {
    // LAMA's first search, then what blind search can still improve in about a millisecond.
    const std::string estimates = "[ff(cost_type=one),landmark_sum(cost_type=one)]";
    const double work = 0.001 / (1 + static_cast<double>(axioms) / 300);
    AgentOptions options;
    options.first = configuration("iterated([lazy_greedy(" + estimates + ",preferred=" + estimates +
                                  ",cost_type=one),astar(blind(),max_work=" + std::to_string(work) +
                                  ")],repeat_last=false,improve=false)");
    options.second = alias("agile");
    return options;
}

const char* to_string(RunStatus status) {
    switch (status) {
        case RunStatus::reached:
            return "reached";
        case RunStatus::infeasible:
            return "infeasible";
        case RunStatus::not_found:
            return "not found";
        case RunStatus::stuck:
            return "stuck";
        case RunStatus::step_limit:
            return "step limit";
        case RunStatus::out_of_time:
            return "out of time";
        case RunStatus::out_of_memory:
            return "out of memory";
        case RunStatus::interrupted:
            return "interrupted";
        case RunStatus::illegal:
            return "illegal";
        case RunStatus::found_objects:
            return "found objects";
        case RunStatus::contradiction:
            return "contradiction";
    }
    return "";
}

class Agent::Run {
  public:
    Run(const KnowledgePlanner& planner, const AgentOptions& options, Belief& belief,
        Environment& environment, const Budget& budget,
        const std::function<void(const Event&, const Belief&)>& watch)
        : planner_(planner),
          options_(options),
          belief_(belief),
          environment_(environment),
          budget_(budget),
          watch_(watch) {
        if (options.accept > 0) evidence_.emplace(belief, options.accept);
    }

    RunResult operator()() {
        if (!belief_.consistent()) {
            finish(RunStatus::contradiction, "no first state satisfies the initial description");
        } else if (observe(Environment::kStart)) {
            while (!ended_ && !belief_.goal_known() && make_plan()) follow_plan();
            if (!ended_ && belief_.goal_known()) finish(RunStatus::reached, "");
        }
        return std::move(result_);
    }

  private:
    bool finish(RunStatus status, std::string message) {
        ended_ = true;
        result_.status = status;
        result_.message = std::move(message);
        std::string text = to_string(status);
        if (!result_.message.empty()) text += ": " + result_.message;
        tell(Event::Kind::finished, std::move(text));
        return false;
    }

    void tell(const Event& event) const {
        if (watch_) watch_(event, belief_);
    }
    void tell(Event::Kind kind, std::string text) const {
        Event event;
        event.kind = kind;
        event.text = std::move(text);
        tell(event);
    }
    /// Tells what is supposed after failures; false if nothing is in doubt.
    bool tell(const std::optional<Supposition>& supposed) const {
        if (!supposed) return false;
        if (!supposed->facts.empty())
            tell(Event::Kind::supposed, to_string(*supposed, *planner_.compilation().belief().physical));
        return true;
    }

    std::string text(Fact fact) const { return planner_.compilation().belief().physical->fact_name(fact); }

    bool exhausted() {
        switch (budget_.exhausted()) {
            case Stop::none:
                return false;
            case Stop::time:
                return !finish(RunStatus::out_of_time, "");
            case Stop::memory:
                return !finish(RunStatus::out_of_memory, "");
            case Stop::interrupted:
                return !finish(RunStatus::interrupted, "");
        }
        return false;
    }

    /// Takes in what is read after an action. False if the run is over.
    bool observe(std::uint32_t action) {
        for (const Answer& answer : environment_.observe(action, budget_.stop_token())) {
            const bool news = !belief_.knows(answer.fact);
            if (evidence_) {
                evidence_->read(answer);
            } else if (!belief_.learn(answer.fact)) {
                if (options_.ignore_contradictions) continue;
                return finish(RunStatus::contradiction, "read " + text(answer.fact));
            }
            if (news && watch_) tell(Event::Kind::read, text(answer.fact));
        }
        if (!environment_.found_objects()) return true;
        ended_ = true;
        result_.status = RunStatus::found_objects;
        return false;
    }

    bool make_plan() {
        if (exhausted()) return false;
        if (result_.plans >= options_.most_plans) return finish(RunStatus::step_limit, "too many plans");
        const std::size_t visits = ++visits_[belief_.fingerprint() + (evidence_ ? evidence_->readings() : 0)];
        if (visits > options_.most_returns) return finish(RunStatus::stuck, "what is known does not change");
        Configuration first = options_.first;
        first.seed += visits - 1;
        Random random(options_.first.seed + result_.plans);
        belief_.begin_plan(random);
        KnowledgePlan plan = planner_.plan(belief_, first, budget_.within(options_.plan_seconds));
        double seconds = plan.seconds;
        if (plan.status == Status::out_of_time || plan.status == Status::failed) {
            plan = planner_.plan(belief_, options_.second, budget_.within(options_.second_seconds));
            seconds += plan.seconds;
        }
        ++result_.plans;
        result_.plan_seconds.push_back(seconds);
        if (plan.status != Status::solved && evidence_ && evidence_->guess()) return make_plan();
        if (plan.status != Status::solved) return no_plan(plan.status);
        // What is in doubt is found out by doing the rest as if it were not as the goal wants it.
        if (plan.steps.empty() &&
            tell(evidence_ ? evidence_->suppose_otherwise() : belief_.suppose_otherwise()))
            return make_plan();
        steps_ = std::move(plan.steps);
        Event event;
        event.text = reason_;
        event.seconds = seconds;
        for (OperatorId step : steps_) {
            const std::uint32_t action = planner_.compilation().origin(step).action;
            if (action != CompiledOperator::kNone) event.plan.push_back(action);
        }
        tell(event);
        return true;
    }

    bool no_plan(Status status) {
        switch (status) {
            case Status::unsolvable:
            case Status::unsolvable_early:
                if (planner_.compilation().belief().physical->proved_unsolvable)
                    return finish(RunStatus::infeasible, "no plan reaches the goal, whatever is true");
                return finish(RunStatus::not_found, "no plan with what is known and can be found out");
            case Status::out_of_memory:
                return finish(RunStatus::out_of_memory, "");
            case Status::out_of_time:
                if (exhausted()) return false;
                return finish(RunStatus::not_found, "no plan in the time that one plan may take");
            case Status::interrupted:
                return finish(RunStatus::interrupted, "");
            default:
                return finish(RunStatus::not_found, "");
        }
    }

    void follow_plan() {
        for (std::size_t next = 0; next < steps_.size() && !belief_.goal_known(); ++next) {
            if (exhausted()) return;
            if (!planner_.still_good(belief_, steps_, next)) {
                reason_ = "not as assumed";
                return;
            }
            read_early(next);
            const OperatorId step = steps_[next];
            if (planner_.superfluous(belief_, step)) continue;
            if (!belief_.can(planner_.compilation().origin(step).action)) {
                belief_.remember_exception(planner_.compilation().origin(step).action);
                reason_ = "an action may not be possible";
                return;
            }
            if (!execute(planner_.compilation().origin(step).action)) return;
        }
        reason_ = "the plan has ended";
    }

    /// What can be found out now is found out now, where the plan allows it: the next reading comes first.
    void read_early(std::size_t next) {
        const Compilation& compilation = planner_.compilation();
        for (std::size_t i = next; i < steps_.size(); ++i) {
            const CompiledOperator& origin = compilation.origin(steps_[i]);
            if (!origin.reads || origin.action == CompiledOperator::kNone) continue;
            if (i == next || planner_.superfluous(belief_, steps_[i]) || !belief_.can(origin.action)) return;
            std::vector<OperatorId> order = steps_;
            std::rotate(order.begin() + static_cast<std::ptrdiff_t>(next),
                        order.begin() + static_cast<std::ptrdiff_t>(i),
                        order.begin() + static_cast<std::ptrdiff_t>(i) + 1);
            if (planner_.still_good(belief_, order, next)) steps_ = std::move(order);
            return;
        }
    }

    /// False if the plan cannot go on.
    bool execute(std::uint32_t action) {
        if (result_.actions.size() >= options_.most_steps) return finish(RunStatus::step_limit, "");
        const Execution execution = environment_.execute(action, budget_.stop_token());
        Event event;
        event.action = action;
        event.text = execution.message;
        event.kind =
            execution.status == Execution::Status::done ? Event::Kind::executed : Event::Kind::failed;
        result_.actions.push_back(action);
        if (execution.status == Execution::Status::illegal) {
            tell(event);
            reason_ = "an action was refused";
            if (!tell(evidence_ ? evidence_->refuse(action) : belief_.refuse(action)))
                finish(RunStatus::illegal, execution.message);
            return false;
        }
        if (execution.status == Execution::Status::failed) {
            const auto supposed = evidence_ ? evidence_->fail(action) : belief_.fail(action);
            tell(event);
            tell(supposed);
            reason_ = "an action failed";
            observe(action);
            return false;
        }
        if (evidence_)
            evidence_->act(action);
        else
            belief_.act(action);
        tell(event);
        return observe(action);
    }

    const KnowledgePlanner& planner_;
    const AgentOptions& options_;
    Belief& belief_;
    Environment& environment_;
    const Budget& budget_;
    const std::function<void(const Event&, const Belief&)>& watch_;
    RunResult result_;
    std::optional<Evidence> evidence_;
    std::vector<OperatorId> steps_;
    std::string reason_ = "the first plan";
    std::unordered_map<std::uint64_t, std::size_t> visits_;
    bool ended_ = false;
};

Agent::Agent(std::shared_ptr<const KnowledgePlanner> planner, AgentOptions options)
    : planner_(std::move(planner)), options_(std::move(options)) {}

RunResult Agent::run(Belief& belief, Environment& environment, const Budget& budget,
                     const std::function<void(const Event&, const Belief&)>& watch) const {
    return Run(*planner_, options_, belief, environment, budget, watch)();
}

}  // namespace praxis::belief
