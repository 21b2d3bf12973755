#include "search/lifted/novelty_table.hpp"

#include <algorithm>

namespace praxis::lifted {

bool NoveltyTable::mark_atoms(std::uint32_t partition, std::span<const AtomNumber> atoms) {
    if (partition >= atoms_.size()) atoms_.resize(partition + std::size_t{1});
    std::vector<std::uint64_t>& seen = atoms_[partition];
    bool fresh = false;
    for (const AtomNumber atom : atoms) {
        if (atom / 64 >= seen.size()) seen.resize(atom / 64 + atom / 256 + 1, 0);
        fresh |= set(seen, atom);
    }
    return fresh;
}

bool NoveltyTable::mark_pairs(std::uint32_t partition, std::span<const AtomNumber> atoms,
                              std::span<const AtomNumber> added) {
    bool fresh = false;
    for (const AtomNumber first : added) {
        for (const AtomNumber second : atoms) {
            const std::uint64_t low = std::min(first, second);
            const std::uint64_t high = std::max(first, second);
            std::uint64_t hash = (low << 32 | high) + std::uint64_t{partition} * 0xd6e8feb86659fd93u;
            hash = (hash ^ hash >> 32) * 0x9e3779b97f4a7c15u;
            hash = (hash ^ hash >> 29) * 0xbf58476d1ce4e5b9u;
            fresh |= set(pairs_, static_cast<std::size_t>(hash >> 20) % pair_bits_);
        }
    }
    return fresh;
}

int NoveltyTable::measure(std::uint32_t partition, std::span<const AtomNumber> atoms,
                          std::span<const AtomNumber> added, bool moved) {
    const bool atom = mark_atoms(partition, moved ? atoms : added);
    const bool pair = pair_bits_ != 0 && mark_pairs(partition, atoms, added);
    return atom ? 1 : pair ? 2 : 3;
}

std::size_t NoveltyTable::memory() const {
    std::size_t bytes = pairs_.capacity() * sizeof(std::uint64_t);
    for (const auto& seen : atoms_) bytes += seen.capacity() * sizeof(std::uint64_t);
    return bytes;
}

}  // namespace praxis::lifted
