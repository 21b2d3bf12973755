#include "parser/check/streams/monotone.hpp"

#include <set>
#include <tuple>

namespace praxis::check {
namespace {

class MonotoneCheck {
  public:
    MonotoneCheck(Context& context, const std::vector<bool>& certified)
        : context_(context), task_(context.task), certified_(certified) {}

    void run() {
        for (const Schema& schema : task_.schemas) {
            visit(schema.precondition, true, false);
            for (const Effect& effect : schema.effects) visit(effect.condition, true, true);
        }
        visit(task_.goal, true, false);
    }

  private:
    void visit(const Formula& formula, bool positive, bool in_effect) {
        const bool flips_first =
            formula.kind == Connective::negation || formula.kind == Connective::implication;
        if (formula.kind == Connective::atom) visit_atom(formula, positive, in_effect);
        for (std::size_t i = 0; i < formula.children.size(); ++i)
            visit(formula.children[i], i == 0 && flips_first ? !positive : positive, in_effect);
    }

    void visit_atom(const Formula& atom, bool positive, bool in_effect) {
        const std::string& name = task_.predicates[atom.predicate.index()].name;
        if (certified_[atom.predicate.index()]) {
            if (in_effect) {
                context_.reporter.error(atom.where,
                                        "an effect depends on " + quote(name) + ", which a stream certifies",
                                        "make two actions of it");
            } else if (!positive) {
                context_.reporter.error(
                    atom.where, "this must not hold, but " + quote(name) + " is certified by a stream",
                    "a stream can show that something holds, never that it does not; "
                    "certify the contrary");
            }
        }
        if (!seen_.insert({atom.predicate.index(), positive, in_effect}).second) return;
        for (const Axiom& axiom : task_.axioms)
            if (axiom.predicate == atom.predicate) visit(axiom.body, positive, in_effect);
    }

    Context& context_;
    const LiftedTask& task_;
    const std::vector<bool>& certified_;
    std::set<std::tuple<std::uint32_t, bool, bool>> seen_;
};

}  // namespace

void check_monotone(Context& context, const std::vector<bool>& certified) {
    MonotoneCheck(context, certified).run();
}

}  // namespace praxis::check
