#include "search/lifted/view.hpp"

namespace praxis::lifted {

void View::cover(Index& index, std::uint32_t column) {
    if (index.entries.empty()) index.entries.resize(object_count_);
    if (index.stamp != stamp_) {
        index.stamp = stamp_;
        index.covered = 0;
    }
    if (index.next.size() < size_) index.next.resize(size_);
    for (; index.covered < size_; ++index.covered) {
        Entry& entry = index.entries[row(index.covered)[column]];
        if (entry.stamp != stamp_) entry = {stamp_, kNoRow, 0};
        index.next[index.covered] = entry.head;
        entry.head = index.covered;
        ++entry.count;
    }
}

}  // namespace praxis::lifted
