// Sets of landmarks as bits, 64 to a word.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace praxis {

using LandmarkWord = std::uint64_t;
using LandmarkBits = std::span<const LandmarkWord>;

inline bool has_landmark(LandmarkBits bits, std::size_t landmark) {
    return (bits[landmark / 64] >> (landmark % 64) & 1) != 0;
}
inline void add_landmark(std::span<LandmarkWord> bits, std::size_t landmark) {
    bits[landmark / 64] |= LandmarkWord{1} << (landmark % 64);
}

/// Calls visit(landmark) for each landmark of a word, in increasing order.
template <class Visit>
void for_each_landmark(LandmarkWord word, std::size_t word_index, Visit&& visit) {
    for (; word != 0; word &= word - 1) {
        visit(word_index * 64 + static_cast<std::size_t>(std::countr_zero(word)));
    }
}

}  // namespace praxis
