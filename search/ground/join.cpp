#include "search/ground/join.hpp"

#include <algorithm>
#include <limits>

namespace praxis::grounding {

void Body::add(const Body& other) {
    atoms.insert(atoms.end(), other.atoms.begin(), other.atoms.end());
    equal.insert(equal.end(), other.equal.begin(), other.equal.end());
    unequal.insert(unequal.end(), other.unequal.begin(), other.unequal.end());
}

namespace {

std::int32_t code(Term term) {
    return term.is_variable() ? static_cast<std::int32_t>(term.variable_index())
                              : ~static_cast<std::int32_t>(term.object_id().index());
}

}  // namespace

/// Orders a body greedily: whatever can be checked is checked at once, then the atom with the fewest expected
/// matches comes next; variables that no atom binds are enumerated last, smallest type first.
class JoinPlanner {
  public:
    JoinPlanner(JoinPlan& plan, Relations& relations, const Body& body, const std::vector<TypeId>& types,
                const JoinPlan::Start& start)
        : plan_(plan), relations_(relations), body_(body), types_(types), start_(start), bound_(start.bound) {
        bound_.resize(types.size());
        done_.resize(body.atoms.size());
        equal_done_.resize(body.equal.size());
        unequal_done_.resize(body.unequal.size());
    }

    void make() {
        if (start_.trigger) {
            done_[*start_.trigger] = true;
            JoinPlan::Step step = row_step(JoinPlan::Kind::match, body_.atoms[*start_.trigger], false);
            finish_row_step(step, body_.atoms[*start_.trigger]);
        }
        for (;;) {
            while (add_checks()) {
            }
            const std::size_t atom = cheapest_atom();
            if (atom != kNone) {
                add_atom(atom);
            } else if (!add_enumeration()) {
                break;
            }
        }
        plan_.steps_.emplace_back();
        std::size_t longest = 1;
        for (const JoinPlan::Step& step : plan_.steps_)
            longest = std::max<std::size_t>(longest, step.key_end - step.key);
        plan_.key_.resize(longest);
    }

  private:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    bool known(Term term) const { return !term.is_variable() || bound_[term.variable_index()]; }
    bool all_known(const BodyAtom& atom) const {
        return std::all_of(atom.terms.begin(), atom.terms.end(), [&](Term term) { return known(term); });
    }

    bool add_checks() {
        bool progress = false;
        for (std::size_t i = 0; i < body_.equal.size(); ++i)
            if (!equal_done_[i] && add_equality(body_.equal[i])) equal_done_[i] = progress = true;
        for (std::size_t i = 0; i < body_.unequal.size(); ++i) {
            const auto [a, b] = body_.unequal[i];
            if (unequal_done_[i] || !known(a) || !known(b)) continue;
            add_comparison(JoinPlan::Kind::unequal, a, b);
            unequal_done_[i] = progress = true;
        }
        for (std::size_t i = 0; i < body_.atoms.size(); ++i) {
            const BodyAtom& atom = body_.atoms[i];
            if (done_[i] || !all_known(atom)) continue;
            JoinPlan::Step step;
            step.kind = atom.negated ? JoinPlan::Kind::absent : JoinPlan::Kind::member;
            step.relation = atom.relation;
            step.before_trigger = before_trigger(i);
            add_key(step, atom.terms);
            plan_.steps_.push_back(step);
            done_[i] = progress = true;
        }
        return progress;
    }

    bool add_equality(std::pair<Term, Term> pair) {
        auto [a, b] = pair;
        if (known(a) && known(b)) {
            add_comparison(JoinPlan::Kind::equal, a, b);
            return true;
        }
        if (known(a)) std::swap(a, b);
        if (!known(b)) return false;
        add_comparison(JoinPlan::Kind::assign, a, b);
        bind(a.variable_index());
        add_type_check(a.variable_index());
        return true;
    }

    void add_comparison(JoinPlan::Kind kind, Term a, Term b) {
        JoinPlan::Step step;
        step.kind = kind;
        step.left = code(a);
        step.right = code(b);
        plan_.steps_.push_back(step);
    }

    void add_type_check(std::uint32_t variable) {
        if (types_[variable].index() == 0) return;
        JoinPlan::Step step;
        step.kind = JoinPlan::Kind::of_type;
        step.left = static_cast<std::int32_t>(variable);
        step.type = types_[variable];
        plan_.steps_.push_back(step);
    }

    void add_key(JoinPlan::Step& step, const std::vector<Term>& terms) {
        step.key = static_cast<std::uint32_t>(plan_.arguments_.size());
        for (Term term : terms) plan_.arguments_.push_back(code(term));
        step.key_end = static_cast<std::uint32_t>(plan_.arguments_.size());
    }

    bool before_trigger(std::size_t atom) const {
        return start_.trigger && atom < *start_.trigger &&
               body_.atoms[atom].relation == body_.atoms[*start_.trigger].relation;
    }

    void bind(std::uint32_t variable) { bound_[variable] = true; }

    double expected_matches(const BodyAtom& atom) const {
        const TupleStore& store = relations_[atom.relation];
        double rows = std::max<double>(store.size(), 1);
        for (std::size_t c = 0; c < atom.terms.size(); ++c) {
            bool fixed = known(atom.terms[c]);
            for (std::size_t d = 0; d < c && !fixed; ++d) fixed = atom.terms[d] == atom.terms[c];
            if (fixed) rows /= static_cast<double>(store.distinct(static_cast<std::uint32_t>(c)));
        }
        return rows;
    }

