#include "parser/check/tuples.hpp"

#include <algorithm>

namespace praxis::check {
namespace {

std::size_t hash(std::span<const ObjectId> tuple) {
    std::uint64_t value = 0x9E3779B97F4A7C15U;
    for (const ObjectId object : tuple) {
        value = (value ^ object.index()) * 0xFF51AFD7ED558CCDU;
        value ^= value >> 32;
    }
    return static_cast<std::size_t>(value);
}

}  // namespace

std::size_t TupleIndex::slot_of(std::span<const ObjectId> tuple) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(tuple) & mask;
    while (slots_[slot] != 0 && !std::ranges::equal(relation_->tuple(slots_[slot] - 1), tuple)) {
        slot = (slot + 1) & mask;
    }
    return slot;
}

std::size_t TupleIndex::find(std::span<const ObjectId> tuple) const {
    if (slots_.empty()) return kNone;
    const std::uint32_t number = slots_[slot_of(tuple)];
    return number == 0 ? kNone : number - 1;
}

std::size_t TupleIndex::insert(std::span<const ObjectId> tuple) {
    if (relation_->count * 2 >= slots_.size()) grow();
    std::uint32_t& number = slots_[slot_of(tuple)];
    if (number == 0) {
        relation_->arguments.insert(relation_->arguments.end(), tuple.begin(), tuple.end());
        number = static_cast<std::uint32_t>(++relation_->count);
    }
    return number - 1;
}

void TupleIndex::grow() {
    slots_.assign(std::max<std::size_t>(16, slots_.size() * 4), 0);
    for (std::size_t i = 0; i < relation_->count; ++i) {
        slots_[slot_of(relation_->tuple(i))] = static_cast<std::uint32_t>(i + 1);
    }
}

}  // namespace praxis::check
