// The priority queue of relaxed explorations.
//
// Items with keys below kBuckets lie in linked lists, one a key, with a bitmap of the lists that are not
// empty; the lists share one growing pool, so that nothing is allocated once it has grown to what a task
// needs. Items with larger keys go to a binary heap. Items of equal key below kBuckets come out last in,
// first out. There is no decrease-key: push again and skip what is outdated.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <vector>

namespace praxis {

class CostQueue {
  public:
    struct Entry {
        std::int32_t key;
        std::uint32_t item;
    };

    CostQueue() : bitmap_(kBuckets / 64, 0), heads_(kBuckets), pool_(1024) {}

    void clear() {
        if (last_word_ >= first_word_)
            std::fill(bitmap_.begin() + first_word_, bitmap_.begin() + last_word_ + 1, 0u);
        first_word_ = kBuckets / 64;
        last_word_ = 0;
        used_ = 0;
        heap_.clear();
    }

    /// `key` must not be negative.
    void push(std::int32_t key, std::uint32_t item) {
        if (key >= kBuckets) {
            push_far(key, item);
            return;
        }
        const auto bucket = static_cast<std::uint32_t>(key);
        const std::uint32_t word = bucket / 64;
        const std::uint64_t bit = std::uint64_t{1} << (bucket % 64);
        if (used_ == pool_.size()) pool_.resize(2 * pool_.size());
        pool_[used_] = {item, (bitmap_[word] & bit) ? heads_[bucket] : kEnd};
        heads_[bucket] = used_++;
        bitmap_[word] |= bit;
        first_word_ = std::min(first_word_, word);
        last_word_ = std::max(last_word_, word);
    }

    /// Takes an entry of the smallest key; false if there is none.
    bool pop(Entry& entry) {
        if (!smallest(entry.key)) return false;
        if (entry.key >= kBuckets) {
            entry.item = pop_far();
        } else {
            const auto bucket = static_cast<std::uint32_t>(entry.key);
            const Link link = pool_[heads_[bucket]];
            heads_[bucket] = link.next;
            if (link.next == kEnd) remove(bucket);
            entry.item = link.item;
        }
        return true;
    }

    /// Finds the smallest key; false if there is none.
    bool smallest(std::int32_t& key) {
        for (; first_word_ <= last_word_; ++first_word_) {
            if (const std::uint64_t bits = bitmap_[first_word_]; bits != 0) {
                key = static_cast<std::int32_t>(first_word_ * 64 +
                                                static_cast<std::uint32_t>(std::countr_zero(bits)));
                return true;
            }
        }
        if (heap_.empty()) return false;
        key = static_cast<std::int32_t>(heap_.front() >> 32);
        return true;
    }

    /// Takes all entries of the smallest key, which must be `key`, and calls `visit` with their items;
    /// `visit` must not push.
    template <class Visit>
    void pop_all(std::int32_t key, const Visit& visit) {
        if (key >= kBuckets) {
            for (std::int32_t next = key; next == key && !heap_.empty(); smallest(next)) visit(pop_far());
            return;
        }
        const auto bucket = static_cast<std::uint32_t>(key);
        remove(bucket);
        for (std::uint32_t i = heads_[bucket]; i != kEnd; i = pool_[i].next) visit(pool_[i].item);
    }

  private:
    static constexpr std::int32_t kBuckets = 1 << 15;
    static constexpr std::uint32_t kEnd = ~std::uint32_t{0};

    struct Link {
        std::uint32_t item;
        std::uint32_t next;
    };

    void push_far(std::int32_t key, std::uint32_t item) {
        heap_.push_back((static_cast<std::uint64_t>(key) << 32) | item);
        std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
    }

    std::uint32_t pop_far() {
        std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
        const auto item = static_cast<std::uint32_t>(heap_.back());
        heap_.pop_back();
        return item;
    }

    /// A list has become empty.
    void remove(std::uint32_t bucket) { bitmap_[bucket / 64] &= ~(std::uint64_t{1} << (bucket % 64)); }

    std::vector<std::uint64_t> bitmap_;
    std::vector<std::uint32_t> heads_;
    std::vector<Link> pool_;
    std::uint32_t used_ = 0;
    std::uint32_t first_word_ = kBuckets / 64;
    std::uint32_t last_word_ = 0;
    std::vector<std::uint64_t> heap_;
};

}  // namespace praxis
