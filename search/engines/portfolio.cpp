// Engines side by side, each on a thread of its own: as many as there are threads work at once, the others
// wait for their turns.
#include <algorithm>
#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>
#include <system_error>
#include <thread>

#include "search/engines/search_plan.hpp"
#include "search/engines/turns.hpp"

namespace praxis {

namespace {

class Portfolio {
  public:
    Portfolio(const SearchRun& run, const Call& call)
        : run_(run),
          engines_(call["searches"].calls),
          first_(call.flag("first")),
          work_(
              static_cast<std::uint64_t>(std::clamp(call["turn"].real, 0.0, kLongestTurn) * kWorkPerSecond)),
          turns_(engines_.size(), static_cast<std::size_t>(std::max(run.threads, 1))),
          bound_(run.shared_bound == nullptr ? run.bound : std::min(run.bound, run.shared_bound->load())),
          budget_(run.budget),
          outcomes_(engines_.size()),
          progress_(engines_.size()),
          errors_(engines_.size()) {
        budget_.stop_with(stop_.get_token());
    }

    Outcome operator()() {
        const std::stop_callback passed_on(run_.budget.stop_token(), [this] { stop_.request_stop(); });
        {
            std::vector<std::jthread> threads;
            for (std::size_t i = 0; i < engines_.size(); ++i) {
                try {
                    threads.emplace_back([this, i] { work(i); });
                } catch (const std::system_error&) {  // no more threads: without this engine
                    outcomes_[i].status = Status::out_of_memory;
                    turns_.leave(i);
                }
            }
        }
        for (const std::exception_ptr& error : errors_) {
            if (error) std::rethrow_exception(error);
        }
        return sum();
    }

  private:
    void work(std::size_t i) {
        turns_.enter(i);
        try {
            run(i);
        } catch (...) {
            errors_[i] = std::current_exception();
            stop_.request_stop();
        }
        turns_.leave(i);
    }

    void run(std::size_t i) {
        if (const Stop stop = Budget(budget_).exhausted(); stop != Stop::none) {
            outcomes_[i].status = status_of(stop);
            return;
        }
        Seat seat(turns_, i, work_);
        const Budget budget = budget_;
        const SearchCallbacks callbacks{
            [this](std::span<const OperatorId> plan, std::int64_t cost) { offer(plan, cost); },
            run_.callbacks.on_progress ? [this, i](const SearchStatistics& now) { report(i, now); }
                                       : std::function<void(const SearchStatistics&)>()};
        const SearchRun part{run_.prepared, run_.query,
                             run_.shared,   run_.incumbent,
                             run_.seed + i, 1,
                             budget,        callbacks,
                             run_.bound,    first_ ? run_.shared_bound : &bound_,
                             &seat};
        outcomes_[i] = run_engine(part, engines_[i]);
        const Outcome& outcome = outcomes_[i];
        if (outcome.no_cheaper_plan || (first_ && outcome.plan)) stop_.request_stop();
    }

    void offer(std::span<const OperatorId> plan, std::int64_t cost) {
        const std::scoped_lock lock(mutex_);
        if (cost >= bound_) return;
        bound_ = cost;
        if (run_.callbacks.on_plan) run_.callbacks.on_plan(plan, cost);
    }

    /// What all engines have counted, where one of them reports.
    void report(std::size_t i, const SearchStatistics& now) {
        const std::scoped_lock lock(mutex_);
        progress_[i] = now;
        SearchStatistics all = now;
        for (std::size_t other = 0; other < progress_.size(); ++other) {
            if (other != i) all.add_counts(progress_[other]);
        }
        run_.callbacks.on_progress(all);
    }

    Outcome sum() const {
        const Outcome* best = &outcomes_.front();
        bool proof = false;
        for (const Outcome& outcome : outcomes_) {
            proof = proof || outcome.no_cheaper_plan;
            if (outcome.plan ? !best->plan || outcome.cost < best->cost
                             : !best->plan && rank(outcome.status) > rank(best->status)) {
                best = &outcome;
            }
        }
        Outcome result = *best;
        for (const Outcome& outcome : outcomes_) {
            if (&outcome != best) result.statistics.add_counts(outcome.statistics);
        }
        const Stop stop = Budget(run_.budget).exhausted();
        result.no_cheaper_plan = proof;
        result.optimal = result.optimal || (proof && result.plan && result.cost <= bound_);
        if (result.plan) {
            result.status = proof || first_ || stop == Stop::none ? Status::solved : status_of(stop);
        } else if (proof && best->status != Status::unsolvable) {
            result.status = Status::failed;
        } else if (!proof && stop != Stop::none) {
            result.status = status_of(stop);
        }
        return result;
    }

    /// Of what engines without a plan say, the most telling is what counts.
    static int rank(Status status) {
        switch (status) {
            case Status::unsolvable_early:
            case Status::unsolvable:
                return 3;
            case Status::out_of_memory:
                return 2;
            case Status::out_of_time:
                return 1;
            default:
                return 0;
        }
    }

    static constexpr double kLongestTurn = 1e9;    ///< seconds
    static constexpr double kWorkPerSecond = 1e9;  ///< see SearchMonitor

    const SearchRun& run_;
    const std::vector<Call>& engines_;
    bool first_;
    std::uint64_t work_;
    Turns turns_;
    std::stop_source stop_;
    std::mutex mutex_;
    SharedBound bound_;  ///< what a plan must be below to be of use
    Budget budget_;
    std::vector<Outcome> outcomes_;
    std::vector<SearchStatistics> progress_;
    std::vector<std::exception_ptr> errors_;
};

}  // namespace

Outcome run_portfolio(const SearchRun& run, const Call& call) {
    return Portfolio(run, call)();
}

}  // namespace praxis
