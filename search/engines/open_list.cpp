#include "search/engines/open_list.hpp"

#include <algorithm>
#include <map>

#include "search/engines/bucket_queue.hpp"
#include "search/engines/random.hpp"

namespace praxis {

namespace {

/// Whether the state is for a list of preferred entries or of all.
bool wanted(const Evaluated& state, bool preferred_only) {
    return state.audience != (preferred_only ? Audience::lists_of_all : Audience::lists_of_preferred);
}

/// Sorted by one key.
template <class Entry>
class SingleList : public OpenList<Entry> {
  public:
    explicit SingleList(const OpenListPlan& plan)
        : key_(plan.keys[0]), preferred_only_(plan.preferred_only) {}

    bool push(const Evaluated& state, Entry entry) override {
        if (!wanted(state, preferred_only_)) return false;
        const std::int64_t key = key_.value(state);
        if (key == kInfiniteKey) return false;
        buckets_.fill(key, [&](Fifo<Entry>& fifo) { fifo.push(pool_, entry); });
        return true;
    }
    Entry pop() override {
        return buckets_.take([&](Fifo<Entry>& fifo) { return fifo.pop(pool_); });
    }
    bool empty() const override { return buckets_.empty(); }
    bool dead_end(const Evaluated& state) const override { return key_.value(state) == kInfiniteKey; }

  private:
    Key key_;
    bool preferred_only_;
    ChunkPool<Entry> pool_;
    KeyedBuckets<Fifo<Entry>> buckets_;
};

template <class Keys>
bool all_infinite(const Keys& keys, const Evaluated& state) {
    return std::all_of(keys.begin(), keys.end(),
                       [&](const Key& key) { return key.value(state) == kInfiniteKey; });
}

/// Sorted by two keys.
template <class Entry>
class PairList : public OpenList<Entry> {
  public:
    explicit PairList(const OpenListPlan& plan)
        : keys_{plan.keys[0], plan.keys[1]},
          preferred_only_(plan.preferred_only),
          unsafe_pruning_(plan.unsafe_pruning) {}

    bool push(const Evaluated& state, Entry entry) override {
        if (!wanted(state, preferred_only_) || dead_end(state)) return false;
        const std::int64_t second = keys_[1].value(state);
        buckets_.fill(keys_[0].value(state), [&](Inner& inner) {
            inner.fill(second, [&](Fifo<Entry>& fifo) { fifo.push(pool_, entry); });
        });
        return true;
    }
    Entry pop() override {
        return buckets_.take(
            [&](Inner& inner) { return inner.take([&](Fifo<Entry>& fifo) { return fifo.pop(pool_); }); });
    }
    bool empty() const override { return buckets_.empty(); }
    bool dead_end(const Evaluated& state) const override {
        return (unsafe_pruning_ && keys_[0].value(state) == kInfiniteKey) || all_infinite(keys_, state);
    }

  private:
    using Inner = KeyedBuckets<Fifo<Entry>>;
    std::array<Key, 2> keys_;
    bool preferred_only_;
    bool unsafe_pruning_;
    ChunkPool<Entry> pool_;
    KeyedBuckets<Inner> buckets_;
};

/// Sorted by any number of keys.
template <class Entry>
class LexicographicList : public OpenList<Entry> {
  public:
    explicit LexicographicList(const OpenListPlan& plan)
        : keys_(plan.keys), preferred_only_(plan.preferred_only), unsafe_pruning_(plan.unsafe_pruning) {}

    bool push(const Evaluated& state, Entry entry) override {
        if (!wanted(state, preferred_only_) || dead_end(state)) return false;
        std::vector<std::int64_t> values;
        for (const Key& key : keys_) values.push_back(key.value(state));
        buckets_[std::move(values)].push(pool_, entry);
        return true;
    }
    Entry pop() override {
        const auto first = buckets_.begin();
        const Entry entry = first->second.pop(pool_);
        if (first->second.empty()) buckets_.erase(first);
        return entry;
    }
    bool empty() const override { return buckets_.empty(); }
    bool dead_end(const Evaluated& state) const override {
        return (unsafe_pruning_ && keys_[0].value(state) == kInfiniteKey) || all_infinite(keys_, state);
    }

  private:
    std::vector<Key> keys_;
    bool preferred_only_;
    bool unsafe_pruning_;
    ChunkPool<Entry> pool_;
    std::map<std::vector<std::int64_t>, Fifo<Entry>> buckets_;
};

/// Takes turns; each list has a priority that grows by one at its turn and falls by the boost on progress
/// (Röger and Helmert 2010; Richter and Westphal 2010).
template <class Entry>
class AlternationList : public OpenList<Entry> {
  public:
    explicit AlternationList(const OpenListPlan& plan) : boost_(plan.boost) {
        for (const OpenListPlan& part : plan.lists) {
            lists_.push_back({make_open_list<Entry>(part), part.preferred_only, 0});
        }
    }

