#include <algorithm>

#include "search/evaluators/relaxed_rules.hpp"

namespace praxis::relaxed {

namespace {

/// A rule among the achievers of one fact. Bit i of the signature is set if some precondition hashes to i.
struct Candidate {
    std::uint64_t signature;
    std::uint32_t size;
    std::int32_t cost;
    std::uint32_t rule;
    std::uint32_t effect;
};

std::uint64_t signature(std::span<const std::uint32_t> facts) {
    std::uint64_t bits = 0;
    for (const std::uint32_t fact : facts) bits |= std::uint64_t{1} << ((fact * 0x9E3779B1u) >> 26);
    return bits;
}

}  // namespace

void unmark_dominated(const Rules& rules, const Achievers& achievers, std::span<const std::int32_t> costs,
                      std::vector<char>& marks) {
    constexpr std::size_t kLongestList = 5000;
    std::size_t budget = 100'000'000;
    std::vector<std::uint64_t> signatures(rules.size());
    for (std::size_t i = 0; i < rules.size(); ++i) signatures[i] = signature(rules.preconditions[i]);
    std::vector<Candidate> list;
    for (std::uint32_t fact = 0; fact < rules.fact_count; ++fact) {
        list.clear();
        for (const Achievers::Entry entry : achievers.of(fact)) {
            if (!marks[entry.effect]) continue;
            const auto size = static_cast<std::uint32_t>(rules.preconditions[entry.rule].size());
            list.push_back(
                {signatures[entry.rule], size, costs[rules.operators[entry.rule]], entry.rule, entry.effect});
        }
        const std::size_t work = list.size() * list.size() / 2;
        if (list.size() > kLongestList || work > budget) continue;
        budget -= work;
        std::ranges::sort(list, {}, [](const Candidate& c) { return std::tuple(c.size, c.cost, c.rule); });
        std::size_t kept = 0;
        for (const Candidate& candidate : list) {
            const auto preconditions = rules.preconditions[candidate.rule];
            const bool dominated = std::any_of(
                list.begin(), list.begin() + static_cast<std::ptrdiff_t>(kept), [&](const Candidate& other) {
                    return (other.signature & ~candidate.signature) == 0 && other.cost <= candidate.cost &&
                           std::ranges::includes(preconditions, rules.preconditions[other.rule]);
                });
            if (dominated) {
                marks[candidate.effect] = false;
            } else {
                list[kept++] = candidate;
            }
        }
    }
}

}  // namespace praxis::relaxed
