// Novelty of states, each among those of its *partition*: as many goals missing and as far along the relaxed
// plan (Lipovetzky and Geffner, AAAI 2017, best-first width search).
//
// A state is of novelty 1 if it has an atom that no state before it had in the partition, 2 if the last
// action made an atom true beside another for the first time, 3 otherwise. Pairs are remembered as bits of a
// table of fixed size, the row of the atom made starting at a place given by a hash, so that a state is
// looked up in as many stretches as the action made atoms; rows may overlap. Atoms have a bit each in every
// partition, up to 128 MiB in all; those beyond count as seen. So memory stays bounded, and a wrong answer
// only changes the order of search.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/lifted/atom_table.hpp"

namespace praxis::lifted {

class NoveltyTable {
  public:
    /// `pair_bits`: a power of two, at least 64; 0: no pairs are looked for.
    explicit NoveltyTable(std::size_t pair_bits) : pairs_(pair_bits / 64, 0) {}

    /// Of a state with these atoms, of which the last action added some; and remembers it. `moved`: its
    /// predecessor belongs to another partition.
    int measure(std::uint32_t partition, std::span<const AtomNumber> atoms, std::span<const AtomNumber> added,
                bool moved);

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

    static constexpr std::size_t kMostAtomWords = std::size_t{1} << 24;

    std::vector<std::vector<std::uint64_t>> atoms_;  ///< by partition
    std::size_t atom_words_ = 0;
    std::vector<std::uint64_t> pairs_;
};

}  // namespace praxis::lifted
