#include "tamp/refine/sampler.hpp"

#include <algorithm>
#include <bit>
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
            if (back == kNone) return failure(levels_[depth].explanation);
            levels_[back].conflict.merge(levels_[depth].conflict);
            levels_[back].conflict.reset(back);
            levels_[back].explanation.merge(levels_[depth].explanation);
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
            SampleOutcome outcome = failure(levels_[depth].explanation);
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

    std::tuple<double, bool, std::uint32_t, std::uint32_t> rank(std::uint32_t n) const {
        const SkeletonNode& node = skeleton_.nodes[n];
        return {samples_.info(node.stream).effort, !node.outputs.empty(), node.step, n};
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
        level.inputs.clear();
        for (const std::uint32_t slot : current.inputs) level.inputs.push_back(values_[slot]);
        level.fluents.clear();
        if (!current.fluents.empty()) {
            std::vector<std::pair<ValueAtom, std::uint32_t>> atoms;
            for (std::uint32_t i = 0; i < current.fluents.size(); ++i) {
                ValueAtom atom{current.fluents[i].atom[0]};
                for (const std::uint32_t slot : current.fluents[i].slots) atom.push_back(values_[slot]);
                atoms.emplace_back(std::move(atom), i);
            }
            std::ranges::sort(atoms);
            level.fluent_order.clear();
            for (auto& [atom, place] : atoms) {
                level.fluents.push_back(std::move(atom));
                level.fluent_order.push_back(place);
            }
        }
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
        for (std::size_t i = 0; i < level.fluents.size(); ++i) {
            if (!everything && !list.fluents[i]) continue;
            level.explanation.set(first_fluent_[n] + level.fluent_order[i]);
            for (const std::uint32_t slot : current.fluents[level.fluent_order[i]].slots)
                conflict(level, slot);
        }
    }

    bool known(const SkeletonFluent& fluent) const {
        return std::ranges::all_of(fluent.slots,
                                   [&](std::uint32_t slot) { return skeleton_.slots[slot].node == kNone; });
    }

    /// Of the fluents that each explain the failure alone, one that leaves nothing to jump back to, if there
    /// is one.
    std::size_t simplest(const Level& level, const SkeletonNode& current) const {
        for (const std::uint32_t i : level.list->each)
            if (known(current.fluents[level.fluent_order[i]])) return i;
        return level.list->each.front();
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

    SampleOutcome failure(const Bits& explanation) const {
        SampleOutcome outcome;
        outcome.definite = !explanation.test(soft_bit());
        for (std::uint32_t n = 0; n < skeleton_.nodes.size(); ++n) {
            if (explanation.test(n)) outcome.nodes.push_back(n);
            for (std::uint32_t i = 0; i < skeleton_.nodes[n].fluents.size(); ++i)
                if (explanation.test(first_fluent_[n] + i)) outcome.fluents.emplace_back(n, i);
        }
        if (outcome.fluents.size() == 1) add_others(outcome);
        return outcome;
    }

    void add_others(SampleOutcome& outcome) const {
        const auto [n, chosen] = outcome.fluents.front();
        const Level& level = levels_[depth_of_[n]];
        if (!limits_.blame || level.list == nullptr || level.list->count > 0 ||
            !known(skeleton_.nodes[n].fluents[chosen]))
            return;
        for (const std::uint32_t i : level.list->each) {
            const std::uint32_t other = level.fluent_order[i];
            if (other != chosen && known(skeleton_.nodes[n].fluents[other]))
                outcome.others.emplace_back(n, other);
        }
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
        return failure(explanation);
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
