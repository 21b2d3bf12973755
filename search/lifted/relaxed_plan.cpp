#include "search/lifted/relaxed_plan.hpp"

#include <algorithm>

namespace praxis::lifted {

std::size_t RelaxedPlan::explore(std::size_t most_actions) {
    achievers_.clear();
    support_.clear();
    bit_of_.clear();
    achiever_of_.assign(database_.atoms().size(), 0);
    std::size_t looked_at = 0;
    solver_.relax(true);
    for (std::size_t seen = 0; !goal_.positive_literals_hold();) {
        actions_.for_each_applicable([&](std::uint32_t schema, const ObjectNumber*) {
            if (++looked_at >= most_actions) solver_.abandon();
            actions_.for_each_add(schema, [&](AtomNumber atom, std::span<const AtomNumber> support) {
                if (atom >= achiever_of_.size()) achiever_of_.resize(std::size_t{atom} * 2 + 64, 0);
                if (achiever_of_[atom] != 0) return;
                const auto begin = static_cast<std::uint32_t>(support_.size());
                support_.insert(support_.end(), support.begin(), support.end());
                achievers_.push_back({atom, begin, static_cast<std::uint32_t>(support_.size())});
                achiever_of_[atom] = static_cast<std::uint32_t>(achievers_.size());
            });
        });
        if (looked_at >= most_actions || solver_.stopped() || seen == achievers_.size()) break;
        for (; seen < achievers_.size(); ++seen) database_.derive(achievers_[seen].atom, false);
        axioms_.derive();
    }
    solver_.relax(false);
    if (goal_.positive_literals_hold()) extract();
    return looked_at;
}

void RelaxedPlan::extract() {
    bit_of_.assign(achiever_of_.size(), kMost);
    std::vector<AtomNumber> open;
    std::uint8_t next = 0;
    const auto want = [&](AtomNumber atom) {
        if (next == kMost || atom >= achiever_of_.size() || achiever_of_[atom] == 0 || bit_of_[atom] < kMost)
            return;
        bit_of_[atom] = next++;
        open.push_back(atom);
    };
    for (const AtomNumber atom : goal_.positive_literals()) want(atom);
    for (std::size_t i = 0; i < open.size(); ++i) {
        const Achiever& achiever = achievers_[achiever_of_[open[i]] - 1];
        for (std::uint32_t s = achiever.begin; s < achiever.end; ++s) want(support_[s]);
    }
}

}  // namespace praxis::lifted
