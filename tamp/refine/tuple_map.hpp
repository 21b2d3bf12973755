// Numbers by lists of numbers: ground atoms, instances of streams.
#pragma once

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace praxis::tamp {

using Tuple = std::vector<std::uint32_t>;

inline std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0xff51afd7ed558ccdU;
    return hash ^ (hash >> 32);
}

struct TupleHash {
    std::size_t operator()(const Tuple& tuple) const {
        std::uint64_t hash = 0x9e3779b97f4a7c15U;
        for (const std::uint32_t word : tuple) hash = mix(hash, word);
        return static_cast<std::size_t>(hash);
    }
};

template <class T>
using TupleMap = std::unordered_map<Tuple, T, TupleHash>;

}  // namespace praxis::tamp
