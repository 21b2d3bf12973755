// The states a lifted search has met, each stored once, as differences of sorted atom numbers.
//
// A state is the increasing list of its atoms; stored, it is the gaps between them, seven bits a byte with
// the eighth saying that more follow, so that most atoms take one byte. Records differ in length and lie one
// after the other in segments that never move.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "search/lifted/atom_table.hpp"
#include "search/state/record_pool.hpp"
#include "search/state/state_set.hpp"

namespace praxis::lifted {

using StateNumber = std::uint32_t;
inline constexpr StateNumber kNoState = 0xffffffff;

class StateStore {
  public:
    std::uint32_t size() const { return nodes_.size(); }
    /// The state's number and whether it is new, then with this parent.
    std::pair<StateNumber, bool> insert(std::span<const AtomNumber> atoms, StateNumber parent);
    void read(StateNumber state, std::vector<AtomNumber>& atoms) const;
    StateNumber parent(StateNumber state) const { return nodes_[state][2]; }
    /// Words that belong to the search; zero at first.
    std::uint32_t& note(StateNumber state) { return nodes_[state][3]; }

    std::uint64_t marks(StateNumber state) const {
        return nodes_[state][4] | std::uint64_t{nodes_[state][5]} << 32;
    }
    void set_marks(StateNumber state, std::uint64_t marks) {
        nodes_[state][4] = static_cast<std::uint32_t>(marks);
        nodes_[state][5] = static_cast<std::uint32_t>(marks >> 32);
    }

    /// Bytes on the heap.
    std::size_t memory() const;

  private:
    static constexpr std::size_t kSegmentWords = std::size_t{1} << 18;
    static constexpr std::size_t kNodeWords = 6;  ///< segment, offset, parent, note, marks

    const std::uint32_t* record(StateNumber state) const {
        return segments_[nodes_[state][0]].words.get() + nodes_[state][1];
    }
    /// A record: its length in words without this one, then the bytes.
    static std::uint64_t hash(const std::uint32_t* record) { return hash_words(record, record[0] + 1); }
    void encode(std::span<const AtomNumber> atoms);

    struct Segment {
        std::unique_ptr<std::uint32_t[]> words;
        std::size_t size = 0;
    };
    std::vector<Segment> segments_;
    std::size_t used_ = 0;  ///< words of the last segment
    RecordPool nodes_{kNodeWords};
    StateSet set_;
    std::vector<std::uint32_t> candidate_;
};

}  // namespace praxis::lifted
