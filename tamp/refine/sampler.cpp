#include "tamp/refine/sampler.hpp"

#include <algorithm>
#include <bit>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

namespace praxis::tamp {
namespace {

constexpr std::uint32_t kNone = OptimisticTask::kNone;

/// A set of small numbers.
class Bits {
  public:
    explicit Bits(std::size_t size = 0) : words_((size + 63) / 64, 0) {}
    void set(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
    void reset(std::size_t i) { words_[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
    bool test(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1U) != 0; }
    void clear() { std::ranges::fill(words_, 0); }
    void merge(const Bits& other) {
        for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    }
    /// The largest member, or kNone.
    std::uint32_t last() const {
        for (std::size_t i = words_.size(); i-- > 0;)
            if (words_[i] != 0)
                return static_cast<std::uint32_t>(64 * i + 63 -
                                                  static_cast<std::size_t>(std::countl_zero(words_[i])));
        return kNone;
    }

  private:
    std::vector<std::uint64_t> words_;
};

class NodeAction : public ActionText {
  public:
    NodeAction(const SymbolicTask& task, const Skeleton& skeleton, std::uint32_t step)
        : task_(task), skeleton_(skeleton), step_(step) {}
    std::string text() const override { return step_text(task_, skeleton_, step_); }

  private:
    const SymbolicTask& task_;
    const Skeleton& skeleton_;
    std::uint32_t step_;
};

class Backjumper {
  public:
    Backjumper(const SymbolicTask& task, const Skeleton& skeleton, Samples& samples,
               const SampleLimits& limits, const Budget& budget)
        : task_(task), skeleton_(skeleton), samples_(samples), limits_(limits), budget_(budget) {
        const std::size_t size = skeleton.nodes.size();
        find_order();
        first_fluent_.push_back(size + 1);
        for (const SkeletonNode& node : skeleton.nodes)
            first_fluent_.push_back(first_fluent_.back() + node.fluents.size());
        levels_.resize(size);
        for (Level& level : levels_) {
            level.conflict = Bits(size);
            level.explanation = Bits(first_fluent_.back());
        }
        failures_.assign(size, 0);
        values_.assign(skeleton.slots.size(), kNone);
        for (std::size_t i = 0; i < skeleton.slots.size(); ++i)
            if (skeleton.slots[i].node == kNone)
                values_[i] = task.optimistic().value[skeleton.slots[i].object.index()];
        calls_left_ = limits.calls;
    }

    SampleOutcome run() {
        std::uint32_t depth = 0;
        if (!levels_.empty()) enter(0);
        while (depth < levels_.size()) {
            if (advance(depth)) {
                if (++depth < levels_.size()) enter(depth);
                continue;
            }
            if (stopped_) return cut_off(depth);
            blame(depth);
            const std::uint32_t back = target(depth);
            if (back == kNone) return failure(levels_[depth].explanation, levels_[depth].alternatives);
            levels_[back].conflict.merge(levels_[depth].conflict);
            levels_[back].conflict.reset(back);
            levels_[back].explanation.merge(levels_[depth].explanation);
            levels_[back].alternatives.merge(levels_[depth].alternatives);
            depth = back;
        }
        SampleOutcome outcome;
        outcome.solved = true;
        outcome.values = std::move(values_);
        return outcome;
    }

    /// Failures of nodes that depend on no other and are not among those of `first`.
    std::vector<SampleOutcome> probe(const SampleOutcome& first) {
        std::vector<SampleOutcome> result;
        for (std::uint32_t depth = 0; depth < levels_.size() && !stopped_; ++depth) {
            const StreamInfo& info = samples_.info(node(depth).stream);
            const bool single = node(depth).outputs.empty() || info.max_samples == 1;
            if (!single || !dependencies(order_[depth]).empty()) continue;
            if (std::ranges::find(first.nodes, order_[depth]) != first.nodes.end()) continue;
            enter(depth);
            if (advance(depth) || stopped_) continue;
            blame(depth);
            SampleOutcome outcome = failure(levels_[depth].explanation, levels_[depth].alternatives);
            if (outcome.definite) result.push_back(std::move(outcome));
        }
        return result;
    }

  private:
    struct Level {
        SampleList* list = nullptr;
        std::vector<ValueNumber> inputs;
        std::vector<ValueAtom> fluents;           ///< sorted
        std::vector<std::uint32_t> fluent_order;  ///< by sorted fluent: its place in the node
        std::uint32_t next = 0;
        bool cut = false;
        Bits conflict;     ///< levels to jump back to
        Bits explanation;  ///< nodes, then "a limit has cut something off", then fluents of nodes
        /// Of each of these sets, the explanation needs one fluent; their arguments are known.
        std::set<std::vector<std::uint32_t>> alternatives;
    };

    std::size_t soft_bit() const { return skeleton_.nodes.size(); }
    const SkeletonNode& node(std::uint32_t depth) const { return skeleton_.nodes[order_[depth]]; }

    void find_order() {
        const std::size_t size = skeleton_.nodes.size();
        std::vector<std::uint32_t> waiting(size, 0);
        std::vector<std::vector<std::uint32_t>> next(size);
        for (std::uint32_t n = 0; n < size; ++n) {
            for (const std::uint32_t before : dependencies(n)) {
                ++waiting[n];
                next[before].push_back(n);
            }
        }
        const auto later = [&](std::uint32_t a, std::uint32_t b) { return rank(a) > rank(b); };
        std::vector<std::uint32_t> ready;
        for (std::uint32_t n = 0; n < size; ++n)
            if (waiting[n] == 0) ready.push_back(n);
        std::ranges::make_heap(ready, later);
        depth_of_.assign(size, 0);
        while (!ready.empty()) {
            std::ranges::pop_heap(ready, later);
            const std::uint32_t n = ready.back();
            ready.pop_back();
            depth_of_[n] = static_cast<std::uint32_t>(order_.size());
            order_.push_back(n);
            for (const std::uint32_t after : next[n]) {
                if (--waiting[after] != 0) continue;
                ready.push_back(after);
                std::ranges::push_heap(ready, later);
            }
        }
    }

    /// Cheap tests at once, all else when its step comes: then little is done anew where a sample changes.
    std::tuple<bool, std::uint32_t, double, std::uint32_t> rank(std::uint32_t n) const {
        constexpr double kCheap = 100;
        const SkeletonNode& node = skeleton_.nodes[n];
        const double effort = samples_.info(node.stream).effort;
        return {!node.outputs.empty() || effort > kCheap, node.step, effort, n};
    }

    std::vector<std::uint32_t> dependencies(std::uint32_t n) const {
        const SkeletonNode& node = skeleton_.nodes[n];
        std::vector<std::uint32_t> result = node.after;
        for (const std::uint32_t slot : node.inputs)
            if (skeleton_.slots[slot].node != kNone) result.push_back(skeleton_.slots[slot].node);
        for (const SkeletonFluent& fluent : node.fluents)
            for (const std::uint32_t slot : fluent.slots)
                if (skeleton_.slots[slot].node != kNone) result.push_back(skeleton_.slots[slot].node);
        std::ranges::sort(result);
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
    }

    void enter(std::uint32_t depth) {
        Level& level = levels_[depth];
        const SkeletonNode& current = node(depth);
        level.next = 0;
        level.cut = false;
        level.conflict.clear();
        level.explanation.clear();
        level.alternatives.clear();
        level.inputs.clear();
        for (const std::uint32_t slot : current.inputs) level.inputs.push_back(values_[slot]);
        const std::size_t size = current.fluents.size();
        atoms_.resize(std::max(atoms_.size(), size));
        level.fluent_order.resize(size);
        level.fluents.resize(size);
        for (std::uint32_t i = 0; i < size; ++i) {
            level.fluent_order[i] = i;
            atoms_[i].assign(1, current.fluents[i].atom[0]);
            for (const std::uint32_t slot : current.fluents[i].slots) atoms_[i].push_back(values_[slot]);
        }
        std::ranges::sort(level.fluent_order,
                          [&](std::uint32_t a, std::uint32_t b) { return atoms_[a] < atoms_[b]; });
        for (std::size_t i = 0; i < size; ++i) level.fluents[i] = atoms_[level.fluent_order[i]];
        level.list = &samples_.list(current.stream, level.inputs, level.fluents);
    }

    /// Takes the next sample; false if there is none.
    bool advance(std::uint32_t depth) {
        Level& level = levels_[depth];
        const SkeletonNode& current = node(depth);
        while (level.next >= level.list->count) {
            if (level.list->finished) return false;
            if (level.list->attempts >= limits_.attempts) {
                level.cut = true;
                return false;
            }
            if (calls_left_ == 0 || budget_.exhausted() != Stop::none) {
                stopped_ = true;
                return false;
            }
            --calls_left_;
            samples_.extend(*level.list, current.stream, level.inputs, level.fluents,
                            NodeAction(task_, skeleton_, current.step));
        }
        const std::size_t size = current.outputs.size();
        for (std::size_t i = 0; i < size; ++i)
            values_[current.outputs[i]] = level.list->outputs[level.next * size + i];
        ++level.next;
        return true;
    }

    /// Why this level has no further value.
    void blame(std::uint32_t depth) {
        Level& level = levels_[depth];
        const std::uint32_t n = order_[depth];
        const SkeletonNode& current = skeleton_.nodes[n];
        const SampleList& list = *level.list;
        ++failures_[n];
        level.explanation.set(n);
        // Of a stream with fluents that had samples, nothing is known in other states.
        if (level.cut || !list.definite || (list.count > 0 && !level.fluents.empty()))
            level.explanation.set(soft_bit());
        const bool everything = !limits_.blame || list.count > 0 || list.attempts == 0;
        for (std::size_t i = 0; i < current.inputs.size(); ++i)
            if (everything || list.inputs[i]) conflict(level, current.inputs[i]);
        if (!everything && !list.each.empty()) {
            choose(level, n);
            return;
        }
        for (std::size_t i = 0; i < level.fluents.size(); ++i)
            if (everything || list.fluents[i]) accuse(level, n, level.fluent_order[i]);
    }

    void accuse(Level& level, std::uint32_t n, std::uint32_t fluent) {
        level.explanation.set(first_fluent_[n] + fluent);
        for (const std::uint32_t slot : skeleton_.nodes[n].fluents[fluent].slots) conflict(level, slot);
    }

    /// Each of several fluents explains the failure alone. Those that leave nothing to jump back to are kept, to
    /// choose later the ones that explain other failures, too; if there is none, the one that lets jump furthest.
    void choose(Level& level, std::uint32_t n) {
        const std::vector<SkeletonFluent>& fluents = skeleton_.nodes[n].fluents;
        std::vector<std::uint32_t> alternatives;
        std::uint32_t best = level.fluent_order[level.list->each.front()];
        std::uint32_t best_depth = kNone;
        for (const std::uint32_t i : level.list->each) {
            const std::uint32_t fluent = level.fluent_order[i];
            if (known(fluents[fluent])) {
                alternatives.push_back(static_cast<std::uint32_t>(first_fluent_[n] + fluent));
                continue;
            }
            std::uint32_t depth = 0;
            for (const std::uint32_t slot : fluents[fluent].slots)
                if (skeleton_.slots[slot].node != kNone)
                    depth = std::max(depth, depth_of_[skeleton_.slots[slot].node]);
            if (depth >= best_depth) continue;
            best_depth = depth;
            best = fluent;
        }
        if (alternatives.empty()) {
            accuse(level, n, best);
        } else {
            std::ranges::sort(alternatives);
            level.alternatives.insert(std::move(alternatives));
        }
    }

    bool known(const SkeletonFluent& fluent) const {
        return std::ranges::all_of(fluent.slots,
                                   [&](std::uint32_t slot) { return skeleton_.slots[slot].node == kNone; });
    }

    void conflict(Level& level, std::uint32_t slot) {
        const std::uint32_t maker = skeleton_.slots[slot].node;
        if (maker != kNone) level.conflict.set(depth_of_[maker]);
    }

    std::uint32_t target(std::uint32_t depth) {
        Level& level = levels_[depth];
        if (limits_.backjumping) return level.conflict.last();
        if (depth == 0) return kNone;
        level.explanation.set(order_[depth - 1]);
        return depth - 1;
    }

    SampleOutcome failure(Bits explanation, const std::set<std::vector<std::uint32_t>>& alternatives) const {
        SampleOutcome outcome;
        outcome.definite = !explanation.test(soft_bit());
        const std::vector<std::uint32_t> common = all_common(explanation, alternatives);
        settle(explanation, alternatives);
        for (std::uint32_t n = 0; n < skeleton_.nodes.size(); ++n) {
            if (explanation.test(n)) outcome.nodes.push_back(n);
            for (std::uint32_t i = 0; i < skeleton_.nodes[n].fluents.size(); ++i)
                if (explanation.test(first_fluent_[n] + i)) outcome.fluents.emplace_back(n, i);
        }
        if (outcome.fluents.size() != 1) return outcome;
        for (const std::uint32_t bit : common)
            if (!explanation.test(bit)) outcome.others.push_back(fluent_of(bit));
        return outcome;
    }

    /// Takes few fluents such that there is one of every set.
    static void settle(Bits& explanation, const std::set<std::vector<std::uint32_t>>& alternatives) {
        for (;;) {
            std::map<std::uint32_t, std::size_t> counts;
            for (const std::vector<std::uint32_t>& set : alternatives) {
                if (std::ranges::any_of(set, [&](std::uint32_t bit) { return explanation.test(bit); })) continue;
                for (const std::uint32_t bit : set) ++counts[bit];
            }
            if (counts.empty()) return;
            explanation.set(std::ranges::max_element(counts, {}, [](const auto& count) { return count.second; })->first);
        }
    }

    /// Fluents that are in all sets, if there is no other fluent in the explanation.
    std::vector<std::uint32_t> all_common(const Bits& explanation,
                                          const std::set<std::vector<std::uint32_t>>& alternatives) const {
        if (alternatives.empty()) return {};
        for (std::size_t bit = soft_bit() + 1; bit < first_fluent_.back(); ++bit)
            if (explanation.test(bit)) return {};
        std::vector<std::uint32_t> common = *alternatives.begin();
        for (const std::vector<std::uint32_t>& set : alternatives) {
            std::vector<std::uint32_t> both;
            std::ranges::set_intersection(common, set, std::back_inserter(both));
            common = std::move(both);
        }
        return common;
    }

    std::pair<std::uint32_t, std::uint32_t> fluent_of(std::uint32_t bit) const {
        const auto after = std::ranges::upper_bound(first_fluent_, std::size_t{bit});
        const auto n = static_cast<std::uint32_t>(after - first_fluent_.begin() - 1);
        return {n, static_cast<std::uint32_t>(bit - first_fluent_[n])};
    }

    /// The limit is reached: the node that failed most often is to blame, as far as one can tell.
    SampleOutcome cut_off(std::uint32_t depth) {
        const auto worst =
            static_cast<std::uint32_t>(std::ranges::max_element(failures_) - failures_.begin());
        const std::uint32_t blamed = failures_[worst] > 0 ? depth_of_[worst] : depth;
        Bits explanation(first_fluent_.back());
        explanation.merge(levels_[blamed].explanation);
        explanation.set(order_[blamed]);
        explanation.set(soft_bit());
        return failure(explanation, levels_[blamed].alternatives);
    }

    const SymbolicTask& task_;
    const Skeleton& skeleton_;
    Samples& samples_;
    const SampleLimits& limits_;
    const Budget& budget_;
    std::vector<std::uint32_t> order_;     ///< nodes by depth
    std::vector<std::uint32_t> depth_of_;  ///< by node
    std::vector<std::size_t> first_fluent_;
    std::vector<Level> levels_;
    std::vector<std::uint64_t> failures_;  ///< by node
    std::vector<ValueNumber> values_;      ///< by slot
    std::vector<ValueAtom> atoms_;         ///< scratch
    std::uint32_t calls_left_ = 0;
    bool stopped_ = false;
};

}  // namespace

std::vector<SampleOutcome> sample(const SymbolicTask& task, const Skeleton& skeleton, Samples& samples,
                                  const SampleLimits& limits, const Budget& budget) {
    Backjumper backjumper(task, skeleton, samples, limits, budget);
    std::vector<SampleOutcome> outcomes{backjumper.run()};
    if (outcomes.front().solved || !limits.blame) return outcomes;
    for (SampleOutcome& other : backjumper.probe(outcomes.front())) outcomes.push_back(std::move(other));
    return outcomes;
}

}  // namespace praxis::tamp
