#include "tamp/refine/refiner.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "search/thread_time.hpp"
#include "tamp/refine/plan_cost.hpp"
#include "tamp/refine/reachable.hpp"

namespace praxis::tamp {
namespace {

/// Skeletons that wait for more samples; the later ones are found again if they are wanted.
constexpr std::size_t kMostWaiting = 32;
constexpr std::size_t kMostReasons = 20;
constexpr std::uint32_t kMostCopies = 4;
constexpr std::uint32_t kFirstAttempts = 32;
constexpr std::uint32_t kLargestShift = 20;
/// Calls for one step by itself.
constexpr std::uint32_t kCallsAlone = 4096;
/// Streams up to this effort, in microseconds, are called for all their inputs to make a task exact.
constexpr double kCheap = 500;

class Stopwatch {
  public:
    explicit Stopwatch(double& seconds) : seconds_(seconds), start_(thread_seconds()) {}
    ~Stopwatch() { seconds_ += thread_seconds() - start_; }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    double& seconds_;
    double start_;
};

/// What a search has cost, in microseconds, roughly; counted, so that it is the same in every run.
double search_effort(const SymbolicTask& task, std::uint64_t evaluated) {
    return 100 + 0.2 * static_cast<double>(task.ground().operator_count()) +
           3 * static_cast<double>(evaluated);
}

}  // namespace

Refiner::Refiner(const RefinementProblem& problem, const Budget& budget, const RefineCallbacks& callbacks)
    : problem_(problem),
      budget_(budget),
      callbacks_(callbacks),
      search_(configuration(problem.options.search)),
      samples_(problem, budget, result_.statistics) {
    search_.seed = problem.options.seed;
}

Refinement Refiner::run() {
    const RefineOptions& options = problem_.options;
    Instantiation stage;
    stage.max_level = options.max_level;
    stage.max_instances = options.max_instances;
    End end = End::stuck;
    bool may_be_exact = options.prove_infeasible;
    for (stage.copies = 1; stage.copies <= kMostCopies; ++stage.copies) {
        const bool last = stage.copies == kMostCopies;
        const std::optional<SymbolicTask> task = make_task(stage);
        if (!task) return finish(End::stopped);
        end = work(*task, last ? 0xffffffff : 2);
        if (end == End::proved && !exact(*task)) end = End::stuck;
        if (end == End::unreachable) return finish(End::proved);
        if (end == End::solved || end == End::proved || end == End::stopped) return finish(end);
        if (!may_be_exact) continue;
        may_be_exact = false;
        Instantiation materialised = stage;
        materialised.copies = 1;
        materialised.materialise_effort = kCheap;
        const std::optional<SymbolicTask> exact_task = make_task(materialised);
        if (!exact_task) return finish(End::stopped);
        if (!exact(*exact_task)) continue;
        result_.statistics.exact = true;
        end = work(*exact_task, 0xffffffff);
        return finish(end == End::unreachable ? End::proved : end);
    }
    return finish(end);
}

std::optional<SymbolicTask> Refiner::make_task(const Instantiation& options) {
    RefineStatistics& statistics = result_.statistics;
    const Stopwatch watch(statistics.ground_seconds);
    definite_.clear();
    soft_.clear();
    waiting_.clear();
    examined_ = 0;
    forbidden_.clear();
    seen_alone_.clear();
    round_ = 0;
    OptimisticTask optimistic = instantiate(*problem_.task, samples_, options, budget_);
    if (budget_.exhausted() != Stop::none) return std::nullopt;
    std::optional<SymbolicTask> task(std::in_place, std::move(optimistic), problem_.task->certified, budget_);
    ++statistics.groundings;
    if (!task->grounded()) return std::nullopt;
    statistics.objects = task->lifted().objects.size();
    statistics.operators = task->ground().operator_count();
    return task;
}

bool Refiner::exact(const SymbolicTask& task) const {
    const OptimisticTask& optimistic = task.optimistic();
    if (!optimistic.complete || !optimistic.materialised) return false;
    for (std::size_t object = 0; object < task.shared().size(); ++object) {
        if (!task.shared()[object]) continue;
        const StreamInstance& instance = optimistic.instances[optimistic.producer[object]];
        if (samples_.info(instance.stream).max_samples != 1) return false;
    }
    return true;
}

Refiner::End Refiner::work(const SymbolicTask& task, std::uint32_t rounds) {
    RefineStatistics& statistics = result_.statistics;
    std::vector<Nogood> nogoods;
    for (;;) {
        if (budget_.exhausted() != Stop::none) return End::stopped;
        if (is_hopeless(task)) return End::unreachable;
        SymbolicTask::Found found;
        {
            const Stopwatch watch(statistics.search_seconds);
            nogoods = definite_;
            nogoods.insert(nogoods.end(), soft_.begin(), soft_.end());
            found = task.plan(nogoods, search_, budget_);
            ++statistics.searches;
            statistics.evaluated += found.evaluated;
        }
        if (found.plan) {
            if (try_new(task, std::move(*found.plan), search_effort(task, found.evaluated)))
                return End::solved;
            continue;
        }
        if (budget_.exhausted() != Stop::none) return End::stopped;
        const bool complete = found.status == Status::unsolvable || found.status == Status::unsolvable_early;
        if (soft_.empty()) return complete ? End::proved : End::stuck;
        if (++round_ > rounds) return End::patience;
        const std::uint64_t calls = statistics.stream_calls;
        const std::size_t known = definite_.size();
        if (try_again(task)) return End::solved;
        if (statistics.stream_calls == calls && definite_.size() == known) return End::stuck;
    }
}

bool Refiner::try_new(const SymbolicTask& task, SymbolicPlan plan, double effort) {
    ++result_.statistics.skeletons;
    Waiting next{make_skeleton(*problem_.task, task, std::move(plan)), round_};
    const double before = samples_.effort();
    std::vector<Lesson> lessons;
    for (;; ++next.tries) {
        if (attempt(task, next.skeleton, next.tries, lessons)) return true;
        const bool worth_more =
            !lessons.front().definite && samples_.effort() - before < effort && next.tries < round_ + 3;
        if (!worth_more || budget_.exhausted() != Stop::none) break;
    }
    if (callbacks_.on_progress) callbacks_.on_progress(result_.statistics);
    if (!remember(lessons)) remember({exclude(task, next.skeleton)});
    if (!lessons.front().definite && waiting_.size() < kMostWaiting) waiting_.push_back(std::move(next));
    return false;
}

bool Refiner::try_again(const SymbolicTask& task) {
    soft_.clear();
    std::vector<Waiting> still;
    for (Waiting& waiting : waiting_) {
        if (budget_.exhausted() != Stop::none) return false;
        std::vector<Lesson> lessons;
        if (attempt(task, waiting.skeleton, ++waiting.tries, lessons)) return true;
        remember(lessons);
        if (!lessons.front().definite) still.push_back(std::move(waiting));
    }
    waiting_ = std::move(still);
    return false;
}

bool Refiner::attempt(const SymbolicTask& task, const Skeleton& skeleton, std::uint32_t tries,
                      std::vector<Lesson>& lessons) {
    const Stopwatch watch(result_.statistics.sample_seconds);
    const std::uint32_t shift = std::min(tries, kLargestShift / 2);
    SampleLimits limits;
    limits.calls = (problem_.options.first_calls + 8 * static_cast<std::uint32_t>(skeleton.nodes.size()))
                   << shift;
    limits.attempts = kFirstAttempts << shift;
    limits.backjumping = problem_.options.backjumping;
    limits.blame = problem_.options.nogoods;
    std::vector<SampleOutcome> outcomes = sample(task, skeleton, samples_, limits, budget_);
    if (outcomes.front().solved) {
        report(task, skeleton, outcomes.front());
        return true;
    }
    lessons.clear();
    std::vector<Lesson> by_itself;
    if (limits.blame && outcomes.front().definite) look_alone(task, skeleton, outcomes.front(), by_itself);
    for (SampleOutcome& outcome : outcomes)
        for (Lesson& lesson : learn(*problem_.task, task, skeleton, std::move(outcome)))
            lessons.push_back(std::move(lesson));
    std::ranges::move(by_itself, std::back_inserter(lessons));
    return false;
}

void Refiner::look_alone(const SymbolicTask& task, const Skeleton& skeleton, const SampleOutcome& outcome,
                         std::vector<Lesson>& lessons) {
    std::set<std::uint32_t> steps;
    for (const std::uint32_t n : outcome.nodes)
        for (const Need& need : skeleton.nodes[n].needs)
            if (need.step < skeleton.plan.operators.size()) steps.insert(need.step);
    if (steps.size() < 2) return;
    const SampleLimits limits{kCallsAlone, kCallsAlone, problem_.options.backjumping, true};
    for (const std::uint32_t step : steps) {
        if (!seen_alone_.insert(skeleton.plan.operators[step]).second) continue;
        const Skeleton one = alone(skeleton, step);
        for (SampleOutcome& found : sample(task, one, samples_, limits, budget_)) {
            if (found.solved || !found.definite) continue;
            for (Lesson& lesson : learn(*problem_.task, task, one, std::move(found)))
                lessons.push_back(std::move(lesson));
        }
    }
}

bool Refiner::is_hopeless(const SymbolicTask& task) {
    if (!problem_.options.prove_infeasible || !task.optimistic().complete) return false;
    bool news = false;
    for (; examined_ < definite_.size(); ++examined_) {
        const Nogood& nogood = definite_[examined_];
        if (nogood.events.size() != 1 || !nogood.events.front().facts.empty()) continue;
        if (!nogood.events.front().op.valid()) continue;
        forbidden_.resize(task.ground().operator_count());
        forbidden_[nogood.events.front().op.index()] = true;
        news = true;
    }
    return news && is_free_of_equality(task.lifted()) && !is_goal_reachable(task.ground(), forbidden_);
}

bool Refiner::remember(const std::vector<Lesson>& lessons) {
    bool any = false;
    for (const Lesson& lesson : lessons) {
        std::vector<Nogood>& nogoods = lesson.definite ? definite_ : soft_;
        if (std::ranges::find(nogoods, lesson.nogood) != nogoods.end()) continue;
        any = true;
        nogoods.push_back(lesson.nogood);
        ++(lesson.definite ? result_.statistics.nogoods : result_.statistics.soft_nogoods);
        std::vector<std::string>& reasons = lesson.definite ? reasons_ : doubts_;
        if (reasons.size() < kMostReasons && std::ranges::find(reasons, lesson.reason) == reasons.end())
            reasons.push_back(lesson.reason);
    }
    return any;
}

void Refiner::report(const SymbolicTask& task, const Skeleton& skeleton, const SampleOutcome& outcome) {
    RefinedPlan plan;
    for (std::size_t s = 0; s < skeleton.plan.steps.size(); ++s) {
        RefinedStep& step = plan.steps.emplace_back();
        step.name = task.lifted().schemas[skeleton.plan.steps[s].schema.index()].name;
        for (const std::uint32_t slot : skeleton.arguments[s])
            step.arguments.push_back(samples_.value(outcome.values[slot]));
    }
    std::vector<ValueNumber> values;
    for (const auto& slots : skeleton.arguments)
        for (const std::uint32_t slot : slots) values.push_back(outcome.values[slot]);
    for (const SkeletonNode& node : skeleton.nodes) {
        for (const std::uint32_t slot : node.inputs) values.push_back(outcome.values[slot]);
        if (problem_.task->streams[node.stream.index()].fluents.empty()) continue;
        StreamFact& fact = plan.facts.emplace_back();
        fact.stream = node.stream;
        for (const std::uint32_t slot : node.inputs)
            fact.inputs.push_back(samples_.value(outcome.values[slot]));
        for (const std::uint32_t slot : node.outputs)
            fact.outputs.push_back(samples_.value(outcome.values[slot]));
    }
    samples_.add_facts(std::move(values), plan.facts);
    plan.cost = plan_cost(*problem_.task, skeleton, samples_, outcome.values);
    result_.plan = std::move(plan);
}

Refinement Refiner::finish(End end) {
    result_.attempts = samples_.attempts();
    if (end == End::solved) {
        result_.status = RefineStatus::solved;
        return std::move(result_);
    }
    const Stop stop = budget_.exhausted();
    result_.status = end == End::proved          ? RefineStatus::infeasible
                     : stop == Stop::interrupted ? RefineStatus::cancelled
                                                 : RefineStatus::out_of_budget;
    result_.reasons = std::move(reasons_);
    if (end != End::proved)
        for (const std::string& doubt : doubts_) result_.reasons.push_back(doubt + ", so far");
    if (end == End::stuck)
        result_.reasons.emplace_back("nothing is left to try, but not all failures are definite");
    if (!result_.reasons.empty()) return std::move(result_);
    for (const Attempt& attempt : result_.attempts)
        result_.reasons.push_back(attempt.stream + ": " + attempt.message + " (" +
                                  std::to_string(attempt.count) + " times)");
    if (result_.reasons.empty())
        result_.reasons.emplace_back(end == End::proved
                                         ? "no sequence of actions leads to the goal, whatever the "
                                           "streams give"
                                         : "the budget ended before anything failed");
    return std::move(result_);
}

}  // namespace praxis::tamp
