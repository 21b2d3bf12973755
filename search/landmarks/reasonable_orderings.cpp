#include <algorithm>
#include <numeric>
#include <unordered_map>
#include <vector>

#include "search/landmarks/landmark_draft.hpp"

namespace praxis {

namespace {

constexpr std::size_t kMostPairs = 5'000'000;

/// Landmark B *interferes* with landmark A if B must be given up for A to be reached: they are mutually
/// exclusive, or B is with an effect that all operators that reach A share.
class Interference {
  public:
    explicit Interference(const FiniteDomainTask& task, const LandmarkDraft& draft) : task_(task) {
        std::unordered_map<std::uint32_t, std::uint32_t> landmark_of;
        for (std::uint32_t node = 0; node < draft.nodes.size(); ++node) {
            if (!draft.alive(node) || draft.nodes[node].facts.size() > 1) continue;
            landmark_of.emplace(task.fact_number(draft.nodes[node].facts[0]), node);
        }
        achievers_.resize(draft.nodes.size());
        for (std::uint32_t op = 0; op < task.operator_count(); ++op) {
            for (const GroundEffect& effect : task.effects[op]) {
                const auto found = landmark_of.find(task.fact_number(effect.fact));
                if (found == landmark_of.end()) continue;
                std::vector<std::uint32_t>& achievers = achievers_[found->second];
                if (achievers.empty() || achievers.back() != op) achievers.push_back(op);
            }
        }
        group_begin_.assign(task.fact_count() + 1, 0);
        for (const Fact fact : task.mutex_groups.items()) ++group_begin_[task.fact_number(fact)];
        std::exclusive_scan(group_begin_.begin(), group_begin_.end(), group_begin_.begin(), 0u);
        groups_.resize(task.mutex_groups.total());
        std::vector<std::uint32_t> next(group_begin_.begin(), group_begin_.end() - 1);
        for (std::uint32_t group = 0; group < task.mutex_groups.size(); ++group) {
            for (const Fact fact : task.mutex_groups[group]) groups_[next[task.fact_number(fact)]++] = group;
        }
        holder_.assign(task.mutex_groups.size(), kNobody);
        value_.assign(task.variable_count(), kNobody);
        counts_.assign(task.fact_count(), 0);
    }

    /// Makes the landmark of this one fact the one that others are asked about.
    void reach(std::uint32_t node, Fact landmark) {
        for (const std::uint32_t group : marked_groups_) holder_[group] = kNobody;
        for (const std::int32_t variable : marked_variables_) value_[at(variable)] = kNobody;
        marked_groups_.clear();
        marked_variables_.clear();
        mark(landmark);
        share_effects(achievers_[node], landmark);
    }

    bool interferes(Fact other) const {
        const std::int64_t value = value_[at(other.variable)];
        if (value != kNobody && value != other.value) return true;
        const std::uint32_t number = task_.fact_number(other);
        for (std::uint32_t i = group_begin_[number]; i < group_begin_[number + 1]; ++i) {
            const std::int64_t holder = holder_[groups_[i]];
            if (holder != kNobody && holder != number) return true;
        }
        return false;
    }

  private:
    static constexpr std::int64_t kNobody = -1;
    static std::size_t at(std::int32_t variable) { return static_cast<std::size_t>(variable); }

    void mark(Fact fact) {
        const std::uint32_t number = task_.fact_number(fact);
        value_[at(fact.variable)] = fact.value;
        marked_variables_.push_back(fact.variable);
        for (std::uint32_t i = group_begin_[number]; i < group_begin_[number + 1]; ++i) {
            holder_[groups_[i]] = number;
            marked_groups_.push_back(groups_[i]);
        }
    }

    void share_effects(const std::vector<std::uint32_t>& achievers, Fact landmark) {
        if (achievers.empty()) return;
        candidates_.clear();
        for (std::uint32_t i = 0; i < achievers.size(); ++i) {
            bool any = false;
            for (const GroundEffect& effect : task_.effects[achievers[i]]) {
                if (effect.condition != 0 || effect.fact.variable == landmark.variable) continue;
                std::uint32_t& count = counts_[task_.fact_number(effect.fact)];
                if (count != i) continue;  // not an effect of all before
                if (i == 0) candidates_.push_back(effect.fact);
                count = i + 1;
                any = true;
            }
            if (!any) break;
        }
        for (const Fact fact : candidates_) {
            std::uint32_t& count = counts_[task_.fact_number(fact)];
            if (count == achievers.size()) mark(fact);
            count = 0;
        }
    }

