// The atoms of one state as relations that queries can be asked of.
//
// Usage: queries ask for the views they need while they are compiled; `finish` then fills the views of static
// predicates and types for good, and `load` those of fluent predicates for one state after the other. Which
// views an atom belongs to is worked out once, when the atom gets its number. Predicates beyond those of the
// task stand for types: type_predicate(t) holds of the objects of t.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "parser/task.hpp"
#include "search/lifted/atom_table.hpp"
#include "search/lifted/view.hpp"

namespace praxis::lifted {

using ViewNumber = std::uint32_t;

/// What a view selects: by column a constant or a slot (a place for a variable), by slot a type.
struct Pattern {
    PredicateNumber predicate = 0;
    std::vector<std::int32_t> columns;  ///< a slot, or ~object
    std::vector<std::uint32_t> types;   ///< by slot

    friend auto operator<=>(const Pattern&, const Pattern&) = default;
};

class Database {
  public:
    explicit Database(const LiftedTask& task);

    const LiftedTask& task() const { return task_; }
    const AtomTable& atoms() const { return atoms_; }
    PredicateNumber type_predicate(TypeId type) const {
        return static_cast<PredicateNumber>(task_.predicates.size()) + type.index();
    }

    /// The view with this pattern. Not after `finish`.
    ViewNumber view(const Pattern& pattern);
    View& operator[](ViewNumber view) { return views_[view]; }
    void finish();

    AtomNumber intern(PredicateNumber predicate, const ObjectNumber* arguments);
    /// Makes the atoms, all fluent, the present state.
    void load(std::span<const AtomNumber> atoms);
    /// Adds an atom of a derived predicate to the present state, or to all of them.
    void derive(AtomNumber atom, bool for_good);
    /// In the present state.
    bool holds(AtomNumber atom) const { return stamps_[atom] == stamp_ || stamps_[atom] == kAlways; }
    bool holds(PredicateNumber predicate, const ObjectNumber* arguments) const {
        const AtomNumber atom = atoms_.find(predicate, arguments);
        return atom != kNoAtom && holds(atom);
    }
    std::size_t memory() const;

  private:
    static constexpr std::uint32_t kAlways = 0xffffffff;

    bool matches(const Pattern& pattern, const ObjectNumber* arguments) const;
    void append_to_views(AtomNumber atom, bool for_good);
    void append(ViewNumber view, const ObjectNumber* arguments);

    const LiftedTask& task_;
    AtomTable atoms_;
    std::vector<View> views_;
    std::vector<Pattern> patterns_;  ///< by view
    std::map<Pattern, ViewNumber> numbers_;
    std::vector<std::vector<ViewNumber>> views_of_;  ///< by predicate
    std::vector<ViewNumber> filled_;                 ///< by the present state
    std::vector<std::uint32_t> stamps_;              ///< by atom
    std::uint32_t stamp_ = 1;
    std::vector<std::uint32_t> membership_begin_;  ///< by atom, and one more
    std::vector<ViewNumber> membership_;
};

}  // namespace praxis::lifted
