#include "search/h2/pair_reachability.hpp"

#include <algorithm>
#include <utility>

namespace praxis {

PairReachability::PairReachability(const FiniteDomainTask& task, const ValueCheck& values,
                                   const PairSteps& steps, const PairMatrix& allowed, PairMatrix reached)
    : task_(task),
      values_(values),
      steps_(steps),
      allowed_(allowed),
      reached_(std::move(reached)),
      facts_(allowed.words(), 0),
      grown_(allowed.facts(), 1),
      looked_(steps.size(), 0) {
    for (std::uint32_t fact = 0; fact < reached_.facts(); ++fact) {
        if (reached_.test(fact, fact)) insert(facts_, fact);
    }
}

bool PairReachability::run(const Budget& budget) {
    constexpr std::size_t kWordsBetweenPolls = 1 << 16;
    std::size_t words = 0;
    for (std::uint64_t start = 0; start != clock_;) {
        start = clock_;
        for (std::uint32_t step = 0; step < steps_.size(); ++step) {
            const bool is_due = due(step);
            words += is_due ? 8 * reached_.words() + 8 : 2;
            if (words > kWordsBetweenPolls) {
                if (budget.exhausted() != Stop::none) return false;
                words = 0;
            }
            if (!is_due) continue;
            looked_[step] = clock_;
            if (look(step)) apply(step);
        }
    }
    return budget.exhausted() == Stop::none;
}

bool PairReachability::due(std::uint32_t step) const {
    std::uint64_t latest = 0;
    for (const std::uint32_t fact : steps_.needs[step]) latest = std::max(latest, grown_[fact]);
    if (steps_.needs[step].empty()) latest = facts_grown_;
    return latest > looked_[step];
}

// Finds the facts before and after a step; false if it is not possible yet.
bool PairReachability::look(std::uint32_t step) {
    const std::span<const std::uint32_t> needs = steps_.needs[step];
    if (!reached_.test_all(needs)) return false;
    if (needs.empty()) {
        before_ = facts_;
    } else {
        const std::span<const std::uint64_t> row = reached_.row(needs[0]);
        before_.assign(row.begin(), row.end());
        for (const std::uint32_t fact : needs.subspan(1)) intersect(before_, reached_.row(fact));
    }
    after_ = before_;
    for (const std::uint32_t variable : steps_.changes[step]) {
        erase_range(after_, task_.first_fact[variable], task_.first_fact[variable + 1]);
    }
    for (const std::uint32_t fact : steps_.adds[step]) insert(after_, fact);
    for (const std::uint32_t fact : steps_.surely[step]) intersect(after_, allowed_.row(fact));
    return contains_all(after_, steps_.surely[step]);
}

void PairReachability::apply(std::uint32_t step) {
    ++clock_;
    bool changed = false;
    const auto relate = [&](std::uint32_t added, std::size_t word, std::uint64_t fresh) {
        changed = true;
        grown_[added] = clock_;
        reached_.row(added)[word] |= fresh;
        for (; fresh != 0; fresh &= fresh - 1) {
            const auto other =
                static_cast<std::uint32_t>(word * 64 + static_cast<std::size_t>(std::countr_zero(fresh)));
            insert(reached_.row(other), added);
            grown_[other] = clock_;
            if (other == added) {
                insert(facts_, other);
                facts_grown_ = clock_;
            }
        }
    };
    for (const std::uint32_t added : steps_.adds[step]) {
        if (!contains(after_, added)) continue;
        const std::span<const std::uint64_t> allowed = allowed_.row(added);
        const std::span<const std::uint64_t> reached = reached_.row(added);
        for (std::size_t word = 0; word < after_.size(); ++word) {
            const std::uint64_t fresh = after_[word] & allowed[word] & ~reached[word];
            if (fresh != 0) relate(added, word, fresh);
        }
    }
    const auto [first, last] = steps_.companions[step];
    for (std::uint32_t other = first; other < last; ++other) {
        const std::uint32_t own = steps_.adds[step][0];
        const std::uint32_t fact = steps_.adds[other][0];
        if (!allowed_.test(own, fact) || reached_.test(own, fact)) continue;
        if (contains_all(before_, steps_.needs[other])) {
            relate(own, fact / 64, std::uint64_t{1} << (fact % 64));
        }
    }
    if (!changed) --clock_;
}

bool PairReachability::possible(std::uint32_t step) {
    return look(step) && values_.every_variable_has_a_value(before_) &&
           (steps_.surely[step].empty() || values_.every_variable_has_a_value(after_));
}

}  // namespace praxis
