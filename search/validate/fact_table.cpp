#include "search/validate/fact_table.hpp"

#include <algorithm>

namespace praxis::validation {

namespace {
constexpr std::size_t kFirstSlots = 16;
constexpr std::uint32_t kAll = std::numeric_limits<std::uint32_t>::max();
}  // namespace

FactTable::FactTable(std::uint32_t arity) : arity_(arity), slots_(kFirstSlots, kNone) {}

bool FactTable::agree(std::uint32_t mask, const std::uint32_t* a, const std::uint32_t* b) const {
    if (mask == kAll) return std::equal(a, a + arity_, b);
    for (; mask != 0; mask &= mask - 1) {
        const int position = __builtin_ctz(mask);
        if (a[position] != b[position]) return false;
    }
    return true;
}

std::size_t FactTable::hash(std::uint32_t mask, const std::uint32_t* tuple) const {
    std::uint64_t result = 0x9e3779b97f4a7c15ULL;
    const auto mix = [&result](std::uint32_t argument) {
        result = (result ^ argument) * 0xff51afd7ed558ccdULL;
        result ^= result >> 29;
    };
    if (mask == kAll) {
        for (std::uint32_t i = 0; i < arity_; ++i) mix(tuple[i]);
    } else {
        for (; mask != 0; mask &= mask - 1) mix(tuple[__builtin_ctz(mask)]);
    }
    return static_cast<std::size_t>(result ^ (result >> 32));
}

std::size_t FactTable::slot_of(const std::uint32_t* tuple) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(kAll, tuple) & mask;
    while (slots_[slot] != kNone && !agree(kAll, row(slots_[slot]), tuple)) slot = (slot + 1) & mask;
    return slot;
}

std::uint32_t FactTable::find(const std::uint32_t* tuple) const {
    return slots_[slot_of(tuple)];
}

bool FactTable::contains(const std::uint32_t* tuple) const {
    const std::uint32_t found = find(tuple);
    return found != kNone && alive(found);
}

bool FactTable::insert(const std::uint32_t* tuple) {
    const std::size_t slot = slot_of(tuple);
    std::uint32_t found = slots_[slot];
    if (found != kNone) {
        if (alive(found)) return false;
        stamps_[found] = epoch_;
    } else {
        found = row_count();
        slots_[slot] = found;
        arguments_.insert(arguments_.end(), tuple, tuple + arity_);
        stamps_.push_back(epoch_);
        if (2 * stamps_.size() > slots_.size()) grow_slots();
        for (Index& index : indexes_) add_to(index, found);
    }
    ++alive_count_;
    ++version_;
    return true;
}

bool FactTable::erase(const std::uint32_t* tuple) {
    const std::uint32_t found = find(tuple);
    if (found == kNone || !alive(found)) return false;
    stamps_[found] = 0;
    --alive_count_;
    ++version_;
    return true;
}

void FactTable::clear() {
    ++epoch_;
    alive_count_ = 0;
    ++version_;
}

void FactTable::compact() {
    if (stamps_.size() < 64 + 4 * alive_count_) return;
    FactTable fresh(arity_);
    for (std::uint32_t i = 0; i < row_count(); ++i) {
        if (alive(i)) fresh.insert(row(i));
    }
    fresh.version_ = version_;
    *this = std::move(fresh);
}

void FactTable::grow_slots() {
    slots_.assign(2 * slots_.size(), kNone);
    for (std::uint32_t i = 0; i < row_count(); ++i) slots_[slot_of(row(i))] = i;
}

std::size_t FactTable::slot_of(const Index& index, const std::uint32_t* key) const {
    const std::size_t mask = index.slots.size() - 1;
    std::size_t slot = hash(index.mask, key) & mask;
    while (index.slots[slot] != kNone && !agree(index.mask, row(index.first[index.slots[slot]]), key)) {
        slot = (slot + 1) & mask;
    }
    return slot;
}

void FactTable::grow(Index& index) {
    index.slots.assign(2 * index.slots.size(), kNone);
    for (std::uint32_t bucket = 0; bucket < index.first.size(); ++bucket) {
        index.slots[slot_of(index, row(index.first[bucket]))] = bucket;
    }
}

void FactTable::add_to(Index& index, std::uint32_t added) {
    const std::size_t slot = slot_of(index, row(added));
    std::uint32_t bucket = index.slots[slot];
    if (bucket == kNone) {
        bucket = static_cast<std::uint32_t>(index.first.size());
        index.slots[slot] = bucket;
        index.first.push_back(added);
        index.count.push_back(1);
        index.next.push_back(kNone);
        if (2 * index.first.size() > index.slots.size()) grow(index);
    } else {
        index.next.push_back(index.first[bucket]);
        index.first[bucket] = added;
        ++index.count[bucket];
    }
}

FactTable::Chain FactTable::match(std::uint32_t mask, const std::uint32_t* key) {
    auto index =
        std::find_if(indexes_.begin(), indexes_.end(), [mask](const Index& i) { return i.mask == mask; });
    if (index == indexes_.end()) {
        indexes_.push_back(Index{mask, std::vector<std::uint32_t>(kFirstSlots, kNone), {}, {}, {}});
        index = indexes_.end() - 1;
        for (std::uint32_t i = 0; i < row_count(); ++i) add_to(*index, i);
    }
    const std::uint32_t bucket = index->slots[slot_of(*index, key)];
    if (bucket == kNone) return {};
    return {index->first[bucket], index->count[bucket], &index->next};
}

}  // namespace praxis::validation
