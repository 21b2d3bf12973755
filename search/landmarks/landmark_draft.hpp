// The landmark graph in the making: landmarks come and go, orderings are a plain list.
#pragma once

#include <cstdint>
#include <vector>

#include "search/landmarks/landmark_graph.hpp"

namespace praxis {

struct LandmarkDraft {
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    struct Node {
        std::vector<Fact> facts;
        bool goal = false;
        std::uint32_t replaced_by = kNone;  ///< a landmark of one of the facts; then this one is no more
        std::vector<std::uint32_t> first_achievers;
    };
    struct Ordering {
        std::uint32_t before;
        std::uint32_t after;
        LandmarkOrdering ordering;
    };

    bool alive(std::uint32_t node) const { return nodes[node].replaced_by == kNone; }
    /// Follows replacements, drops orderings of a landmark with itself and all but the strongest between two
    /// landmarks; sorts by the landmark before, then the one after.
    void tidy();

    std::vector<Node> nodes;
    std::vector<Ordering> orderings;
    std::vector<Ordering> dropped;  ///< reasonable ones that were dropped because of a cycle
    bool complete = true;
};

/// Landmarks by backchaining from the goal, with greedy-necessary and natural orderings. `initial_values` are
/// complete.
LandmarkDraft backchain(const FiniteDomainTask& task, std::span<const Fact> goal,
                        std::span<const std::int32_t> initial_values, const LandmarkOptions& options);

/// Adds reasonable orderings to a tidy draft and leaves it tidy.
void add_reasonable_orderings(const FiniteDomainTask& task, LandmarkDraft& draft);

/// Removes orderings, weak ones first, until there is no cycle; the result is an order of the landmarks that
/// agrees with those that are left. The draft is tidy and stays so.
std::vector<std::uint32_t> break_cycles(LandmarkDraft& draft);

}  // namespace praxis
