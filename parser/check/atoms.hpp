// Predicates and functions applied to arguments, and the constructs that only look like that.
#pragma once

#include "parser/check/scope.hpp"

namespace praxis::check {

/// The predicate of a node of kind atom; a mistake is reported and gives an invalid id.
PredicateId resolve_predicate(Context& context, const syntax::Tree& tree, const syntax::Node& node);

/// The numeric function of a node of kind atom, likewise. Object fluents are refused.
FunctionId resolve_function(Context& context, const syntax::Tree& tree, const syntax::Node& node);

/// Resolves the arguments of an atom and checks their number and types. Empty if something is wrong.
std::optional<std::vector<Term>> resolve_arguments(ScopeBuilder& scope, const syntax::Node& node,
                                                   std::string_view kind,
                                                   const std::vector<TypeId>& parameters);

/// Reports that an atom has the wrong number of arguments.
void report_arity(Context& context, const syntax::Tree& tree, const syntax::Node& node, std::string_view kind,
                  const std::vector<TypeId>& parameters);

/// Says what a node of kind `nested` is: something unsupported, or a mistake.
void refuse_nested(Context& context, const syntax::Tree& tree, const syntax::Node& node);

}  // namespace praxis::check
