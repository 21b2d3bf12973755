// Conditions of the lifted contingent task, looked up in the ground one.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "belief/ground/dnf.hpp"
#include "parser/contingent.hpp"
#include "search/atom_index.hpp"

namespace praxis::belief {

/// What the ground task says about an atom.
struct Place {
    enum class Kind { fact, always, never };
    Kind kind = Kind::never;
    Fact fact;
};

/// Values of ground variables where they are known; kOpen elsewhere.
using Context = std::vector<std::int32_t>;
inline constexpr std::int32_t kOpen = -1;

class Conditions {
  public:
    /// Objects for the variables of a scope; invalid: not bound yet.
    using Binding = std::vector<ObjectId>;
    enum class Verdict : std::uint8_t { fails, open, holds };

    Conditions(std::shared_ptr<const ContingentTask> source, std::shared_ptr<const FiniteDomainTask> ground,
               std::shared_ptr<const AtomIndex> atoms);

    Place place(PredicateId predicate, std::span<const ObjectId> arguments) const;
    /// Throws UnsupportedError for the negation of an atom that is one of several values.
    Place place(const GroundLiteral& literal) const;

    /// Whether a formula holds where `context` is all that is known; also with unbound variables.
    Verdict verdict(const Formula& formula, const Scope& scope, const Binding& binding,
                    const Context& context) const;
    /// The formula's condition on what the context leaves open. Throws UnsupportedError for derived atoms,
    /// and DnfTooLarge.
    Dnf dnf(const Formula& formula, const Scope& scope, const Binding& binding, const Context& context,
            bool negated = false) const;

    /// Calls visit(binding) for every choice of objects for `variables` for which the condition may hold.
    template <class Visit>
    void instances(const std::vector<std::uint32_t>& variables, const Formula& condition, const Scope& scope,
                   Binding& binding, const Context& context, const Visit& visit) const;

    static std::vector<ObjectId> resolve(const std::vector<Term>& terms, const Binding& binding);
    /// A binding of the first variables to these objects.
    static Binding bind(const Scope& scope, std::span<const ObjectId> arguments);

    /// Nothing is known.
    Context open() const { return Context(ground_->variable_count(), kOpen); }
    const std::vector<std::int32_t>& sizes() const { return ground_->domain_sizes; }
    [[noreturn]] void refuse(Location where, std::string message) const;

  private:
    template <class Visit>
    void instances(const std::vector<std::uint32_t>& variables, std::size_t next, const Formula& condition,
                   const Scope& scope, Binding& binding, const Context& context, const Visit& visit) const;
    const std::vector<ObjectId>& objects(const Scope& scope, std::uint32_t variable) const {
        return source_->task->types[scope.variable_types[variable].index()].objects;
    }

    std::shared_ptr<const ContingentTask> source_;
    std::shared_ptr<const FiniteDomainTask> ground_;
    std::shared_ptr<const AtomIndex> atoms_;
};

template <class Visit>
void Conditions::instances(const std::vector<std::uint32_t>& variables, const Formula& condition,
                           const Scope& scope, Binding& binding, const Context& context,
                           const Visit& visit) const {
    instances(variables, 0, condition, scope, binding, context, visit);
}

template <class Visit>
void Conditions::instances(const std::vector<std::uint32_t>& variables, std::size_t next,
                           const Formula& condition, const Scope& scope, Binding& binding,
                           const Context& context, const Visit& visit) const {
    if (verdict(condition, scope, binding, context) == Verdict::fails) return;
    if (next == variables.size()) return visit(binding);
    const std::uint32_t variable = variables[next];
    for (ObjectId object : objects(scope, variable)) {
        binding[variable] = object;
        instances(variables, next + 1, condition, scope, binding, context, visit);
    }
    binding[variable] = ObjectId();
}

}  // namespace praxis::belief