    const FiniteDomainTask& task_;
    std::vector<std::vector<std::uint32_t>> achievers_;  ///< by landmark: operators with an effect on it
    std::vector<std::uint32_t> group_begin_;             ///< by fact: its mutex groups in groups_
    std::vector<std::uint32_t> groups_;
    std::vector<std::int64_t> holder_;  ///< by mutex group: the fact that holds when the landmark is reached
    std::vector<std::int64_t> value_;   ///< by variable, likewise
    std::vector<std::uint32_t> marked_groups_;
    std::vector<std::int32_t> marked_variables_;
    std::vector<std::uint32_t> counts_;
    std::vector<Fact> candidates_;
};

/// Pairs of landmarks that an ordering is worth a look for.
class Candidates {
  public:
    explicit Candidates(const LandmarkDraft& draft)
        : draft_(draft),
          before_(draft.nodes.size()),
          seen_(draft.nodes.size(), 0),
          pairs_(draft.nodes.size()) {
        for (const LandmarkDraft::Ordering& o : draft.orderings) {
            before_[o.after].push_back(o.before);
            if (o.ordering == LandmarkOrdering::greedy_necessary) enablers_.push_back(o);
        }
    }

    /// By landmark A: the landmarks B such that A is better reached first if B interferes with it. These are
    /// the goals; and those needed for some landmark which needs A or a landmark after A, too.
    std::vector<std::vector<std::uint32_t>> pairs() {
        for (std::uint32_t later = 0; later < draft_.nodes.size(); ++later) {
            if (!single(later) || !draft_.nodes[later].goal) continue;
            for (std::uint32_t first = 0; first < draft_.nodes.size(); ++first) add(first, later);
        }
        std::ranges::stable_sort(enablers_, {}, &LandmarkDraft::Ordering::before);
        for (std::size_t i = 0; i < enablers_.size(); ++i) {
            const std::uint32_t later = enablers_[i].before;
            if (!single(later) || draft_.nodes[later].goal) continue;
            if (i == 0 || enablers_[i - 1].before != later) ++stamp_;
            if (count_ > kMostPairs) break;
            collect(enablers_[i].after, later);
        }
        return std::move(pairs_);
    }

  private:
    bool single(std::uint32_t node) const {
        return draft_.alive(node) && draft_.nodes[node].facts.size() == 1;
    }
    void add(std::uint32_t first, std::uint32_t later) {
        if (first == later || !single(first) || count_ > kMostPairs) return;
        pairs_[first].push_back(later);
        ++count_;
    }
    /// All landmarks before `enabled` together with `later`: its other predecessors and theirs.
    void collect(std::uint32_t enabled, std::uint32_t later) {
        std::vector<std::uint32_t> stack;
        const auto visit = [&](std::uint32_t node) {
            ++count_;
            if (seen_[node] == stamp_) return;
            seen_[node] = stamp_;
            add(node, later);
            stack.push_back(node);
        };
        for (const std::uint32_t node : before_[enabled]) {
            if (node != later && draft_.nodes[node].facts.size() == 1) visit(node);
        }
        while (!stack.empty()) {
            const std::uint32_t node = stack.back();
            stack.pop_back();
            for (const std::uint32_t predecessor : before_[node]) visit(predecessor);
        }
    }

    const LandmarkDraft& draft_;
    std::vector<std::vector<std::uint32_t>> before_;  ///< by landmark: those naturally before it
    std::vector<LandmarkDraft::Ordering> enablers_;
    std::vector<std::uint32_t> seen_;
    std::uint32_t stamp_ = 0;
    std::vector<std::vector<std::uint32_t>> pairs_;
    std::size_t count_ = 0;
};

}  // namespace

void add_reasonable_orderings(const FiniteDomainTask& task, LandmarkDraft& draft) {
    Interference interference(task, draft);
    const std::vector<std::vector<std::uint32_t>> pairs = Candidates(draft).pairs();
    for (std::uint32_t first = 0; first < pairs.size(); ++first) {
        if (pairs[first].empty()) continue;
        interference.reach(first, draft.nodes[first].facts[0]);
        for (const std::uint32_t later : pairs[first]) {
            if (!interference.interferes(draft.nodes[later].facts[0])) continue;
            draft.orderings.push_back({first, later, LandmarkOrdering::reasonable});
        }
    }
    draft.tidy();
}

}  // namespace praxis
