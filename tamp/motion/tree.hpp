// A tree of configurations with nearest neighbours.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "tamp/collision/kernel.hpp"

namespace praxis::tamp {

/// Configurations of up to 16 numbers. Neighbours are found by looking at all nodes, eight at a time, on
/// floats: a thousand nodes of seven numbers take less than half a microsecond. Nothing is allocated but when
/// the tree outgrows its memory.
class Tree {
  public:
    static constexpr std::size_t kMaxDimension = 16;

    struct Neighbour {
        int node = 0;
        double distance = 0;
    };

    /// `periods`: of each variable, 0: none.
    explicit Tree(std::span<const double> periods) : dimension_(static_cast<int>(periods.size())) {
        for (std::size_t v = 0; v < periods.size(); ++v) {
            periods_[v] = static_cast<float>(periods[v]);
            periodic_ = periodic_ || periods[v] > 0;
        }
        positions_.reserve(kFirstNodes * periods.size());
        blocks_.reserve(kFirstNodes / kernel::kLanes * periods.size());
        parents_.reserve(kFirstNodes);
        radii_.reserve(kFirstNodes);
    }

    int size() const { return static_cast<int>(parents_.size()); }
    const double* operator[](int node) const {
        return &positions_[static_cast<std::size_t>(node * dimension_)];
    }
    int parent(int node) const { return parents_[static_cast<std::size_t>(node)]; }
    /// How far a sample may be that the node is extended to (dynamic domain).
    float& radius(int node) { return radii_[static_cast<std::size_t>(node)]; }

    int add(const double* positions, int parent) {
        const int node = size();
        const std::size_t lane = static_cast<std::size_t>(node % kernel::kLanes);
        if (lane == 0) blocks_.resize(blocks_.size() + static_cast<std::size_t>(dimension_), Block());
        Block* block = &blocks_[blocks_.size() - static_cast<std::size_t>(dimension_)];
        for (int v = 0; v < dimension_; ++v) block[v].numbers[lane] = static_cast<float>(positions[v]);
        positions_.insert(positions_.end(), positions, positions + dimension_);
        parents_.push_back(parent);
        radii_.push_back(std::numeric_limits<float>::infinity());
        return node;
    }

    Neighbour nearest(const double* positions) const {
        std::array<float, kMaxDimension> query;
        for (int v = 0; v < dimension_; ++v)
            query[static_cast<std::size_t>(v)] = static_cast<float>(positions[v]);
        float squared = 0;
        const int blocks = (size() + kernel::kLanes - 1) / kernel::kLanes;
        const int node =
            kernel::functions().nearest(blocks_.front().numbers.data(), blocks, dimension_, query.data(),
                                        periodic_ ? periods_.data() : nullptr, &squared);
        return {node, std::sqrt(static_cast<double>(squared))};
    }

  private:
    static constexpr std::size_t kFirstNodes = 512;

    /// One number of eight nodes; those that are not there are far away.
    struct alignas(32) Block {
        std::array<float, kernel::kLanes> numbers;
        Block() { numbers.fill(1e17F); }
    };

    int dimension_;
    bool periodic_ = false;
    std::array<float, kMaxDimension> periods_ = {};
    std::vector<Block> blocks_ = {};
    std::vector<double> positions_ = {};
    std::vector<int> parents_ = {};
    std::vector<float> radii_ = {};
};

}  // namespace praxis::tamp