    bool push(const Evaluated& state, Entry entry) override {
        bool taken = false;
        for (Turn& turn : lists_) taken = turn.list->push(state, entry) || taken;
        return taken;
    }
    Entry pop() override {
        Turn* best = nullptr;
        for (Turn& turn : lists_) {
            if (!turn.list->empty() && (best == nullptr || turn.priority < best->priority)) best = &turn;
        }
        ++best->priority;
        return best->list->pop();
    }
    bool empty() const override {
        return std::all_of(lists_.begin(), lists_.end(), [](const Turn& turn) { return turn.list->empty(); });
    }
    void boost() override {
        for (Turn& turn : lists_) {
            if (turn.preferred_only) turn.priority -= boost_;
            turn.list->boost();
        }
    }
    bool dead_end(const Evaluated& state) const override {
        return std::all_of(lists_.begin(), lists_.end(),
                           [&](const Turn& turn) { return turn.list->dead_end(state); });
    }

  private:
    struct Turn {
        std::unique_ptr<OpenList<Entry>> list;
        bool preferred_only;
        std::int64_t priority;
    };
    std::vector<Turn> lists_;
    std::int64_t boost_;
};

/// A random entry of a random type, where states of one type agree in all keys (Xie et al., AAAI 2014).
template <class Entry>
class TypeBasedList : public OpenList<Entry> {
  public:
    explicit TypeBasedList(const OpenListPlan& plan)
        : keys_(plan.keys), preferred_only_(plan.preferred_only), random_(plan.seed) {}

    bool push(const Evaluated& state, Entry entry) override {
        if (!wanted(state, preferred_only_)) return false;
        std::vector<std::int64_t> type;
        for (const Key& key : keys_) type.push_back(key.value(state));
        const auto [place, added] = number_.try_emplace(std::move(type), buckets_.size());
        if (added) buckets_.push_back({place, {}});
        buckets_[place->second].entries.push_back(entry);
        return true;
    }
    Entry pop() override {
        const std::size_t i = random_.below(buckets_.size());
        std::vector<Entry>& entries = buckets_[i].entries;
        const std::size_t chosen = random_.below(entries.size());
        if constexpr (requires(Entry entry) { entry.split(); }) {
            if (entries[chosen].several()) return entries[chosen].split();
        }
        std::swap(entries[chosen], entries.back());
        const Entry entry = entries.back();
        entries.pop_back();
        if (entries.empty()) {
            number_.erase(buckets_[i].type);
            if (i + 1 < buckets_.size()) {
                buckets_[i] = std::move(buckets_.back());
                buckets_[i].type->second = i;
            }
            buckets_.pop_back();
        }
        return entry;
    }
    bool empty() const override { return buckets_.empty(); }
    bool dead_end(const Evaluated& state) const override {
        return !keys_.empty() && all_infinite(keys_, state);
    }

  private:
    using Numbers = std::map<std::vector<std::int64_t>, std::size_t>;
    struct Bucket {
        typename Numbers::iterator type;
        std::vector<Entry> entries;
    };
    std::vector<Key> keys_;
    bool preferred_only_;
    Random random_;
    Numbers number_;
    std::vector<Bucket> buckets_;
};

void collect(const OpenListPlan& plan, std::vector<std::size_t>& numbers) {
    for (const Key& key : plan.keys) key.collect_heuristics(numbers);
    for (const OpenListPlan& part : plan.lists) collect(part, numbers);
}

}  // namespace

template <class Entry>
std::unique_ptr<OpenList<Entry>> make_open_list(const OpenListPlan& plan) {
    switch (plan.kind) {
        case OpenListPlan::Kind::alternation:
            return std::make_unique<AlternationList<Entry>>(plan);
        case OpenListPlan::Kind::type_based:
            return std::make_unique<TypeBasedList<Entry>>(plan);
        default:
            break;
    }
    if (plan.keys.size() == 1) return std::make_unique<SingleList<Entry>>(plan);
    if (plan.keys.size() == 2) return std::make_unique<PairList<Entry>>(plan);
    return std::make_unique<LexicographicList<Entry>>(plan);
}

template std::unique_ptr<OpenList<StateId>> make_open_list(const OpenListPlan& plan);
template std::unique_ptr<OpenList<DeferredEntry>> make_open_list(const OpenListPlan& plan);

bool uses_g(const OpenListPlan& plan) {
    return std::any_of(plan.keys.begin(), plan.keys.end(), [](const Key& key) { return key.uses_g(); }) ||
           std::any_of(plan.lists.begin(), plan.lists.end(),
                       [](const OpenListPlan& part) { return uses_g(part); });
}

std::vector<std::size_t> heuristics_of(const OpenListPlan& plan) {
    std::vector<std::size_t> numbers;
    collect(plan, numbers);
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

}  // namespace praxis
