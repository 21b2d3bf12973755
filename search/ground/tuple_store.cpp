#include "search/ground/tuple_store.hpp"

#include <algorithm>
#include <utility>

namespace praxis::grounding {
namespace {

constexpr std::size_t kNoAddress = std::numeric_limits<std::size_t>::max();

std::size_t mix(std::size_t hash, Object object) {
    hash = (hash ^ object) * 0x9e3779b97f4a7c15ULL;
    return hash ^ (hash >> 29);
}

}  // namespace

TupleStore::TupleStore(std::span<const ColumnRange> columns, std::size_t dense_limit)
    : arity_(static_cast<std::uint32_t>(columns.size())),
      columns_(columns.begin(), columns.end()),
      distinct_(columns.size()),
      seen_values_(columns.size()) {
    std::size_t entries = 1;
    for (const ColumnRange& column : columns_) {
        if (column.position_of == nullptr || entries > dense_limit) {
            entries = dense_limit + 1;
            break;
        }
        entries *= std::max<std::size_t>(column.size, 1);
    }
    use_dense_ = entries <= dense_limit;
    if (use_dense_) dense_.resize(entries);
}

std::size_t TupleStore::dense_address(const Object* tuple) const {
    std::size_t address = 0;
    for (std::uint32_t c = 0; c < arity_; ++c) {
        const std::uint32_t position = (*columns_[c].position_of)[tuple[c]];
        if (position == kNoRow) return kNoAddress;
        address = address * columns_[c].size + position;
    }
    return address;
}

std::size_t TupleStore::hash(const Object* tuple) const {
    std::size_t hash = 0x243f6a8885a308d3ULL;
    for (std::uint32_t c = 0; c < arity_; ++c) hash = mix(hash, tuple[c]);
    return hash ^ (hash >> 32);
}

Row TupleStore::find(const Object* tuple) const {
    if (use_dense_) {
        const std::size_t address = dense_address(tuple);
        return address == kNoAddress ? kNoRow : dense_[address] - 1;
    }
    if (slots_.empty()) return kNoRow;
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash(tuple) & mask; slots_[slot] != 0; slot = (slot + 1) & mask)
        if (std::equal(tuple, tuple + arity_, row(slots_[slot] - 1))) return slots_[slot] - 1;
    return kNoRow;
}

std::pair<Row, bool> TupleStore::insert(const Object* tuple) {
    if (use_dense_) {
        const std::size_t address = dense_address(tuple);
        if (address != kNoAddress) {
            Row& entry = dense_[address];
            if (entry != 0) return {entry - 1, false};
            append(tuple);
            entry = count_;
            return {count_ - 1, true};
        }
        leave_dense();
    }
    if ((std::size_t{count_} + 1) * 2 > slots_.size()) grow_slots();
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(tuple) & mask;
    for (; slots_[slot] != 0; slot = (slot + 1) & mask)
        if (std::equal(tuple, tuple + arity_, row(slots_[slot] - 1))) return {slots_[slot] - 1, false};
    append(tuple);
    slots_[slot] = count_;
    return {count_ - 1, true};
}

void TupleStore::append(const Object* tuple) {
    rows_.insert(rows_.end(), tuple, tuple + arity_);
    ++count_;
}

void TupleStore::grow_slots() {
    std::vector<Row> old = std::move(slots_);
    slots_.assign(std::max<std::size_t>(16, old.size() * 2), 0);
    while (slots_.size() < std::size_t{count_} * 2 + 2) slots_.resize(slots_.size() * 2);
    const std::size_t mask = slots_.size() - 1;
    for (Row i = 0; i < count_; ++i) {
        std::size_t slot = hash(row(i)) & mask;
        while (slots_[slot] != 0) slot = (slot + 1) & mask;
        slots_[slot] = i + 1;
    }
}

void TupleStore::leave_dense() {
    use_dense_ = false;
    dense_.clear();
    dense_.shrink_to_fit();
    grow_slots();
}

