#include "search/lifted/novelty_table.hpp"

#include <algorithm>

namespace praxis::lifted {

bool NoveltyTable::mark_atoms(std::uint32_t partition, std::span<const AtomNumber> atoms) {
    if (partition >= atoms_.size()) atoms_.resize(partition + std::size_t{1});
    std::vector<std::uint64_t>& seen = atoms_[partition];
    bool fresh = false;
    for (const AtomNumber atom : atoms) {
        if (atom / 64 >= seen.size()) {
            const std::size_t size = atom / 64 + atom / 256 + 1;
            if (atom_words_ + size - seen.size() > kMostAtomWords) continue;
            atom_words_ += size - seen.size();
            seen.resize(size, 0);
        }
        fresh |= set(seen, atom);
    }
    return fresh;
}

bool NoveltyTable::mark_pairs(std::uint32_t partition, std::span<const AtomNumber> atoms,
                              std::span<const AtomNumber> added) {
    bool fresh = false;
    for (const AtomNumber made : added) {
        std::uint64_t row = (std::uint64_t{made} << 32 | partition) * 0x9e3779b97f4a7c15u;
        row = (row ^ row >> 29) * 0xbf58476d1ce4e5b9u;
        row >>= 20;
        for (const AtomNumber beside : atoms) fresh |= set(pairs_, (row + beside) & (pairs_.size() * 64 - 1));
    }
    return fresh;
}

int NoveltyTable::measure(std::uint32_t partition, std::span<const AtomNumber> atoms,
                          std::span<const AtomNumber> added, bool moved) {
    const bool atom = mark_atoms(partition, moved ? atoms : added);
    const bool pair = !pairs_.empty() && mark_pairs(partition, atoms, added);
    return atom ? 1 : pair ? 2 : 3;
}

std::size_t NoveltyTable::memory() const {
    std::size_t bytes = pairs_.capacity() * sizeof(std::uint64_t);
    for (const auto& seen : atoms_) bytes += seen.capacity() * sizeof(std::uint64_t);
    return bytes;
}

}  // namespace praxis::lifted
