#include "search/atom_index.hpp"

#include <algorithm>
#include <string_view>
#include <unordered_map>

namespace praxis {

AtomIndex::AtomIndex(const LiftedTask& lifted, const FiniteDomainTask& ground) {
    slots_.assign(64, kAbsent);
    add_facts(lifted, ground);
    add_constants(lifted);
    add_groups(ground);
}

std::uint64_t AtomIndex::hash(std::span<const std::uint32_t> key) const {
    std::uint64_t value = 0x9e3779b97f4a7c15ull;
    for (std::uint32_t word : key) value = (value ^ word) * 0xff51afd7ed558ccdull ^ (value >> 29);
    return value ^ (value >> 32);
}

std::uint32_t AtomIndex::find(std::span<const std::uint32_t> key) const {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash(key) & mask;; slot = (slot + 1) & mask) {
        const std::uint32_t number = slots_[slot];
        if (number == kAbsent || std::ranges::equal(keys_[number], key)) return number;
    }
}

std::uint32_t AtomIndex::find(PredicateId predicate, std::span<const ObjectId> arguments) const {
    std::uint32_t small[16];
    std::vector<std::uint32_t> large;
    std::uint32_t* key = small;
    if (arguments.size() >= std::size(small)) {
        large.resize(arguments.size() + 1);
        key = large.data();
    }
    key[0] = predicate.index();
    for (std::size_t i = 0; i < arguments.size(); ++i) key[i + 1] = arguments[i].index();
    return find({key, arguments.size() + 1});
}

void AtomIndex::grow() {
    std::vector<std::uint32_t> slots(slots_.size() * 2, kAbsent);
    const std::size_t mask = slots.size() - 1;
    for (std::uint32_t number : slots_) {
        if (number == kAbsent) continue;
        std::size_t slot = hash(keys_[number]) & mask;
        while (slots[slot] != kAbsent) slot = (slot + 1) & mask;
        slots[slot] = number;
    }
    slots_ = std::move(slots);
}

void AtomIndex::insert(std::span<const std::uint32_t> key, Entry entry) {
    const auto number = static_cast<std::uint32_t>(entries_.size());
    if (const std::uint32_t first = find(key); first != kAbsent) {
        entry.next = entries_[first].next;
        entries_[first].next = number;
    } else {
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = hash(key) & mask;
        while (slots_[slot] != kAbsent) slot = (slot + 1) & mask;
        slots_[slot] = number;
    }
    entries_.push_back(entry);
    keys_.append(key);
    if (entries_.size() * 2 > slots_.size()) grow();
}

void AtomIndex::add_facts(const LiftedTask& lifted, const FiniteDomainTask& ground) {
    std::unordered_map<std::string_view, std::uint32_t> predicates;
    std::unordered_map<std::string_view, std::uint32_t> objects;
    for (std::uint32_t i = 0; i < lifted.predicates.size(); ++i)
        predicates.emplace(lifted.predicates[i].name, i);
    for (std::uint32_t i = 0; i < lifted.objects.size(); ++i) objects.emplace(lifted.objects[i].name, i);
    std::vector<std::uint32_t> object_of(ground.fact_names.symbols.size(), kAbsent);
    for (std::size_t i = 0; i < object_of.size(); ++i)
        if (const auto found = objects.find(ground.fact_names.symbols[i]); found != objects.end())
            object_of[i] = found->second;

    empty_values_.assign(ground.variable_count(), -1);
    std::vector<std::uint32_t> key;
    for (std::size_t variable = 0; variable < ground.variable_count(); ++variable) {
        for (std::int32_t value = 0; value < ground.domain_sizes[variable]; ++value) {
            const Fact fact{static_cast<std::int32_t>(variable), value};
            const std::uint32_t number = ground.fact_number(fact);
            if (!ground.is_atom(fact)) {
                empty_values_[variable] = value;
                continue;
            }
            const auto words = ground.fact_names.names[number];
            if (words.empty()) continue;
            // Auxiliary predicates of the grounder have no counterpart in the lifted task.
            const auto predicate = predicates.find(ground.fact_names.symbols[words[0]]);
            if (predicate == predicates.end()) continue;
            key.assign(1, predicate->second);
            for (std::uint32_t word : words.subspan(1)) key.push_back(object_of[word]);
            insert(key, {Entry::Kind::fact, fact, kAbsent});
        }
    }
}

void AtomIndex::add_constants(const LiftedTask& lifted) {
    std::vector<std::uint32_t> key;
    for (std::uint32_t predicate = 0; predicate < lifted.initial_atoms.size(); ++predicate) {
        const Relation& relation = lifted.initial_atoms[predicate];
        const bool fluent = lifted.predicates[predicate].fluent;
        for (std::size_t i = 0; i < relation.count; ++i) {
            key.assign(1, predicate);
            for (ObjectId object : relation.tuple(i)) key.push_back(object.index());
            if (find(key) != kAbsent) continue;
            insert(key, {fluent ? Entry::Kind::constant_fluent : Entry::Kind::constant_static, {}, kAbsent});
            constant_fluents_ += fluent;
        }
    }
}

void AtomIndex::add_groups(const FiniteDomainTask& ground) {
    std::vector<std::vector<std::uint32_t>> groups(ground.fact_count());
    for (std::uint32_t group = 0; group < ground.mutex_groups.size(); ++group)
        for (Fact fact : ground.mutex_groups[group]) groups[ground.fact_number(fact)].push_back(group);
    for (const auto& list : groups) groups_of_.append(list);
}

}  // namespace praxis