void TupleStore::publish(Row end) {
    for (; published_ < end; ++published_)
        for (Index& index : indices_) add_to(index, published_);
}

std::uint32_t TupleStore::index_on(std::span<const std::uint32_t> columns) {
    for (std::size_t i = 0; i < indices_.size(); ++i)
        if (std::equal(columns.begin(), columns.end(), indices_[i].columns.begin(),
                       indices_[i].columns.end()))
            return static_cast<std::uint32_t>(i);
    Index index;
    index.columns.assign(columns.begin(), columns.end());
    for (Row i = 0; i < published_; ++i) add_to(index, i);
    indices_.push_back(std::move(index));
    return static_cast<std::uint32_t>(indices_.size() - 1);
}

std::size_t TupleStore::key_hash(const Index& index, Row i) const {
    const Object* tuple = row(i);
    std::size_t hash = 0x13198a2e03707344ULL;
    for (std::uint32_t c : index.columns) hash = mix(hash, tuple[c]);
    return hash ^ (hash >> 32);
}

void TupleStore::grow(Index& index) {
    std::vector<Row> old = std::move(index.heads);
    index.heads.assign(std::max<std::size_t>(16, old.size() * 2), 0);
    const std::size_t mask = index.heads.size() - 1;
    for (Row head : old) {
        if (head == 0) continue;
        std::size_t slot = key_hash(index, head - 1) & mask;
        while (index.heads[slot] != 0) slot = (slot + 1) & mask;
        index.heads[slot] = head;
    }
}

void TupleStore::add_to(Index& index, Row i) {
    const Object* tuple = row(i);
    if (index.columns.size() == 1) {
        const Object object = tuple[index.columns[0]];
        if (object >= index.heads.size())
            index.heads.resize(std::max<std::size_t>(object + 1, index.heads.size() * 2));
        index.keys += index.heads[object] == 0;
        index.next.push_back(index.heads[object] - 1);
        index.heads[object] = i + 1;
        return;
    }
    if ((index.keys + 1) * 2 > index.heads.size()) grow(index);
    const std::size_t mask = index.heads.size() - 1;
    std::size_t slot = key_hash(index, i) & mask;
    for (; index.heads[slot] != 0; slot = (slot + 1) & mask) {
        const Object* other = row(index.heads[slot] - 1);
        if (std::all_of(index.columns.begin(), index.columns.end(),
                        [&](std::uint32_t c) { return other[c] == tuple[c]; }))
            break;
    }
    index.keys += index.heads[slot] == 0;
    index.next.push_back(index.heads[slot] - 1);
    index.heads[slot] = i + 1;
}

Row TupleStore::first_in(std::uint32_t number, const Object* key) const {
    const Index& index = indices_[number];
    if (index.columns.size() == 1) return *key < index.heads.size() ? index.heads[*key] - 1 : kNoRow;
    if (index.heads.empty()) return kNoRow;
    std::size_t hash = 0x13198a2e03707344ULL;
    for (std::size_t k = 0; k < index.columns.size(); ++k) hash = mix(hash, key[k]);
    hash ^= hash >> 32;
    const std::size_t mask = index.heads.size() - 1;
    for (std::size_t slot = hash & mask; index.heads[slot] != 0; slot = (slot + 1) & mask) {
        const Object* tuple = row(index.heads[slot] - 1);
        bool equal = true;
        for (std::size_t k = 0; k < index.columns.size(); ++k) equal &= tuple[index.columns[k]] == key[k];
        if (equal) return index.heads[slot] - 1;
    }
    return kNoRow;
}

std::size_t TupleStore::distinct(std::uint32_t column) const {
    auto& [seen, values] = distinct_[column];
    auto& marks = seen_values_[column];
    for (; seen < count_; ++seen) {
        const Object object = row(seen)[column];
        if (object >= marks.size()) marks.resize(std::max<std::size_t>(object + 1, marks.size() * 2));
        if (!marks[object]) {
            marks[object] = true;
            ++values;
        }
    }
    return std::max<std::size_t>(values, 1);
}

}  // namespace praxis::grounding
