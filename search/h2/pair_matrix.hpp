// Sets of facts and of pairs of facts as bits.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace praxis {

/// A set of facts, by fact number: bit f % 64 of word f / 64.
using FactBits = std::vector<std::uint64_t>;

inline bool contains(std::span<const std::uint64_t> bits, std::uint32_t fact) {
    return ((bits[fact / 64] >> (fact % 64)) & 1) != 0;
}
inline void insert(std::span<std::uint64_t> bits, std::uint32_t fact) {
    bits[fact / 64] |= std::uint64_t{1} << (fact % 64);
}
inline void intersect(std::span<std::uint64_t> bits, std::span<const std::uint64_t> others) {
    for (std::size_t i = 0; i < bits.size(); ++i) bits[i] &= others[i];
}
template <class Facts>
bool contains_all(std::span<const std::uint64_t> bits, const Facts& facts) {
    for (const std::uint32_t fact : facts) {
        if (!contains(bits, fact)) return false;
    }
    return true;
}

/// Calls `visit(word, mask)` for the words of the facts from `first` to before `last`, until it returns true.
template <class Visit>
bool visit_range(std::uint32_t first, std::uint32_t last, Visit&& visit) {
    while (first < last) {
        const std::uint32_t word = first / 64;
        std::uint64_t mask = ~std::uint64_t{0} << (first % 64);
        if (last / 64 == word) mask &= ~(~std::uint64_t{0} << (last % 64));
        if (visit(word, mask)) return true;
        first = (word + 1) * 64;
    }
    return false;
}
inline void erase_range(std::span<std::uint64_t> bits, std::uint32_t first, std::uint32_t last) {
    visit_range(first, last, [&](std::uint32_t word, std::uint64_t mask) {
        bits[word] &= ~mask;
        return false;
    });
}
/// How many of the facts from `first` to before `last` are in the set.
inline int count_range(std::span<const std::uint64_t> bits, std::uint32_t first, std::uint32_t last) {
    int count = 0;
    visit_range(first, last, [&](std::uint32_t word, std::uint64_t mask) {
        count += std::popcount(bits[word] & mask);
        return false;
    });
    return count;
}

/// A symmetric relation on facts; a fact related to itself is itself in the set. Rows are sets of facts.
class PairMatrix {
  public:
    explicit PairMatrix(std::size_t facts)
        : facts_(facts), words_((facts + 63) / 64), bits_(facts * words_, 0) {}

    std::size_t facts() const { return facts_; }
    std::size_t words() const { return words_; }
    std::span<std::uint64_t> row(std::uint32_t fact) { return {bits_.data() + fact * words_, words_}; }
    std::span<const std::uint64_t> row(std::uint32_t fact) const {
        return {bits_.data() + fact * words_, words_};
    }
    bool test(std::uint32_t a, std::uint32_t b) const { return contains(row(a), b); }
    void set(std::uint32_t a, std::uint32_t b) {
        insert(row(a), b);
        insert(row(b), a);
    }
    /// Every two of the facts are related, and each is in the set.
    template <class Facts>
    bool test_all(const Facts& facts) const {
        for (std::size_t i = 0; i < facts.size(); ++i) {
            for (std::size_t j = 0; j <= i; ++j) {
                if (!test(facts[i], facts[j])) return false;
            }
        }
        return true;
    }
    std::size_t count() const {
        std::size_t sum = 0;
        for (const std::uint64_t word : bits_) sum += static_cast<std::size_t>(std::popcount(word));
        return sum;
    }

  private:
    std::size_t facts_, words_;
    std::vector<std::uint64_t> bits_;
};

}  // namespace praxis
