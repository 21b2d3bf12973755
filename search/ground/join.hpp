// Conjunctive queries over relations: planned once, run often.
//
// A *body* is a conjunction of atoms, equalities and inequalities over numbered, typed variables. A *plan*
// orders it into steps (probe an index, check a tuple, compare, enumerate a type, ...) so that each step is
// as selective as the sizes of the relations promise; running a plan extends a binding in every possible way
// and calls back for each. Joins see published rows only.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "parser/task.hpp"
#include "search/ground/relations.hpp"

namespace praxis::grounding {

struct BodyAtom {
    RelationId relation = 0;
    std::vector<Term> terms;
    bool negated = false;  ///< holds if the tuple is not in the (complete) relation
};

struct Body {
    std::vector<BodyAtom> atoms;
    std::vector<std::pair<Term, Term>> equal;
    std::vector<std::pair<Term, Term>> unequal;

    bool empty() const { return atoms.empty() && equal.empty() && unequal.empty(); }
    void add(const Body& other);
};

/// Which rows an atom of a triggered body may match when it is over the trigger's relation: all up to the
/// trigger's row (later atoms), or only earlier ones (earlier atoms). So each combination of rows is met
/// once.
class JoinPlan {
  public:
    /// What a plan starts from.
    struct Start {
        std::vector<bool> bound;             ///< by variable: has a value when the plan runs
        std::vector<bool> needed;            ///< by variable: must have a value when the plan calls back
        std::optional<std::size_t> trigger;  ///< atom matched against a given row instead of the relation
    };

    JoinPlan() = default;
    JoinPlan(Relations& relations, const Body& body, const std::vector<TypeId>& variable_types,
             const Start& start);

    /// Calls `emit()` for each extension of `binding`; emit returns false to stop. Returns whether it went to
    /// the end.
    template <class Emit>
    bool run(const Relations& relations, Object* binding, Row trigger_row, Emit&& emit) const {
        return steps_.empty() ? emit() : run_from(relations, steps_.data(), binding, trigger_row, emit);
    }

  private:
    friend class JoinPlanner;

    enum class Kind : std::uint8_t {
        match,
        probe,
        scan,
        member,
        absent,
        equal,
        unequal,
        assign,
        of_type,
        each,
        emit
    };

    struct Step {
        Kind kind = Kind::emit;
        bool before_trigger = false;  ///< the row must be earlier than the trigger's
        RelationId relation = 0;
        std::uint32_t index = 0;
        TypeId type;
        std::int32_t left = 0,
                     right = 0;  ///< terms of comparisons; `left`: variable of assign, of_type, each
        std::uint32_t key = 0, key_end = 0;      ///< arguments_: terms of an index key or a whole tuple
        std::uint32_t bind = 0, bind_end = 0;    ///< arguments_: pairs (column, variable)
        std::uint32_t check = 0, check_end = 0;  ///< arguments_: pairs (column, term)
    };

    static Object value(std::int32_t term, const Object* binding) {
        return term >= 0 ? binding[term] : static_cast<Object>(~term);
    }
    bool take(const Step& step, const Object* row, Object* binding) const {
        for (std::uint32_t i = step.bind; i < step.bind_end; i += 2)
            binding[arguments_[i + 1]] = row[arguments_[i]];
        for (std::uint32_t i = step.check; i < step.check_end; i += 2)
            if (row[arguments_[i]] != value(arguments_[i + 1], binding)) return false;
        return true;
    }
    const Object* gather(const Step& step, const Object* binding) const {
        for (std::uint32_t i = step.key; i < step.key_end; ++i)
            key_[i - step.key] = value(arguments_[i], binding);
        return key_.data();
    }

    template <class Emit>
    bool run_from(const Relations& relations, const Step* step, Object* binding, Row trigger_row,
                  Emit& emit) const;

    std::vector<Step> steps_;
    std::vector<std::int32_t> arguments_;
    mutable std::vector<Object> key_;
};

template <class Emit>
bool JoinPlan::run_from(const Relations& relations, const Step* step, Object* binding, Row trigger_row,
                        Emit& emit) const {
    for (;; ++step) {
        switch (step->kind) {
            case Kind::emit:
                return emit();
            case Kind::match:
                if (!take(*step, relations[step->relation].row(trigger_row), binding)) return true;
                break;
            case Kind::member: {
                const TupleStore& store = relations[step->relation];
                const Row row = store.find(gather(*step, binding));
                if (row >= store.published() || (step->before_trigger && row >= trigger_row)) return true;
                break;
            }
            case Kind::absent:
                if (relations[step->relation].find(gather(*step, binding)) != kNoRow) return true;
                break;
            case Kind::equal:
                if (value(step->left, binding) != value(step->right, binding)) return true;
                break;
            case Kind::unequal:
                if (value(step->left, binding) == value(step->right, binding)) return true;
                break;
            case Kind::assign:
                binding[step->left] = value(step->right, binding);
                break;
            case Kind::of_type:
                if (!relations.task().types[step->type.index()].contains[value(step->left, binding)])
                    return true;
                break;
            case Kind::each:
                for (ObjectId object : relations.task().types[step->type.index()].objects) {
                    binding[step->left] = object.index();
                    if (!relations.tick() || !run_from(relations, step + 1, binding, trigger_row, emit))
                        return false;
                }
                return true;
            case Kind::scan: {
                const TupleStore& store = relations[step->relation];
                const Row end = step->before_trigger ? trigger_row : store.published();
                for (Row row = 0; row < end; ++row) {
                    if (!relations.tick()) return false;
                    if (take(*step, store.row(row), binding) &&
                        !run_from(relations, step + 1, binding, trigger_row, emit))
                        return false;
                }
                return true;
            }
            case Kind::probe: {
                const TupleStore& store = relations[step->relation];
                for (Row row = store.first_in(step->index, gather(*step, binding)); row != kNoRow;
                     row = store.next_in(step->index, row)) {
                    if (!relations.tick()) return false;
                    if (step->before_trigger && row >= trigger_row) continue;
                    if (take(*step, store.row(row), binding) &&
                        !run_from(relations, step + 1, binding, trigger_row, emit))
                        return false;
                }
                return true;
            }
        }
    }
}

}  // namespace praxis::grounding
