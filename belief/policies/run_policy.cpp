#include "belief/policies/run_policy.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace praxis::belief {
namespace {

class PolicyRun {
  public:
    PolicyRun(Policy& policy, const PolicyContext& context, Belief& belief, Environment& environment,
              const Budget& budget, const std::function<void(const Event&, const Belief&)>& watch)
        : policy_(policy),
          context_(context),
          belief_(belief),
          environment_(environment),
          budget_(budget),
          watch_(watch) {}

    PolicyResult operator()() {
        if (!belief_.consistent()) {
            finish(RunStatus::contradiction, "no first state satisfies the initial description");
        } else {
            observe(Environment::kStart);
        }
        while (!ended_) step();
        const auto seconds = policy_.plan_seconds();
        result_.run.plan_seconds.insert(result_.run.plan_seconds.begin(), seconds.begin(), seconds.end());
        result_.run.plans = result_.run.plan_seconds.size();
        return std::move(result_);
    }

  private:
    const BeliefTask& task() const { return belief_.compilation().belief(); }

    void step() {
        if (belief_.goal_known()) return finish(RunStatus::reached, "");
        if (const Stop stop = budget_.exhausted(); stop != Stop::none)
            return finish(status_of_stop(stop), "");
        if (result_.steps >= context_.options.most_steps) return finish(RunStatus::step_limit, "");
        const Decision decision = policy_.next(belief_, budget_);
        if (decision.kind == Decision::Kind::stop) return finish(RunStatus::stuck, "");
        if (decision.kind == Decision::Kind::plan) return plan();
        act(decision.action);
    }

    void act(std::uint32_t action) {
        ++result_.steps;
        const Execution execution = environment_.execute(action, budget_.stop_token());
        using Status = Execution::Status;
        std::optional<Supposition> supposed;
        if (execution.status == Status::done) {
            if (!belief_.can(action)) learn_precondition(action);
            belief_.act(action);
        } else if (execution.status == Status::failed) {
            supposed = belief_.fail(action);
        }
        tell(execution.status == Status::done ? Event::Kind::executed : Event::Kind::failed, action,
             execution.message);
        const bool refused = execution.status == Status::illegal;
        if (refused && policy_.tries_anything()) return;
        result_.run.actions.push_back(action);
        if (execution.status != Status::done) policy_.failed();
        if (refused) supposed = belief_.refuse(action);
        if (supposed && !supposed->facts.empty())
            tell(Event::Kind::supposed, Environment::kStart, to_string(*supposed, *task().physical));
        if (!refused) return observe(action);
        if (!supposed) finish(RunStatus::illegal, execution.message);
    }

    /// The loop does the rest.
    void plan() {
        AgentOptions options = context_.options;
        options.most_steps -= result_.steps;
        RunResult rest =
            Agent(context_.planner, std::move(options)).run(belief_, environment_, budget_, watch_);
        result_.steps += rest.actions.size();
        rest.actions.insert(rest.actions.begin(), result_.run.actions.begin(), result_.run.actions.end());
        result_.run = std::move(rest);
        ended_ = true;
    }

    static RunStatus status_of_stop(Stop stop) {
        if (stop == Stop::time) return RunStatus::out_of_time;
        return stop == Stop::memory ? RunStatus::out_of_memory : RunStatus::interrupted;
    }

    /// What the world has executed was possible.
    void learn_precondition(std::uint32_t action) {
        const FiniteDomainTask& physical = *task().physical;
        for (const Fact& fact : physical.preconditions[action])
            if (!physical.derived(fact.variable)) belief_.learn(fact);
    }

    void observe(std::uint32_t action) {
        const std::vector<Answer> answers = environment_.observe(action, budget_.stop_token());
        policy_.observed(answers);
        for (const Answer& answer : answers) {
            const bool news = !belief_.knows(answer.fact);
            if (!belief_.learn(answer.fact)) {
                if (context_.options.ignore_contradictions) continue;
                return finish(RunStatus::contradiction, "read " + task().physical->fact_name(answer.fact));
            }
            if (news && watch_)
                tell(Event::Kind::read, Environment::kStart, task().physical->fact_name(answer.fact));
        }
    }

    void finish(RunStatus status, std::string message) {
        ended_ = true;
        result_.run.status = status;
        result_.run.message = std::move(message);
        std::string text = to_string(status);
        if (!result_.run.message.empty()) text += ": " + result_.run.message;
        tell(Event::Kind::finished, Environment::kStart, std::move(text));
    }

    void tell(Event::Kind kind, std::uint32_t action, std::string text) const {
        if (!watch_) return;
        Event event;
        event.kind = kind;
        event.action = action;
        event.text = std::move(text);
        watch_(event, belief_);
    }

    Policy& policy_;
    const PolicyContext& context_;
    Belief& belief_;
    Environment& environment_;
    const Budget& budget_;
    const std::function<void(const Event&, const Belief&)>& watch_;
    PolicyResult result_;
    bool ended_ = false;
};

}  // namespace

PolicyResult run_policy(Policy& policy, const PolicyContext& context, Belief& belief,
                        Environment& environment, const Budget& budget,
                        const std::function<void(const Event&, const Belief&)>& watch) {
    return PolicyRun(policy, context, belief, environment, budget, watch)();
}

}  // namespace praxis::belief