    std::size_t cheapest_atom() const {
        std::size_t best = kNone;
        double best_matches = 0;
        for (std::size_t i = 0; i < body_.atoms.size(); ++i) {
            if (done_[i] || body_.atoms[i].negated) continue;
            const double matches = expected_matches(body_.atoms[i]);
            if (best == kNone || matches < best_matches) {
                best = i;
                best_matches = matches;
            }
        }
        return best;
    }

    /// Which columns a row binds and which it must agree with; columns in `keyed` are known to agree.
    JoinPlan::Step row_step(JoinPlan::Kind kind, const BodyAtom& atom, bool keyed) {
        JoinPlan::Step step;
        step.kind = kind;
        step.relation = atom.relation;
        std::vector<std::int32_t> binds;
        std::vector<std::int32_t> checks;
        std::vector<std::uint32_t> fresh;
        for (std::size_t c = 0; c < atom.terms.size(); ++c) {
            const Term term = atom.terms[c];
            const bool is_fresh = term.is_variable() &&
                                  std::find(fresh.begin(), fresh.end(), term.variable_index()) != fresh.end();
            if (is_fresh || known(term)) {
                if (!keyed || is_fresh)
                    checks.insert(checks.end(), {static_cast<std::int32_t>(c), code(term)});
            } else {
                fresh.push_back(term.variable_index());
                binds.insert(binds.end(), {static_cast<std::int32_t>(c), code(term)});
            }
        }
        auto& arguments = plan_.arguments_;
        step.bind = static_cast<std::uint32_t>(arguments.size());
        arguments.insert(arguments.end(), binds.begin(), binds.end());
        step.bind_end = step.check = static_cast<std::uint32_t>(arguments.size());
        arguments.insert(arguments.end(), checks.begin(), checks.end());
        step.check_end = static_cast<std::uint32_t>(arguments.size());
        return step;
    }

    void finish_row_step(const JoinPlan::Step& step, const BodyAtom& atom) {
        plan_.steps_.push_back(step);
        for (std::uint32_t i = step.bind; i < step.bind_end; i += 2) {
            const auto column = static_cast<std::size_t>(plan_.arguments_[i]);
            const auto variable = static_cast<std::uint32_t>(plan_.arguments_[i + 1]);
            bind(variable);
            if (!relations_.column_within(atom.relation, column, types_[variable])) add_type_check(variable);
        }
    }

    void add_atom(std::size_t number) {
        const BodyAtom& atom = body_.atoms[number];
        std::vector<std::uint32_t> columns;
        std::vector<Term> key;
        for (std::size_t c = 0; c < atom.terms.size(); ++c) {
            if (!known(atom.terms[c])) continue;
            columns.push_back(static_cast<std::uint32_t>(c));
            key.push_back(atom.terms[c]);
        }
        JoinPlan::Step step =
            row_step(columns.empty() ? JoinPlan::Kind::scan : JoinPlan::Kind::probe, atom, true);
        step.before_trigger = before_trigger(number);
        if (!columns.empty()) {
            step.index = relations_[atom.relation].index_on(columns);
            add_key(step, key);
        }
        done_[number] = true;
        finish_row_step(step, atom);
    }

    bool add_enumeration() {
        std::size_t best = kNone;
        for (std::size_t v = 0; v < types_.size(); ++v) {
            if (bound_[v] || !wanted(v)) continue;
            if (best == kNone || objects_of(v) < objects_of(best)) best = v;
        }
        if (best == kNone) return false;
        JoinPlan::Step step;
        step.kind = JoinPlan::Kind::each;
        step.left = static_cast<std::int32_t>(best);
        step.type = types_[best];
        plan_.steps_.push_back(step);
        bind(static_cast<std::uint32_t>(best));
        return true;
    }

    std::size_t objects_of(std::size_t variable) const {
        return relations_.task().types[types_[variable].index()].objects.size();
    }

    bool wanted(std::size_t variable) const {
        if (start_.needed[variable]) return true;
        const auto mentions = [&](Term term) {
            return term.is_variable() && term.variable_index() == variable;
        };
        for (std::size_t i = 0; i < body_.equal.size(); ++i)
            if (!equal_done_[i] && (mentions(body_.equal[i].first) || mentions(body_.equal[i].second)))
                return true;
        for (std::size_t i = 0; i < body_.unequal.size(); ++i)
            if (!unequal_done_[i] && (mentions(body_.unequal[i].first) || mentions(body_.unequal[i].second)))
                return true;
        for (std::size_t i = 0; i < body_.atoms.size(); ++i)
            if (!done_[i] && std::any_of(body_.atoms[i].terms.begin(), body_.atoms[i].terms.end(), mentions))
                return true;
        return false;
    }

    JoinPlan& plan_;
    Relations& relations_;
    const Body& body_;
    const std::vector<TypeId>& types_;
    const JoinPlan::Start& start_;
    std::vector<bool> bound_;
    std::vector<bool> done_;
    std::vector<bool> equal_done_;
    std::vector<bool> unequal_done_;
};

JoinPlan::JoinPlan(Relations& relations, const Body& body, const std::vector<TypeId>& variable_types,
                   const Start& start) {
    JoinPlanner(*this, relations, body, variable_types, start).make();
}

}  // namespace praxis::grounding
