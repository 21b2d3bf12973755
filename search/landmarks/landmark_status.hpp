// Which landmarks have been reached on the way to a state.
//
// A landmark is *past* in a state if on every path found so far it has held, at a time when all landmarks
// ordered before it were past already (in the state before; for landmarks of derived variables, in the same
// state). A landmark is *future* if it is not past, or if it is past but *required again*: it does not hold,
// and it is a goal or a greedy-necessary predecessor of a landmark that is not past; or it has to be given up
// for a landmark that is not past and is needed after that one. From Richter and Westphal, "The LAMA Planner"
// (JAIR 2010), section 5; the last case from Buechner, Keller, Eriksson and Helmert, "Landmark Progression in
// Heuristic Search" (ICAPS 2023).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "search/evaluators/evaluator.hpp"
#include "search/landmarks/landmark_bits.hpp"
#include "search/landmarks/landmark_graph.hpp"

namespace praxis {

/// The past landmarks of the states of one search: one bit a landmark and one more a state, in blocks by
/// state id. Refers to the graph.
class LandmarkStatus {
  public:
    explicit LandmarkStatus(const LandmarkGraph& graph);

    std::size_t words() const { return (graph_.size() + 63) / 64; }

    /// Forgets all states but this one.
    void start(StateId initial, StateView state);
    /// A step from a known state; what the child's past was by other paths is kept only where this one
    /// agrees.
    void follow(StateId parent, StateId child, StateView child_state);

    bool known(StateId state) const;
    /// Of a known state.
    void past(StateId state, std::span<LandmarkWord> past) const;

    /// The past of a state that a path begins with.
    void initial_past(StateView state, std::span<LandmarkWord> past) const;
    /// Past and required again.
    void required_again(StateView state, LandmarkBits past, std::span<LandmarkWord> required) const;
    /// All landmarks ordered before this one are past.
    bool leaf(std::size_t landmark, LandmarkBits past) const;

    /// Bytes on the heap.
    std::size_t memory() const;

  private:
    static constexpr std::uint32_t kBlockShift = 12;
    static constexpr std::uint32_t kBlockMask = (std::uint32_t{1} << kBlockShift) - 1;

    /// The landmarks' bits and, after the last, whether the state is known; null if its block is not there.
    LandmarkWord* find(StateId state) const;
    LandmarkWord* find_or_make(StateId state);
    void reach(StateView state, LandmarkBits before, std::span<LandmarkWord> past) const;

    const LandmarkGraph& graph_;
    std::size_t stride_;
    std::vector<LandmarkWord> may_return_;  ///< landmarks that may be required again
    PackedLists<std::uint32_t> enabled_;    ///< by landmark: those it is greedy-necessarily before
    std::vector<std::unique_ptr<LandmarkWord[]>> blocks_;
    std::vector<LandmarkWord> scratch_;
    std::vector<LandmarkWord> parent_past_;
};

}  // namespace praxis
