#include <algorithm>
#include <bit>

#include "search/evaluators/relaxed_rules.hpp"

namespace praxis::relaxed {

std::vector<std::uint32_t> next_alike(const Rules& rules, std::span<const std::int32_t> costs) {
    const auto alike = [&](std::uint32_t a, std::uint32_t b) {
        return costs[rules.operators[a]] == costs[rules.operators[b]] &&
               std::ranges::equal(rules.preconditions[a], rules.preconditions[b]);
    };
    std::vector<std::uint32_t> next(rules.size(), kNoRule);
    // The last of each chain so far, in a hash table with linear probing.
    const std::size_t slots = std::bit_ceil(2 * rules.size());
    std::vector<std::uint32_t> last(slots, kNoRule);
    for (std::uint32_t rule = 0; rule < rules.size(); ++rule) {
        if (rules.effects[rule].front() == rules.goal) continue;
        std::uint64_t hash = static_cast<std::uint32_t>(costs[rules.operators[rule]]);
        for (const std::uint32_t fact : rules.preconditions[rule]) {
            hash = (hash + fact + 1) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 32;
        }
        std::size_t slot = hash & (slots - 1);
        while (last[slot] != kNoRule && !alike(last[slot], rule)) slot = (slot + 1) & (slots - 1);
        if (last[slot] != kNoRule) next[last[slot]] = rule;
        last[slot] = rule;
    }
    return next;
}

}  // namespace praxis::relaxed
