#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "search/landmarks/exclusion_reachability.hpp"
#include "search/landmarks/landmark_draft.hpp"

namespace praxis {

namespace {

constexpr std::size_t kLargestDisjunction = 4;
constexpr std::size_t kMostOrderings = 2'000'000;
constexpr std::size_t kMostLaterBits = std::size_t{1} << 29;

class Backchainer {
  public:
    Backchainer(const FiniteDomainTask& task, std::span<const Fact> goal,
                std::span<const std::int32_t> initial_values, const LandmarkOptions& options)
        : task_(task),
          initial_(initial_values),
          options_(options),
          reachability_(task, goal, initial_values),
          fact_count_(static_cast<std::uint32_t>(task.fact_count())),
          landmark_of_(fact_count_, kNone),
          disjunctive_of_(fact_count_, kNone),
          counts_(reachability_.rules().fact_count, 0),
          classes_(fact_count_, kUnknownClass) {}

    LandmarkDraft run(std::span<const Fact> goal) {
        for (const Fact fact : goal) draft_.nodes[single(fact)].goal = true;
        for (std::uint32_t node = 0; node < draft_.nodes.size(); ++node) {
            if (draft_.alive(node)) expand(node);
        }
        add_later_orderings();
        draft_.tidy();
        return std::move(draft_);
    }

  private:
    static constexpr std::uint32_t kNone = LandmarkDraft::kNone;
    static constexpr std::uint32_t kUnknownClass = kNone - 1;

    bool initially(Fact fact) const {
        return initial_[static_cast<std::size_t>(fact.variable)] == fact.value;
    }
    bool is_default(Fact fact) const {
        return task_.derived(fact.variable) &&
               task_.initial_values[static_cast<std::size_t>(fact.variable)] == fact.value;
    }
    Fact fact_of(std::uint32_t number) const {
        const auto next = std::ranges::upper_bound(task_.first_fact, number);
        const auto variable = static_cast<std::int32_t>(next - task_.first_fact.begin()) - 1;
        return {variable,
                static_cast<std::int32_t>(number - task_.first_fact[static_cast<std::size_t>(variable)])};
    }

    /// The landmark of one fact; a disjunctive one that the fact is in is replaced.
    std::uint32_t single(Fact fact) {
        const std::uint32_t number = task_.fact_number(fact);
        if (landmark_of_[number] != kNone) return landmark_of_[number];
        const auto node = static_cast<std::uint32_t>(draft_.nodes.size());
        draft_.nodes.push_back({{fact}, false, kNone, {}});
        later_.emplace_back();
        landmark_of_[number] = node;
        const std::uint32_t larger = disjunctive_of_[number];
        if (larger != kNone) {
            draft_.nodes[larger].replaced_by = node;
            for (const Fact other : draft_.nodes[larger].facts) {
                disjunctive_of_[task_.fact_number(other)] = kNone;
            }
        }
        return node;
    }

    void order(std::uint32_t before, std::uint32_t after, LandmarkOrdering ordering) {
        if (before != after) draft_.orderings.push_back({before, after, ordering});
    }

    bool spent() {
        if (reachability_.work() + work_ > options_.work || options_.budget.exhausted() != Stop::none) {
            draft_.complete = false;
        }
        return !draft_.complete;
    }

    void expand(std::uint32_t node) {
        const std::vector<Fact> facts = draft_.nodes[node].facts;
        if (std::ranges::any_of(facts, [&](Fact fact) { return initially(fact) || is_default(fact); }) ||
            spent()) {
            add_all_achievers(node);
            return;
        }
        std::vector<std::uint32_t> numbers;
        for (const Fact fact : facts) numbers.push_back(task_.fact_number(fact));
        reachability_.explore(numbers);
        find_first_achievers(node, numbers);
        remember_later_facts(node, numbers);
        if (achievers_.empty()) return;  // there is no plan at all
        find_shared_preconditions(node, facts);
        if (facts.size() == 1 && !task_.derived(facts[0].variable)) find_passed_values(node, facts[0]);
        if (options_.disjunctive) find_disjunctions(node);
    }

