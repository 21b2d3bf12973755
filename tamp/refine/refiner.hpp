// The loop of task and motion planning: search for a skeleton, sample it, learn, search again.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "tamp/refine/learn.hpp"
#include "tamp/refine/refine.hpp"
#include "tamp/refine/sampler.hpp"

namespace praxis::tamp {

class Refiner {
  public:
    /// Keeps references to all three.
    Refiner(const RefinementProblem& problem, const Budget& budget, const RefineCallbacks& callbacks);
    Refinement run();

  private:
    /// How the work on one symbolic task ended.
    enum class End { solved, proved, unreachable, stuck, patience, stopped };

    /// A skeleton that failed for now.
    struct Waiting {
        Skeleton skeleton;
        std::uint32_t tries = 1;
    };

    std::optional<SymbolicTask> make_task(const Instantiation& options);
    /// What is proved of the symbolic task is proved of the problem.
    bool exact(const SymbolicTask& task) const;
    /// `rounds`: how often all skeletons get more samples before another symbolic task is worth a try.
    End work(const SymbolicTask& task, std::uint32_t rounds);
    /// True: solved.
    bool try_new(const SymbolicTask& task, SymbolicPlan plan, double search_effort);
    bool try_again(const SymbolicTask& task);
    bool attempt(const SymbolicTask& task, const Skeleton& skeleton, std::uint32_t tries,
                 std::vector<Lesson>& lessons);
    /// Where several steps failed together: whether one of them fails by itself, which teaches more.
    void look_alone(const SymbolicTask& task, const Skeleton& skeleton, const SampleOutcome& outcome,
                    std::vector<Lesson>& lessons);
    /// Actions that failed for good, whatever holds, keep the goal out of reach, however many values are
    /// sampled.
    bool is_hopeless(const SymbolicTask& task);
    /// False: all of it was known.
    bool remember(const std::vector<Lesson>& lessons);
    void report(const SymbolicTask& task, const Skeleton& skeleton, const SampleOutcome& outcome);
    Refinement finish(End end);

    const RefinementProblem& problem_;
    const Budget& budget_;
    const RefineCallbacks& callbacks_;
    Configuration search_;
    Refinement result_;
    Samples samples_;
    std::vector<Nogood> definite_;
    std::vector<Nogood> soft_;
    std::vector<Waiting> waiting_;
    std::set<OperatorId> seen_alone_;
    std::size_t examined_ = 0;  ///< of the definite nogoods, by `is_hopeless`
    std::vector<bool> forbidden_;  ///< operators that are never possible
    std::uint32_t round_ = 0;
    std::vector<std::string> reasons_;  ///< of definite failures
    std::vector<std::string> doubts_;   ///< of others
};

}  // namespace praxis::tamp
