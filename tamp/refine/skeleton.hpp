// A symbolic plan with what has to be sampled for it.
//
// A *slot* is what gets one value: a known object, a placeholder that is shared by the whole plan, or another
// placeholder in one action. A *node* is one use of a stream: it reads slots and fills slots; it comes after
// the nodes that fill what it reads and after those that its domain relies on. A *need* says why a node is
// there: an action whose condition relies on it, perhaps because of some atoms of the state.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tamp/refine/symbolic.hpp"

namespace praxis::tamp {

struct Slot {
    ObjectId object;
    std::uint32_t node = OptimisticTask::kNone;  ///< that fills it; kNone: the value is known
};

struct Need {
    std::uint32_t step = 0;  ///< the number of steps stands for the goal
    std::vector<GroundAtom> because;
    bool choice = false;
    friend bool operator==(const Need&, const Need&) = default;
};

/// An atom of the state that a stream is told of.
struct SkeletonFluent {
    GroundAtom atom;
    std::vector<std::uint32_t> slots;  ///< by argument
};

struct SkeletonNode {
    StreamId stream;
    std::uint32_t step = 0;              ///< the first that needs it; the only one if there are fluents
    std::vector<std::uint32_t> inputs;   ///< slots
    std::vector<std::uint32_t> outputs;  ///< slots
    std::vector<SkeletonFluent> fluents;
    std::vector<std::uint32_t> after;  ///< nodes that come before it, beside those that fill its slots
    std::vector<Need> needs;
};

struct Skeleton {
    SymbolicPlan plan;
    std::vector<std::vector<std::uint32_t>> arguments;  ///< slots, by step
    std::vector<Slot> slots;
    std::vector<SkeletonNode> nodes;  ///< each after those that it depends on
};

/// Throws UnsupportedError if an output of a stream with fluents gets into states.
Skeleton make_skeleton(const StreamTask& streams, const SymbolicTask& task, SymbolicPlan plan);

/// Only the nodes that one step needs, with those that they depend on; all else is the same.
Skeleton alone(const Skeleton& skeleton, std::uint32_t step);

/// "(pick a #g-12)", with the names of the symbolic task; "the goal" behind the last step.
std::string step_text(const SymbolicTask& task, const Skeleton& skeleton, std::uint32_t step);
/// "(at-pose a p0)".
std::string atom_text(const LiftedTask& task, const GroundAtom& atom);

}  // namespace praxis::tamp