    void add_all_achievers(std::uint32_t node) {
        std::vector<std::uint32_t>& achievers = draft_.nodes[node].first_achievers;
        for (const Fact fact : draft_.nodes[node].facts) {
            for (const auto entry : reachability_.achievers().of(task_.fact_number(fact))) {
                achievers.push_back(reachability_.rules().operators[entry.rule]);
            }
        }
        finish_achievers(achievers);
    }

    void finish_achievers(std::vector<std::uint32_t>& achievers) const {
        std::ranges::sort(achievers);
        achievers.erase(std::unique(achievers.begin(), achievers.end()), achievers.end());
        std::erase_if(achievers, [&](std::uint32_t op) { return op >= task_.operator_count(); });
    }

    /// The rules that may be first to reach one of the facts.
    void find_first_achievers(std::uint32_t node, const std::vector<std::uint32_t>& numbers) {
        achievers_.clear();
        for (const std::uint32_t number : numbers) {
            for (const auto entry : reachability_.achievers().of(number)) {
                if (reachability_.applicable(entry.rule)) achievers_.push_back(entry.rule);
            }
        }
        std::ranges::sort(achievers_);
        achievers_.erase(std::unique(achievers_.begin(), achievers_.end()), achievers_.end());
        std::vector<std::uint32_t>& operators = draft_.nodes[node].first_achievers;
        for (const std::uint32_t rule : achievers_) {
            operators.push_back(reachability_.rules().operators[rule]);
            work_ += 2 * reachability_.rules().preconditions[rule].size() + 8;
        }
        finish_achievers(operators);
    }

    /// Facts that no state has before the landmark holds, nor the state in which it first holds.
    void remember_later_facts(std::uint32_t node, const std::vector<std::uint32_t>& numbers) {
        if (later_bits_ + fact_count_ > kMostLaterBits) return;
        later_bits_ += fact_count_;
        std::vector<bool>& later = later_[node];
        later.resize(fact_count_);
        for (std::uint32_t fact = 0; fact < fact_count_; ++fact) later[fact] = !reachability_.reached(fact);
        for (const std::uint32_t number : numbers) {
            later[number] = false;
            for (const auto entry : reachability_.achievers().of(number)) {
                const std::uint32_t op = reachability_.rules().operators[entry.rule];
                if (op >= task_.operator_count()) continue;
                for (const GroundEffect& effect : task_.effects[op]) {
                    later[task_.fact_number(effect.fact)] = false;
                }
                work_ += task_.effects[op].size();
            }
        }
        work_ += fact_count_ / 2;
    }

    void add_later_orderings() {
        for (std::uint32_t before = 0; before < draft_.nodes.size(); ++before) {
            if (later_[before].empty() || !draft_.alive(before)) continue;
            if (draft_.orderings.size() > kMostOrderings) return;
            for (std::uint32_t after = 0; after < draft_.nodes.size(); ++after) {
                if (!draft_.alive(after)) continue;
                const bool later = std::ranges::all_of(draft_.nodes[after].facts, [&](Fact fact) {
                    return later_[before][task_.fact_number(fact)] && !is_default(fact);
                });
                if (later) order(before, after, LandmarkOrdering::natural);
            }
        }
    }

    void find_shared_preconditions(std::uint32_t node, const std::vector<Fact>& facts) {
        // If the variable can only have one other value so far, that is a precondition too.
        std::uint32_t only_value_before = kNone;
        if (facts.size() == 1 && !task_.derived(facts[0].variable)) {
            const std::uint32_t first = task_.fact_number({facts[0].variable, 0});
            std::uint32_t values = 0;
            for (std::uint32_t number = first; number < first + domain_size(facts[0].variable); ++number) {
                if (!reachability_.reached(number)) continue;
                only_value_before = number;
                ++values;
            }
            if (values != 1) only_value_before = kNone;
        }
        touched_.clear();
        for (const std::uint32_t rule : achievers_) {
            for (const std::uint32_t fact : reachability_.rules().preconditions[rule]) {
                if (counts_[fact]++ == 0) touched_.push_back(fact);
            }
        }
        for (const std::uint32_t fact : touched_) {
            if (counts_[fact] == achievers_.size() && fact < fact_count_) {
                order(single(fact_of(fact)), node, LandmarkOrdering::greedy_necessary);
            }
            counts_[fact] = 0;
        }
        if (only_value_before != kNone) {
            order(single(fact_of(only_value_before)), node, LandmarkOrdering::greedy_necessary);
        }
    }

