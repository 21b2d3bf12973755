// The type hierarchy and the objects in it.
#pragma once

#include "parser/check/context.hpp"

namespace praxis::check {

/// Declares the domain's types. A name that is used only as a supertype is declared by that, with a warning.
void declare_types(Context& context, const syntax::Tree& domain);

/// Declares constants (of a domain) or objects (of a problem): the names of these sections of its tree.
void declare_objects(Context& context, const syntax::Tree& tree, const std::vector<syntax::Range>& sections);

/// To be called after the last object: fills in Type::objects and Type::contains.
void collect_objects(Context& context);

/// The type that is written as `names`: `object` if none, an anonymous one if several (`either`).
/// Unknown names are reported and count as `object`.
TypeId resolve_type(Context& context, const syntax::Tree& tree, syntax::Range names);

/// Whether all objects of type `a` are objects of type `b`, by declaration.
bool is_subtype(const Context& context, TypeId a, TypeId b);

/// Whether some object belongs to both types. Objects must be known.
bool overlap(const Context& context, TypeId a, TypeId b);

}  // namespace praxis::check
