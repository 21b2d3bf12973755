// Novelty of states among those with as many goals missing (Lipovetzky and Geffner, AAAI 2017, BFWS).
//
// A state is of novelty 1 if it has an atom that no state before it had with the same number of missing goals,
// 2 if it has such a pair of atoms, 3 otherwise. Pairs are looked for among those with an atom that the last
// action added, and remembered as bits of a table of fixed size under a hash (Katz et al. and Singh et al. 2021
// show that approximations do little harm): memory stays bounded, and a wrong answer only changes the order of
// search.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/lifted/atom_table.hpp"

namespace praxis::lifted {

class NoveltyTable {
  public:
    explicit NoveltyTable(std::size_t pair_bits) : pairs_(pair_bits / 64 + 1, 0), pair_bits_(pair_bits) {}

    /// Of a state with these atoms, of which the last action added some; and remembers it. `moved`: its
    /// predecessor belongs to another partition.
    int measure(std::uint32_t partition, std::span<const AtomNumber> atoms,
                std::span<const AtomNumber> added, bool moved);

    std::size_t memory() const;

  private:
    static bool set(std::vector<std::uint64_t>& bits, std::size_t bit) {
        std::uint64_t& word = bits[bit / 64];
        const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
        const bool fresh = (word & mask) == 0;
        word |= mask;
        return fresh;
    }
    bool mark_atoms(std::uint32_t partition, std::span<const AtomNumber> atoms);
    bool mark_pairs(std::uint32_t partition, std::span<const AtomNumber> atoms,
                    std::span<const AtomNumber> added);

    std::vector<std::vector<std::uint64_t>> atoms_;  ///< by partition
    std::vector<std::uint64_t> pairs_;
    std::size_t pair_bits_;
};

}  // namespace praxis::lifted
