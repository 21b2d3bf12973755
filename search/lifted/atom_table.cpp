#include "search/lifted/atom_table.hpp"

#include <algorithm>

namespace praxis::lifted {

AtomTable::AtomTable(const LiftedTask& task) : slots_(1024, 0) {
    for (const Predicate& predicate : task.predicates)
        arities_.push_back(static_cast<std::uint32_t>(predicate.parameters.size()));
}

std::size_t AtomTable::place(PredicateNumber predicate, const ObjectNumber* arguments) const {
    std::size_t hash = (predicate + 1) * 0x9e3779b97f4a7c15ULL;
    for (std::uint32_t i = 0; i < arities_[predicate]; ++i) {
        hash = (hash ^ arguments[i]) * 0xe7037ed1a0b428dbULL;
        hash ^= hash >> 32;
    }
    return hash & (slots_.size() - 1);
}

bool AtomTable::equal(AtomNumber atom, PredicateNumber predicate, const ObjectNumber* arguments) const {
    return this->predicate(atom) == predicate &&
           std::equal(arguments, arguments + arities_[predicate], this->arguments(atom));
}

AtomNumber AtomTable::find(PredicateNumber predicate, const ObjectNumber* arguments) const {
    for (std::size_t slot = place(predicate, arguments); slots_[slot] != 0;
         slot = (slot + 1) & (slots_.size() - 1))
        if (equal(slots_[slot] - 1, predicate, arguments)) return slots_[slot] - 1;
    return kNoAtom;
}

std::pair<AtomNumber, bool> AtomTable::intern(PredicateNumber predicate, const ObjectNumber* arguments) {
    std::size_t slot = place(predicate, arguments);
    for (; slots_[slot] != 0; slot = (slot + 1) & (slots_.size() - 1))
        if (equal(slots_[slot] - 1, predicate, arguments)) return {slots_[slot] - 1, false};
    const AtomNumber atom = size();
    begin_.push_back(static_cast<std::uint32_t>(words_.size()));
    words_.push_back(predicate);
    words_.insert(words_.end(), arguments, arguments + arities_[predicate]);
    slots_[slot] = atom + 1;
    if (std::size_t{size()} * 2 > slots_.size()) grow();
    return {atom, true};
}

void AtomTable::grow() {
    slots_.assign(slots_.size() * 2, 0);
    for (AtomNumber atom = 0; atom < size(); ++atom) {
        std::size_t slot = place(predicate(atom), arguments(atom));
        while (slots_[slot] != 0) slot = (slot + 1) & (slots_.size() - 1);
        slots_[slot] = atom + 1;
    }
}

std::size_t AtomTable::memory() const {
    return (words_.capacity() + begin_.capacity() + slots_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace praxis::lifted
