#include "belief/ground/choices.hpp"

#include <algorithm>
#include <vector>

#include "belief/ground/dnf.hpp"

namespace praxis::belief {
namespace {

Fact opposite(Fact fact) {
    return {fact.variable, 1 - fact.value};
}

bool includes(const Dnf::Term& larger, const Dnf::Term& smaller) {
    return std::includes(larger.begin(), larger.end(), smaller.begin(), smaller.end());
}

class Checker {
  public:
    explicit Checker(std::span<const Fact> choice) : choice_(choice) {}

    bool keeps(const FiniteDomainTask& task, std::size_t o) {
        given_.clear();
        taken_.clear();
        for (const GroundEffect& effect : task.effects[o]) {
            // Where the effect happens: its condition and the precondition; not at all if they exclude each
            // other.
            std::vector<Fact> all(task.preconditions[o].begin(), task.preconditions[o].end());
            const auto condition = task.conditions[effect.condition];
            all.insert(all.end(), condition.begin(), condition.end());
            const Dnf when = Dnf::of(all);
            if (when.is_never()) continue;
            if (is_member(effect.fact)) given_.push_back({effect.fact, *when.terms().begin()});
            if (is_member(opposite(effect.fact)))
                taken_.push_back({opposite(effect.fact), *when.terms().begin()});
        }
        return std::all_of(taken_.begin(), taken_.end(),
                           [&](const Change& taken) { return replaced(taken); }) &&
               std::all_of(given_.begin(), given_.end(), [&](const Change& given) { return alone(given); });
    }

  private:
    struct Change {
        Fact fact;
        Dnf::Term when;
    };

    bool is_member(Fact fact) const {
        return std::find(choice_.begin(), choice_.end(), fact) != choice_.end();
    }
    /// The fact that holds before where the change happens, if the change says so.
    const Fact* source(const Change& change) const {
        const auto found = std::find_if(change.when.begin(), change.when.end(),
                                        [&](const Fact& fact) { return is_member(fact); });
        return found == change.when.end() ? nullptr : &*found;
    }
    static Dnf::Term with(const Change& change) {
        Dnf::Term when = change.when;
        if (std::find(when.begin(), when.end(), change.fact) == when.end()) when.push_back(change.fact);
        std::sort(when.begin(), when.end());
        return when;
    }

    bool replaced(const Change& taken) const {
        const Dnf::Term when = with(taken);
        return std::any_of(given_.begin(), given_.end(),
                           [&](const Change& given) { return includes(when, given.when); });
    }

    bool alone(const Change& given) const {
        for (const Change& other : given_)
            if (other.fact != given.fact && compatible(given, other)) return false;
        const Fact* from = source(given);
        if (from != nullptr) return *from == given.fact || takes(*from, given);
        return std::all_of(choice_.begin(), choice_.end(),
                           [&](const Fact& fact) { return fact == given.fact || takes(fact, given); });
    }
    bool compatible(const Change& a, const Change& b) const {
        const Fact *first = source(a), *second = source(b);
        if (first != nullptr && second != nullptr && *first != *second) return false;
        std::vector<Fact> both = a.when;
        both.insert(both.end(), b.when.begin(), b.when.end());
        return !Dnf::of(both).is_never();
    }
    /// The fact is taken away wherever the other one is given.
    bool takes(Fact fact, const Change& given) const {
        Dnf::Term when = given.when;
        when.push_back(fact);
        std::sort(when.begin(), when.end());
        when.erase(std::unique(when.begin(), when.end()), when.end());
        return std::any_of(taken_.begin(), taken_.end(), [&](const Change& taken) {
            return taken.fact == fact && includes(when, taken.when);
        });
    }

    std::span<const Fact> choice_;
    std::vector<Change> given_, taken_;
};

}  // namespace

std::optional<OperatorId> breaks_choice(const FiniteDomainTask& task, std::span<const Fact> choice) {
    Checker checker(choice);
    for (std::size_t o = 0; o < task.operator_count(); ++o)
        if (!checker.keeps(task, o)) return OperatorId(o);
    return std::nullopt;
}

}  // namespace praxis::belief
