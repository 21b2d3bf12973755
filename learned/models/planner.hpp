// A learned planner: a network that iterates on a map, and says at each cell where to go.
//
//     auto planner = make_planner<float>(options, seed);
//     auto trace = planner->trace(15, 15);
//     draw(problem, *trace);                // the map and the goal
//     planner->plan(*trace);                // trace->policy: logits of the moves, trace->values
//
// A planner owns its parameters, one flat array. A Trace is one thread's memory for maps of one size: the
// input, the output, and, after record(), what the way back needs. Planners are const while traces run, so
// that threads share them; after a change of the parameters, update() must be called.
//
// The input has two channels: 1 where a cell is free, and 1 at the goal. Behind the edge of a map (zero
// padding) there are walls, then.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "learned/kernels/planes.hpp"
#include "learned/layers/parameters.hpp"
#include "learned/models/planner_options.hpp"

namespace praxis::learned {

inline constexpr int kInputs = 2;

template <class T>
struct Trace {
    Planes<T> input;      ///< [free, goal]
    Planes<T> values;     ///< the field that was iterated on, at the end
    Planes<T> policy;     ///< logits of the moves, in the order of kMoves
    Planes<T> of_policy;  ///< their gradient, which the caller of differentiate() sets
    int iterations = 0;   ///< done in the last call
    double residual = 0;  ///< the largest change of a value in the last of them; implicit planners only
    int backward_iterations = 0;   ///< of the last differentiate(); implicit planners only
    double backward_residual = 0;  ///< relative to the gradient; implicit planners only

    virtual ~Trace() = default;
};

template <class T>
class Planner {
  public:
    explicit Planner(PlannerOptions options) : options_(std::move(options)) {}
    virtual ~Planner() = default;

    const PlannerOptions& options() const { return options_; }
    /// Run deeper or shallower than trained.
    void set_iterations(int iterations) { options_.iterations = iterations; }
    const ParameterLayout& layout() const { return layout_; }
    std::span<T> parameters() { return parameters_; }
    std::span<const T> parameters() const { return parameters_; }

    /// After the parameters were changed: brings them back within their bounds and renews what depends on
    /// them.
    virtual void update() = 0;

    virtual std::unique_ptr<Trace<T>> trace(int height, int width) const = 0;
    /// Reads trace.input, writes trace.values and trace.policy. The trace must be one of this planner's.
    virtual void plan(Trace<T>& trace) const = 0;
    /// The same, and keeps what differentiate() needs.
    virtual void record(Trace<T>& trace) const = 0;
    /// gradient += the gradient of the parameters, given trace.of_policy; follows record().
    virtual void differentiate(Trace<T>& trace, std::span<T> gradient) const = 0;

  protected:
    PlannerOptions options_;
    ParameterLayout layout_;
    std::vector<T> parameters_;
};

/// How many parameters a planner has, without building it; std::invalid_argument for options out of range.
std::size_t parameter_count(const PlannerOptions& options);

/// A planner with initial weights; std::invalid_argument for options out of range.
template <class T>
std::unique_ptr<Planner<T>> make_planner(const PlannerOptions& options, std::uint64_t seed);

}  // namespace praxis::learned