    std::uint32_t domain_size(std::int32_t variable) const {
        return static_cast<std::uint32_t>(task_.domain_sizes[static_cast<std::size_t>(variable)]);
    }

    /// Values that the variable must pass through on every way from its initial value to the landmark's, by
    /// rules that can be applied before: the cut vertices of its domain transition graph between the two.
    void find_passed_values(std::uint32_t node, Fact landmark) {
        const std::uint32_t size = domain_size(landmark.variable);
        const std::uint32_t first = task_.fact_number({landmark.variable, 0});
        const auto from = static_cast<std::uint32_t>(initial_[static_cast<std::size_t>(landmark.variable)]);
        const auto to = static_cast<std::uint32_t>(landmark.value);
        order(single({landmark.variable, static_cast<std::int32_t>(from)}), node, LandmarkOrdering::natural);
        if (size == 2) return;

        std::vector<std::vector<std::uint32_t>> steps(size);  // by value: those that may follow it
        std::vector<std::uint32_t> from_any;
        for (std::uint32_t value = 0; value < size; ++value) {
            if (value != to && !reachability_.reached(first + value)) continue;
            for (const auto entry : reachability_.achievers().of(first + value)) {
                ++work_;
                if (!reachability_.applicable(entry.rule)) continue;
                if (value != to && reachability_.barred(entry.rule)) continue;
                const std::span<const std::uint32_t> body = reachability_.rules().preconditions[entry.rule];
                const auto needed = std::ranges::lower_bound(body, first);
                if (needed != body.end() && *needed < first + size) {
                    steps[*needed - first].push_back(value);
                } else {
                    if (value == to) return;
                    if (from_any.empty() || from_any.back() != value) from_any.push_back(value);
                }
            }
        }
        for (auto& values : steps) {
            std::ranges::sort(values);
            values.erase(std::unique(values.begin(), values.end()), values.end());
        }

        std::vector<std::uint32_t> parent(size);
        std::vector<std::uint32_t> queue;
        const auto path_without = [&](std::uint32_t avoided) {
            std::ranges::fill(parent, kNone);
            parent[from] = from;
            queue.assign(1, from);
            for (std::size_t i = 0; i < queue.size() && parent[to] == kNone; ++i) {
                const auto visit = [&](std::uint32_t value) {
                    if (parent[value] != kNone || value == avoided) return;
                    parent[value] = queue[i];
                    queue.push_back(value);
                };
                work_ += 1 + steps[queue[i]].size();
                // Indexed: `visit` grows the queue.
                for (const std::uint32_t value : steps[queue[i]]) visit(value);
                if (i == 0) {
                    for (const std::uint32_t value : from_any) visit(value);
                }
            }
            return parent[to] != kNone;
        };
        if (!path_without(kNone)) return;
        std::vector<std::uint32_t> candidates;
        for (std::uint32_t value = parent[to]; value != from; value = parent[value]) {
            candidates.push_back(value);
        }
        for (const std::uint32_t value : candidates) {
            if (path_without(value)) continue;
            order(single({landmark.variable, static_cast<std::int32_t>(value)}), node,
                  LandmarkOrdering::natural);
        }
    }

    /// Facts of one predicate belong to one class; kNone: to none. Without names, facts of one variable do.
    std::uint32_t class_of(std::uint32_t fact) {
        std::uint32_t& known = classes_[fact];
        if (known != kUnknownClass) return known;
        if (task_.fact_names.size() != fact_count_ || task_.fact_forms.size() != fact_count_) {
            return known = static_cast<std::uint32_t>(fact_of(fact).variable);
        }
        const std::span<const std::uint32_t> name = task_.fact_names.names[fact];
        if (task_.fact_forms[fact] == FiniteDomainTask::FactForm::none_of_those || name.empty()) {
            return known = kNone;
        }
        return known = name[0];
    }

