#include "search/lifted/database.hpp"

namespace praxis::lifted {

Database::Database(const LiftedTask& task)
    : task_(task),
      atoms_(task),
      views_of_(task.predicates.size() + task.types.size()),
      membership_begin_(1, 0) {}

ViewNumber Database::view(const Pattern& pattern) {
    const auto [found, fresh] = numbers_.try_emplace(pattern, static_cast<ViewNumber>(views_.size()));
    if (fresh) {
        views_.emplace_back(static_cast<std::uint32_t>(pattern.types.size()), task_.objects.size());
        patterns_.push_back(pattern);
        views_of_[pattern.predicate].push_back(found->second);
    }
    return found->second;
}

bool Database::matches(const Pattern& pattern, const ObjectNumber* arguments) const {
    for (std::size_t c = 0; c < pattern.columns.size(); ++c) {
        const std::int32_t column = pattern.columns[c];
        if (column < 0) {
            if (arguments[c] != static_cast<ObjectNumber>(~column)) return false;
            continue;
        }
        const auto slot = static_cast<std::size_t>(column);
        if (!task_.types[pattern.types[slot]].contains[arguments[c]]) return false;
        for (std::size_t other = 0; other < c; ++other)
            if (pattern.columns[other] == column && arguments[other] != arguments[c]) return false;
    }
    return true;
}

void Database::append(ViewNumber view, const ObjectNumber* arguments) {
    ObjectNumber* row = views_[view].append();
    const std::vector<std::int32_t>& columns = patterns_[view].columns;
    for (std::size_t c = 0; c < columns.size(); ++c)
        if (columns[c] >= 0) row[columns[c]] = arguments[c];
}

AtomNumber Database::intern(PredicateNumber predicate, const ObjectNumber* arguments) {
    const auto [atom, fresh] = atoms_.intern(predicate, arguments);
    if (fresh) {
        stamps_.push_back(0);
        for (const ViewNumber view : views_of_[predicate])
            if (matches(patterns_[view], arguments)) membership_.push_back(view);
        membership_begin_.push_back(static_cast<std::uint32_t>(membership_.size()));
    }
    return atom;
}

void Database::finish() {
    std::vector<ObjectNumber> arguments;
    for (PredicateNumber p = 0; p < task_.predicates.size(); ++p) {
        if (task_.predicates[p].fluent || task_.predicates[p].derived) continue;
        const Relation& initial = task_.initial_atoms[p];
        for (std::size_t i = 0; i < initial.count; ++i) {
            arguments.clear();
            for (const ObjectId object : initial.tuple(i)) arguments.push_back(object.index());
            const AtomNumber atom = intern(p, arguments.data());
            stamps_[atom] = kAlways;
            append_to_views(atom, true);
        }
    }
    for (std::size_t t = 0; t < task_.types.size(); ++t)
        for (const ViewNumber view : views_of_[task_.predicates.size() + t])
            for (const ObjectId object : task_.types[t].objects)
                if (const ObjectNumber number = object.index(); matches(patterns_[view], &number))
                    append(view, &number);
}

void Database::load(std::span<const AtomNumber> atoms) {
    for (const ViewNumber view : filled_) views_[view].clear();
    filled_.clear();
    ++stamp_;
    for (const AtomNumber atom : atoms) {
        stamps_[atom] = stamp_;
        append_to_views(atom, false);
    }
}

void Database::append_to_views(AtomNumber atom, bool for_good) {
    const ObjectNumber* arguments = atoms_.arguments(atom);
    for (std::uint32_t m = membership_begin_[atom]; m < membership_begin_[atom + 1]; ++m) {
        const ViewNumber view = membership_[m];
        if (!for_good && views_[view].size() == 0) filled_.push_back(view);
        append(view, arguments);
    }
}

void Database::derive(AtomNumber atom, bool for_good) {
    if (holds(atom)) return;
    stamps_[atom] = for_good ? kAlways : stamp_;
    append_to_views(atom, for_good);
}

std::size_t Database::memory() const {
    return atoms_.memory() + (stamps_.capacity() + membership_.capacity() + membership_begin_.capacity()) *
                                 sizeof(std::uint32_t);
}

}  // namespace praxis::lifted
