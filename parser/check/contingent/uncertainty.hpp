// What is said about uncertain atoms: `unknown`, clauses and negative literals in `:init`; hidden worlds.
#pragma once

#include "parser/check/contingent/certainty.hpp"

namespace praxis::check {

/// Whether a node of the initial state is `(unknown ...)`, `(or ...)`, `(oneof ...)`, an invariant, ...; a
/// predicate of the domain with such a name comes first.
inline bool states_uncertainty(const Context& context, const syntax::Node& node) {
    using syntax::NodeKind;
    if (node.kind == NodeKind::disjunction) return true;
    const syntax::Symbol head = node.head.symbol;
    const bool word = head >= syntax::symbol_of(syntax::Word::unknown) &&
                      head <= syntax::symbol_of(syntax::Word::exactly_one);
    return word && !context.predicates[head].valid() &&
           (node.kind == NodeKind::nested || node.kind == NodeKind::atom);
}

/// Fills in `unknown`, `known_false` and `clauses`.
void check_uncertainty(Context& context, const syntax::Tree& problem);

/// Appends the hidden worlds of a problem or of a world file, and compares them with what is certain.
void check_hidden_worlds(Context& context, const syntax::Tree& tree, Certainty& certainty);

/// Warns of sections of a world file that do not belong there.
void check_world_file(Context& context, const syntax::Tree& world);

}  // namespace praxis::check
