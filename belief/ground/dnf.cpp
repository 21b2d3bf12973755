#include "belief/ground/dnf.hpp"

#include <algorithm>
#include <utility>

namespace praxis::belief {
namespace {

constexpr std::size_t kMostTerms = 4'096;
/// Larger conditions may have terms that contain others.
constexpr std::size_t kMostCompared = 256;

bool contains(const Dnf::Term& larger, const Dnf::Term& smaller) {
    return std::includes(larger.begin(), larger.end(), smaller.begin(), smaller.end());
}

/// False if the facts exclude each other.
bool join(Dnf::Term& term, const Dnf::Term& other) {
    Dnf::Term all;
    std::set_union(term.begin(), term.end(), other.begin(), other.end(), std::back_inserter(all));
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i - 1].variable == all[i].variable) return false;
    term = std::move(all);
    return true;
}

}  // namespace

Dnf Dnf::always() {
    Dnf result;
    result.terms_.insert(Term{});
    return result;
}

Dnf Dnf::of(std::span<const Fact> facts) {
    Dnf result;
    Term term;
    for (const Fact& fact : facts)
        if (!join(term, {fact})) return result;
    result.terms_.insert(std::move(term));
    return result;
}

bool Dnf::holds(const std::int32_t* values) const {
    return std::any_of(terms_.begin(), terms_.end(),
                       [&](const Term& term) { return all_hold(term, values); });
}

void Dnf::add(Term term) {
    if (terms_.size() < kMostCompared) {
        if (std::any_of(terms_.begin(), terms_.end(),
                        [&](const Term& other) { return contains(term, other); }))
            return;
        std::erase_if(terms_, [&](const Term& other) { return contains(other, term); });
    }
    terms_.insert(std::move(term));
    if (terms_.size() > kMostTerms) throw DnfTooLarge();
}

Dnf operator|(const Dnf& a, const Dnf& b) {
    Dnf result = a;
    for (const Dnf::Term& term : b.terms_) result.add(term);
    return result;
}

Dnf operator&(const Dnf& a, const Dnf& b) {
    Dnf result;
    for (const Dnf::Term& left : a.terms_) {
        for (const Dnf::Term& right : b.terms_) {
            Dnf::Term term = left;
            if (join(term, right)) result.add(std::move(term));
        }
    }
    return result;
}

Dnf negation(const Dnf& condition, const std::vector<std::int32_t>& sizes) {
    Dnf result = Dnf::always();
    for (const Dnf::Term& term : condition.terms()) {
        Dnf fails;
        for (const Fact& fact : term)
            for (std::int32_t value = 0; value < sizes[static_cast<std::size_t>(fact.variable)]; ++value)
                if (value != fact.value) fails = fails | Dnf::of({fact.variable, value});
        result = result & fails;
    }
    return result;
}

Dnf given(const Dnf& condition, const std::vector<std::int32_t>& values) {
    Dnf result;
    for (const Dnf::Term& term : condition.terms()) {
        Dnf::Term open;
        bool possible = true;
        for (const Fact& fact : term) {
            const std::int32_t value = values[static_cast<std::size_t>(fact.variable)];
            possible = possible && (value < 0 || value == fact.value);
            if (value < 0) open.push_back(fact);
        }
        if (possible) result.add(std::move(open));
    }
    return result;
}

}  // namespace praxis::belief
