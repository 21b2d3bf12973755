#include "search/lifted/state_store.hpp"

#include <algorithm>
#include <cstring>

namespace praxis::lifted {

void StateStore::encode(std::span<const AtomNumber> atoms) {
    // At most five bytes an atom.
    candidate_.resize(2 + (atoms.size() * 5 + 3) / 4);
    auto* const begin = reinterpret_cast<std::uint8_t*>(candidate_.data() + 1);
    std::uint8_t* byte = begin;
    AtomNumber next = 0;
    for (const AtomNumber atom : atoms) {
        // The gap plus one: the zeros that fill the last word stand for no atom.
        std::uint32_t gap = atom - next + 1;
        for (; gap >= 0x80; gap >>= 7) *byte++ = static_cast<std::uint8_t>(gap | 0x80);
        *byte++ = static_cast<std::uint8_t>(gap);
        next = atom + 1;
    }
    while ((byte - begin) % 4 != 0) *byte++ = 0;
    candidate_[0] = static_cast<std::uint32_t>((byte - begin) / 4);
}

std::pair<StateNumber, bool> StateStore::insert(std::span<const AtomNumber> atoms, StateNumber parent) {
    encode(atoms);
    const std::size_t words = candidate_[0] + std::size_t{1};
    if (segments_.empty() || used_ + words > segments_.back().size) {
        const std::size_t size = std::max(kSegmentWords, words);
        segments_.push_back({std::make_unique_for_overwrite<std::uint32_t[]>(size), size});
        used_ = 0;
    }
    std::uint32_t* node = nodes_.next();
    node[0] = static_cast<std::uint32_t>(segments_.size() - 1);
    node[1] = static_cast<std::uint32_t>(used_);
    node[2] = parent;
    std::fill(node + 3, node + kNodeWords, 0);
    std::memcpy(segments_.back().words.get() + used_, candidate_.data(), words * 4);
    const auto result = set_.insert(
        hash(candidate_.data()), nodes_.size(),
        [&](std::uint32_t other) {
            return record(other)[0] == candidate_[0] &&
                   std::memcmp(record(other), candidate_.data(), words * 4) == 0;
        },
        [&](std::uint32_t other) { return hash(record(other)); },
        [&](std::uint32_t other) { __builtin_prefetch(nodes_[other]); });
    if (result.second) {
        nodes_.commit();
        used_ += words;
    }
    return result;
}

void StateStore::read(StateNumber state, std::vector<AtomNumber>& atoms) const {
    atoms.clear();
    const std::uint32_t* words = record(state);
    const auto* byte = reinterpret_cast<const std::uint8_t*>(words + 1);
    const std::uint8_t* const end = byte + std::size_t{words[0]} * 4;
    AtomNumber next = 0;
    while (byte != end && *byte != 0) {
        std::uint32_t gap = 0;
        for (std::uint32_t shift = 0;; shift += 7) {
            gap |= static_cast<std::uint32_t>(*byte & 0x7f) << shift;
            if ((*byte++ & 0x80) == 0) break;
        }
        atoms.push_back(next + gap - 1);
        next = atoms.back() + 1;
    }
}

std::size_t StateStore::memory() const {
    std::size_t bytes = nodes_.memory() + set_.memory();
    for (const Segment& segment : segments_) bytes += segment.size * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace praxis::lifted