    /// Sets with a precondition of every achiever, all of one class.
    void find_disjunctions(std::uint32_t node) {
        struct Set {
            std::vector<std::uint32_t> facts;
            std::size_t rules = 0;
            std::uint32_t last_rule = kNone;
            bool usable = true;
        };
        std::unordered_map<std::uint32_t, Set> sets;
        std::vector<std::uint32_t> keys;
        for (std::size_t i = 0; i < achievers_.size(); ++i) {
            for (const std::uint32_t fact : reachability_.rules().preconditions[achievers_[i]]) {
                if (fact >= fact_count_ || landmark_of_[fact] != kNone) continue;
                const std::uint32_t key = class_of(fact);
                if (key == kNone) continue;
                const auto [place, fresh] = sets.try_emplace(key);
                if (fresh) keys.push_back(key);
                Set& set = place->second;
                if (set.last_rule != achievers_[i]) ++set.rules;
                set.last_rule = achievers_[i];
                if (!set.usable || std::ranges::find(set.facts, fact) != set.facts.end()) continue;
                set.facts.push_back(fact);
                if (set.facts.size() > kLargestDisjunction || initially(fact_of(fact)) ||
                    is_default(fact_of(fact))) {
                    set.usable = false;
                }
            }
            if (std::ranges::none_of(keys, [&](std::uint32_t key) { return sets[key].rules == i + 1; }))
                return;
        }
        for (const std::uint32_t key : keys) {
            Set& set = sets[key];
            if (set.usable && set.rules == achievers_.size() && set.facts.size() > 1) {
                std::ranges::sort(set.facts);
                add_disjunction(set.facts, node);
            }
        }
    }

    void add_disjunction(const std::vector<std::uint32_t>& set, std::uint32_t node) {
        const std::uint32_t other = disjunctive_of_[set[0]];
        if (other != kNone &&
            std::ranges::all_of(set, [&](std::uint32_t fact) { return disjunctive_of_[fact] == other; })) {
            order(other, node, LandmarkOrdering::greedy_necessary);
        }
        const bool overlaps =
            std::ranges::any_of(set, [&](std::uint32_t fact) { return disjunctive_of_[fact] != kNone; });
        if (overlaps) return;
        const auto added = static_cast<std::uint32_t>(draft_.nodes.size());
        draft_.nodes.emplace_back();
        later_.emplace_back();
        for (const std::uint32_t fact : set) {
            draft_.nodes.back().facts.push_back(fact_of(fact));
            disjunctive_of_[fact] = added;
        }
        order(added, node, LandmarkOrdering::greedy_necessary);
    }

    const FiniteDomainTask& task_;
    std::span<const std::int32_t> initial_;
    const LandmarkOptions& options_;
    ExclusionReachability reachability_;
    std::uint32_t fact_count_;
    LandmarkDraft draft_;
    std::vector<std::uint32_t> landmark_of_;     ///< by fact: the landmark that is just this fact
    std::vector<std::uint32_t> disjunctive_of_;  ///< by fact: the disjunctive landmark it is in
    std::vector<std::vector<bool>> later_;       ///< by landmark, by fact: ordered after it; empty: not known
    std::size_t later_bits_ = 0;
    std::vector<std::uint32_t> achievers_;  ///< rules that may be first to reach the landmark at hand
    std::vector<std::uint32_t> counts_;     ///< scratch, all 0
    std::vector<std::uint32_t> touched_;
    std::vector<std::uint32_t> classes_;
    std::uint64_t work_ = 0;
};

}  // namespace

LandmarkDraft backchain(const FiniteDomainTask& task, std::span<const Fact> goal,
                        std::span<const std::int32_t> initial_values, const LandmarkOptions& options) {
    return Backchainer(task, goal, initial_values, options).run(goal);
}

}  // namespace praxis
