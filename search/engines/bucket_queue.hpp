// Priority queues for small integer keys, first in first out among equals.
//
// An entry that stands for several things (`several`) comes out one by one (`split`).
//
// Entries lie in chunks of two cache lines that all queues of one open list share and use again, so that
// memory follows the number of entries and popping is a walk through an array. Keys below 2^14 index a
// vector, larger ones a map.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace praxis {

/// Chunks of entries, linked by number.
template <class Entry>
class ChunkPool {
  public:
    static constexpr std::uint32_t kNone = 0xffffffffu;
    static constexpr std::uint32_t kChunkSize = (128 - 4) / sizeof(Entry);
    struct Chunk {
        std::uint32_t next;
        std::array<Entry, kChunkSize> entries;
    };

    Chunk& operator[](std::uint32_t i) { return slabs_[i >> kSlabShift][i & ((1u << kSlabShift) - 1)]; }
    std::uint32_t allocate() {
        if (free_ == kNone) add_slab();
        const std::uint32_t chunk = free_;
        free_ = (*this)[chunk].next;
        (*this)[chunk].next = kNone;
        return chunk;
    }
    void release(std::uint32_t chunk) {
        (*this)[chunk].next = free_;
        free_ = chunk;
    }

  private:
    static constexpr std::uint32_t kSlabShift = 8;

    void add_slab() {
        const auto first = static_cast<std::uint32_t>(slabs_.size() << kSlabShift);
        slabs_.push_back(std::make_unique_for_overwrite<Chunk[]>(std::size_t{1} << kSlabShift));
        for (std::uint32_t i = 1u << kSlabShift; i-- > 0;) release(first + i);
    }

    std::vector<std::unique_ptr<Chunk[]>> slabs_;
    std::uint32_t free_ = kNone;
};

/// A queue in chunks of a pool.
template <class Entry>
class Fifo {
  public:
    using Pool = ChunkPool<Entry>;

    bool empty() const { return head_ == Pool::kNone; }
    void push(Pool& pool, Entry entry) {
        if (empty()) {
            head_ = tail_ = pool.allocate();
            begin_ = end_ = 0;
        } else if (end_ == Pool::kChunkSize) {
            const std::uint32_t chunk = pool.allocate();
            pool[tail_].next = chunk;
            tail_ = chunk;
            end_ = 0;
        }
        pool[tail_].entries[end_++] = entry;
    }
    Entry pop(Pool& pool) {
        Entry& front = pool[head_].entries[begin_];
        if constexpr (requires { front.split(); }) {
            if (front.several()) return front.split();
        }
        const Entry entry = front;
        ++begin_;
        const bool last = head_ == tail_ && begin_ == end_;
        if (last || begin_ == Pool::kChunkSize) {
            const std::uint32_t next = pool[head_].next;
            pool.release(head_);
            head_ = last ? Pool::kNone : next;
            begin_ = 0;
        }
        return entry;
    }

  private:
    std::uint32_t head_ = Pool::kNone;
    std::uint32_t tail_ = Pool::kNone;
    std::uint16_t begin_ = 0;
    std::uint16_t end_ = 0;
};

/// Things by key, with the smallest key of those that are not empty(). Negative keys are allowed.
template <class Bucket>
class KeyedBuckets {
  public:
    bool empty() const { return occupied_ == 0 && sparse_.empty(); }

    /// Calls fill(bucket) on the bucket of `key`, which must not be empty afterwards.
    template <class Fill>
    void fill(std::int64_t key, const Fill& fill) {
        if (key < 0 || key >= kDenseKeys) {
            fill(sparse_[key]);
            return;
        }
        const auto index = static_cast<std::size_t>(key);
        if (index >= dense_.size()) dense_.resize(index + 1);
        if (dense_[index].empty()) ++occupied_;
        fill(dense_[index]);
        if (index < first_) first_ = index;
    }

    /// Calls take(bucket) on the first bucket and returns what it returns. Must not be empty.
    template <class Take>
    auto take(const Take& take) {
        auto sparse = sparse_.begin();
        if (occupied_ == 0 || (sparse != sparse_.end() && sparse->first < 0)) {
            const auto result = take(sparse->second);
            if (sparse->second.empty()) sparse_.erase(sparse);
            return result;
        }
        while (dense_[first_].empty()) ++first_;
        const auto result = take(dense_[first_]);
        if (dense_[first_].empty()) --occupied_;
        return result;
    }

  private:
    static constexpr std::int64_t kDenseKeys = 1 << 14;

    std::vector<Bucket> dense_;
    std::size_t first_ = 0;     // no bucket before it holds anything
    std::size_t occupied_ = 0;  // dense buckets that hold something
    std::map<std::int64_t, Bucket> sparse_;
};

}  // namespace praxis
