// The set of stored states by their content, as a hash table of 4-byte ids.
//
// A bucket is one cache line: twelve ids and twelve one-byte tags taken from the hash, so that a look-up
// costs one cache miss here and, but for one time in some two hundred, one at the state that is equal. The
// table is cut into shards that grow one after the other, by a half each: there is never an old and a new
// copy of the whole, and the memory follows the number of states (about 7.5 bytes each). Contents and hashes
// stay with the owner of the states.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace praxis {

class StateSet {
  public:
    StateSet() {
        for (Shard& shard : shards_) shard.buckets.resize(1);
    }

    /// The id with hash `hash` for which `equal(id)` holds and false; or else `fresh`, added, and true.
    /// `hash_of(id)` is the hash that an id was added with; `fetch(id)` may bring what it needs into the
    /// cache. The set is unchanged if it throws.
    template <class Equal, class HashOf, class Fetch>
    std::pair<std::uint32_t, bool> insert(std::uint64_t hash, std::uint32_t fresh, const Equal& equal,
                                          const HashOf& hash_of, const Fetch& fetch) {
        Shard& shard = shards_[hash >> (64 - kShardBits)];
        const std::uint8_t tag = tag_of(hash);
        for (std::size_t i = shard.place(hash);; i = shard.after(i)) {
            Bucket& bucket = shard.buckets[i];
            for (std::uint32_t hits = bucket.hits(tag); hits != 0; hits &= hits - 1) {
                const std::uint32_t id = bucket.ids[static_cast<std::size_t>(__builtin_ctz(hits))];
                if (equal(id)) return {id, false};
            }
            if (bucket.count < kBucketSize) {
                if (shard.size * kMaximumLoad.second >=
                    shard.buckets.size() * kBucketSize * kMaximumLoad.first) {
                    grow(shard, static_cast<std::size_t>(&shard - shards_.data()), hash_of, fetch);
                    shard.add(hash, fresh);
                } else {
                    bucket.add(fresh, tag);
                    ++shard.size;
                }
                return {fresh, true};
            }
        }
    }

    /// Fetches the bucket of `hash` into the cache.
    void prefetch(std::uint64_t hash) const {
        const Shard& shard = shards_[hash >> (64 - kShardBits)];
        __builtin_prefetch(&shard.buckets[shard.place(hash)]);
    }

    /// The first id in the bucket of `hash` that may have that hash; kNone if there is none. Only a hint.
    static constexpr std::uint32_t kNone = 0xffffffffu;
    std::uint32_t likely(std::uint64_t hash) const {
        const Shard& shard = shards_[hash >> (64 - kShardBits)];
        const Bucket& bucket = shard.buckets[shard.place(hash)];
        const std::uint32_t hits = bucket.hits(tag_of(hash));
        return hits == 0 ? kNone : bucket.ids[static_cast<std::size_t>(__builtin_ctz(hits))];
    }

    /// Bytes on the heap.
    std::size_t memory() const {
        std::size_t bytes = 0;
        for (const Shard& shard : shards_) bytes += shard.buckets.capacity() * sizeof(Bucket);
        return bytes;
    }

  private:
    static constexpr std::uint32_t kShardBits = 6;
    static constexpr std::uint32_t kBucketSize = 12;
    static constexpr std::pair<std::size_t, std::size_t> kMaximumLoad{17, 20};

    struct alignas(64) Bucket {
        std::array<std::uint32_t, kBucketSize> ids{};
        std::array<std::uint8_t, kBucketSize> tags{};
        std::uint32_t count = 0;

        std::uint32_t hits(std::uint8_t tag) const {
            const std::uint32_t used = (1u << count) - 1;
#ifdef __SSE2__
            const __m128i line = _mm_load_si128(reinterpret_cast<const __m128i*>(tags.data()));
            const __m128i equal = _mm_cmpeq_epi8(line, _mm_set1_epi8(static_cast<char>(tag)));
            return static_cast<std::uint32_t>(_mm_movemask_epi8(equal)) & used;
#else
            std::uint32_t hits = 0;
            for (std::uint32_t i = 0; i < kBucketSize; ++i)
                hits |= static_cast<std::uint32_t>(tags[i] == tag) << i;
            return hits & used;
#endif
        }
        void add(std::uint32_t id, std::uint8_t tag) {
            ids[count] = id;
            tags[count] = tag;
            ++count;
        }
    };
    static_assert(sizeof(Bucket) == 64);

    struct Shard {
        std::vector<Bucket> buckets;
        std::size_t size = 0;

        std::size_t place(std::uint64_t hash) const {
            return static_cast<std::size_t>((hash & 0xffffffffu) * buckets.size() >> 32);
        }
        std::size_t after(std::size_t i) const { return i + 1 == buckets.size() ? 0 : i + 1; }
        void add(std::uint64_t hash, std::uint32_t id) {
            std::size_t i = place(hash);
            while (buckets[i].count == kBucketSize) i = after(i);
            buckets[i].add(id, tag_of(hash));
            ++size;
        }
    };

    static std::uint8_t tag_of(std::uint64_t hash) {
        return static_cast<std::uint8_t>(hash >> 40);
    }

    /// Shards take different sizes early on, so that later they do not all grow at the same time.
    static std::size_t next_size(std::size_t size, std::size_t shard) {
        return size < 8 ? size + 1 : size == 8 ? 9 + shard % 8 : size + size / 2;
    }

    template <class HashOf, class Fetch>
    static void grow(Shard& shard, std::size_t number, const HashOf& hash_of, const Fetch& fetch) {
        Shard larger;
        larger.buckets.resize(next_size(shard.buckets.size(), number));
        for (std::size_t place = 0; place < shard.buckets.size(); ++place) {
            if (place + 2 < shard.buckets.size()) {
                const Bucket& ahead = shard.buckets[place + 2];
                for (std::uint32_t i = 0; i < ahead.count; ++i) fetch(ahead.ids[i]);
            }
            const Bucket& bucket = shard.buckets[place];
            for (std::uint32_t i = 0; i < bucket.count; ++i)
                larger.add(hash_of(bucket.ids[i]), bucket.ids[i]);
        }
        shard = std::move(larger);
    }

    std::array<Shard, std::size_t{1} << kShardBits> shards_;
};

/// A hash of `count` words in which every bit depends on all of them (multiply and fold, after wyhash).
inline std::uint64_t hash_words(const std::uint32_t* words, std::size_t count) {
    const auto mix = [](std::uint64_t a, std::uint64_t b) {
        __extension__ using Wide = unsigned __int128;
        const Wide product = static_cast<Wide>(a) * b;
        return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
    };
    std::uint64_t hash = 0x9e3779b97f4a7c15u ^ count;
    for (; count >= 4; words += 4, count -= 4) {
        std::uint64_t first = 0, second = 0;
        std::memcpy(&first, words, 8);
        std::memcpy(&second, words + 2, 8);
        hash = mix(first ^ 0xa0761d6478bd642fu ^ hash, second ^ 0xe7037ed1a0b428dbu);
    }
    std::uint64_t first = 0, second = 0;
    if (count >= 2) {
        std::memcpy(&first, words, 8);
        if (count == 3) second = words[2];
    } else if (count == 1) {
        first = words[0];
    }
    hash = mix(first ^ 0x8ebc6af09c88c6e3u ^ hash, second ^ 0x589965cc75374cc3u ^ (hash >> 1));
    return mix(hash ^ 0xd6e8feb86659fd93u, 0xa0761d6478bd642fu);
}

}  // namespace praxis
