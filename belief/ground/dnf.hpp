// Conditions on ground states in disjunctive normal form.
//
// A *term* is a conjunction of facts; a Dnf holds where one of its terms does. No term contains another one,
// so that conditions that are built in the same way compare equal whatever the order.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <stdexcept>
#include <vector>

#include "search/task/finite_domain_task.hpp"

namespace praxis::belief {

/// A condition has more terms than anything could be planned with.
struct DnfTooLarge : std::length_error {
    DnfTooLarge() : std::length_error("a condition with too many cases") {}
};

class Dnf {
  public:
    using Term = std::vector<Fact>;  ///< sorted by variable, one fact a variable at most

    static Dnf never() { return {}; }
    static Dnf always();
    /// A conjunction of facts.
    static Dnf of(std::span<const Fact> facts);
    static Dnf of(Fact fact) { return of(std::span<const Fact>(&fact, 1)); }

    bool is_never() const { return terms_.empty(); }
    bool is_always() const { return terms_.size() == 1 && terms_.begin()->empty(); }
    const std::set<Term>& terms() const { return terms_; }
    /// In a state, given by variable.
    bool holds(const std::int32_t* values) const;

    friend auto operator<=>(const Dnf&, const Dnf&) = default;

  private:
    friend Dnf operator|(const Dnf& a, const Dnf& b);
    friend Dnf operator&(const Dnf& a, const Dnf& b);
    friend Dnf given(const Dnf& condition, const std::vector<std::int32_t>& values);
    void add(Term term);

    std::set<Term> terms_;
};

/// Both throw DnfTooLarge.
Dnf operator|(const Dnf& a, const Dnf& b);
Dnf operator&(const Dnf& a, const Dnf& b);

/// Where the condition does not hold; `sizes`: of the domains, by variable. Throws DnfTooLarge.
Dnf negation(const Dnf& condition, const std::vector<std::int32_t>& sizes);

/// What is left of the condition where these values, by variable, are known; -1: not known.
Dnf given(const Dnf& condition, const std::vector<std::int32_t>& values);

}  // namespace praxis::belief
