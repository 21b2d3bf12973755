// What a search remembers about a stored state.
//
// The parent, then g with the status in its two low bits (one word, or two where operator costs are large),
// then, where the search asks for them, the real cost of the way and the estimates. The operator that led
// here is not stored: it is found again from the two states when the plan is written down.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "search/evaluators/evaluator.hpp"
#include "search/state/ids.hpp"

namespace praxis {

enum class NodeStatus : std::uint8_t { open, closed, dead_end };

/// Where the fields of a node lie among its words.
class NodeLayout {
  public:
    /// `wide`: costs need 64 bits; `real_cost`: it is not the same as g and is needed.
    NodeLayout(bool wide, bool real_cost, std::size_t estimates)
        : wide_(wide), cost_words_(wide ? 2 : 1), real_cost_(real_cost), estimates_(estimates) {}

    std::size_t word_count() const { return first_estimate() + estimates_; }

    void initialize(std::uint32_t* node, StateId parent, std::int64_t g, std::int64_t real_cost) const {
        node[0] = parent.index();
        write(node + 1, g, NodeStatus::open);
        if (real_cost_) write(node + 1 + cost_words_, real_cost, NodeStatus::open);
    }
    /// A cheaper way has been found. The status stays.
    void improve(std::uint32_t* node, StateId parent, std::int64_t g, std::int64_t real_cost) const {
        const NodeStatus kept = status(node);
        initialize(node, parent, g, real_cost);
        set_status(node, kept);
    }

    StateId parent(const std::uint32_t* node) const {
        return node[0] == StateId().index() ? StateId() : StateId(node[0]);
    }
    std::int64_t g(const std::uint32_t* node) const { return read(node + 1); }
    std::int64_t real_cost(const std::uint32_t* node) const {
        return read(node + 1 + (real_cost_ ? cost_words_ : 0));
    }
    NodeStatus status(const std::uint32_t* node) const { return static_cast<NodeStatus>(node[1] & 3); }
    void set_status(std::uint32_t* node, NodeStatus status) const {
        node[1] = (node[1] & ~3u) | static_cast<std::uint32_t>(status);
    }
    Estimate estimate(const std::uint32_t* node, std::size_t i) const {
        return static_cast<Estimate>(node[first_estimate() + i]);
    }
    void set_estimate(std::uint32_t* node, std::size_t i, Estimate estimate) const {
        node[first_estimate() + i] = static_cast<std::uint32_t>(estimate);
    }

  private:
    std::size_t first_estimate() const { return 1 + cost_words_ * (real_cost_ ? 2 : 1); }

    std::int64_t read(const std::uint32_t* words) const {
        const std::uint64_t high = wide_ ? words[1] : 0;
        return static_cast<std::int64_t>((high << 32 | words[0]) >> 2);
    }
    void write(std::uint32_t* words, std::int64_t cost, NodeStatus status) const {
        const std::uint64_t bits = static_cast<std::uint64_t>(cost) << 2 | static_cast<std::uint64_t>(status);
        if (cost >> (wide_ ? 61 : 30) != 0) throw std::overflow_error("the cost of a path is too large");
        words[0] = static_cast<std::uint32_t>(bits);
        if (wide_) words[1] = static_cast<std::uint32_t>(bits >> 32);
    }

    bool wide_;
    std::size_t cost_words_;
    bool real_cost_;
    std::size_t estimates_;
};

}  // namespace praxis
