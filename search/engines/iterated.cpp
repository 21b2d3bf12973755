#include <algorithm>
#include <chrono>

#include "search/engines/search_plan.hpp"
#include "search/improve/improve_plan.hpp"
#include "search/improve/plan_execution.hpp"

namespace praxis {

namespace {

class Iterated {
  public:
    Iterated(const SearchRun& run, const Call& call)
        : run_(run),
          engines_(call["searches"].calls),
          first_(call.flag("first")),
          repeat_last_(call.flag("repeat_last")),
          share_(call.flag("share")),
          improve_(call.flag("improve")) {}

    Outcome operator()() {
        for (std::size_t next = 0; next < engines_.size();) {
            const std::int64_t bound = best_.plan ? std::min(best_.cost, run_.bound) : run_.bound;
            const SearchCallbacks callbacks{
                [this](std::span<const OperatorId> plan, std::int64_t cost) { report(plan, cost); },
                run_.callbacks.on_progress};
            const bool last = next + 1 == engines_.size();
            const Budget share = share_ && bound != kInfinity && !last
                                     ? run_.budget.within(std::max(kLeastSeconds, elapsed()))
                                     : run_.budget;
            Outcome outcome =
                run_engine({run_.prepared, run_.query, run_.shared, run_.incumbent, run_.seed, run_.threads,
                            share, callbacks, bound, run_.shared_bound, run_.seat},
                           engines_[next]);
            add(outcome.statistics);
            best_.status = outcome.status;
            const bool found = outcome.status == Status::solved;
            if (outcome.plan) {
                take(outcome);
            } else if (outcome.no_cheaper_plan) {
                best_.no_cheaper_plan = true;
                best_.optimal =
                    best_.plan && (run_.shared_bound == nullptr || best_.cost <= *run_.shared_bound);
                break;
            }
            if (run_.budget.exhausted() != Stop::none) break;
            if (best_.optimal || (best_.plan && (first_ || best_.cost == 0))) break;
            if (!last || !repeat_last_ || !found) ++next;
        }
        if (best_.plan && run_.budget.exhausted() == Stop::none) best_.status = Status::solved;
        return best_;
    }

  private:
    void take(const Outcome& outcome) {
        if (outcome.cost > best_.cost) return;
        best_.optimal = outcome.optimal;
        if (!improve_ || first_ || best_.optimal || run_.budget.exhausted() != Stop::none) return;
        std::vector<OperatorId> better =
            improve_plan(run_.prepared, run_.query, *best_.plan,
                         run_.budget.within(std::max(kLeastSeconds, elapsed() / 2)));
        report(better, cost_of(run_.prepared.task(), better).cost);
    }

    void report(std::span<const OperatorId> plan, std::int64_t cost) {
        if (best_.plan && cost >= best_.cost) return;
        best_.plan.emplace(plan.begin(), plan.end());
        best_.cost = cost;
        if (run_.callbacks.on_plan) run_.callbacks.on_plan(*best_.plan, cost);
    }

    /// Counters add up; what describes one search is that of the last.
    void add(const SearchStatistics& last) {
        SearchStatistics sum = best_.statistics;
        sum.seconds += last.seconds;
        sum.add_counts(last);
        sum.registered_states = last.registered_states;
        sum.bytes_per_state = last.bytes_per_state;
        sum.best_estimate = last.best_estimate;
        best_.statistics = sum;
    }

    /// A search for a cheaper plan, if searches share the time, and the improvement of a plan may take this
    /// long; or, if that is more, as long (half as long) as all before together.
    static constexpr double kLeastSeconds = 2;
    double elapsed() const { return std::chrono::duration<double>(Budget::Clock::now() - start_).count(); }

    const SearchRun& run_;
    const std::vector<Call>& engines_;
    const Budget::Clock::time_point start_ = Budget::Clock::now();
    bool first_;
    bool repeat_last_;
    bool share_;
    bool improve_;
    Outcome best_;
};

}  // namespace

Outcome run_iterated(const SearchRun& run, const Call& call) {
    return Iterated(run, call)();
}

}  // namespace praxis
