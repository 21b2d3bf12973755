#include "search/ground/invariants.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <set>
#include <unordered_set>
#include <utility>

namespace praxis::grounding {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kMostCandidates = 100'000;
constexpr std::size_t kMostSteps = 2'000'000'000;
constexpr std::size_t kStepsPerCandidate = 200;
constexpr std::size_t kMostRejecters = 64;

/// One predicate of a candidate: parameter i stands in column columns[i].
struct Part {
    std::uint32_t predicate;
    std::vector<std::uint32_t> columns;
    friend auto operator<=>(const Part&, const Part&) = default;
};

/// Sorted by predicate; parameters in the order of the first part's columns.
using Candidate = std::vector<Part>;

Candidate canonical(Candidate candidate) {
    std::sort(candidate.begin(), candidate.end());
    const std::vector<std::uint32_t> first = candidate.front().columns;
    std::vector<std::size_t> order(first.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return first[a] < first[b]; });
    for (Part& part : candidate) {
        const std::vector<std::uint32_t> old = part.columns;
        for (std::size_t i = 0; i < order.size(); ++i) part.columns[i] = old[order[i]];
    }
    return candidate;
}

/// Two candidates with one fingerprint (hardly ever) would cost one of them, never a wrong group.
std::uint64_t fingerprint(const Candidate& candidate) {
    std::uint64_t hash = 0x9e3779b97f4a7c15ULL;
    const auto mix = [&](std::uint64_t value) {
        hash = (hash ^ value) * 0xff51afd7ed558ccdULL;
        hash ^= hash >> 32;
    };
    for (const Part& part : candidate) {
        mix(part.predicate + (std::uint64_t{1} << 32));
        for (std::uint32_t column : part.columns) mix(column);
    }
    return hash;
}

class Search {
  public:
    Search(const PropositionTask& task, const Relations& relations, const Budget& budget)
        : task_(task), relations_(relations), budget_(budget) {
        predicate_of_.resize(task.auxiliary_begin());
        for (std::uint32_t p = 0; p + 1 < task.first_atom.size(); ++p)
            std::fill(predicate_of_.begin() + task.first_atom[p],
                      predicate_of_.begin() + task.first_atom[p + 1], p);
        part_of_.assign(task.first_atom.size(), kNone);
        index_operators();
    }

    MutexGroups run() {
        std::deque<Candidate> queue;
        const auto enqueue = [&](Candidate candidate) {
            candidate = canonical(std::move(candidate));
            if (seen_.size() < kMostCandidates && seen_.insert(fingerprint(candidate)).second)
                queue.push_back(std::move(candidate));
        };
        for (std::uint32_t p = 0; p + 1 < task_.first_atom.size(); ++p) {
            if (task_.first_atom[p] == task_.first_atom[p + 1] || task_.derived[task_.first_atom[p]])
                continue;
            const std::uint32_t arity = relations_[p].arity();
            for (std::uint32_t counted = 0; counted <= arity; ++counted) {
                Part part{p, {}};
                for (std::uint32_t c = 0; c < arity; ++c)
                    if (c != counted) part.columns.push_back(c);
                enqueue({std::move(part)});
            }
        }
        std::vector<Candidate> accepted;
        while (!queue.empty()) {
            if (steps_ > kMostSteps || budget_.exhausted() != Stop::none || seen_.size() >= kMostCandidates) {
                result_.left = queue.size();
                break;
            }
            const Candidate candidate = std::move(queue.front());
            queue.pop_front();
            ++result_.candidates;
            steps_ += kStepsPerCandidate;
            std::vector<Candidate> extensions;
            if (balanced(candidate, extensions)) accepted.push_back(candidate);
            for (Candidate& extension : extensions) enqueue(std::move(extension));
        }
        for (const Candidate& candidate : accepted) instantiate(candidate);
        result_.invariants = accepted.size();
        return std::move(result_);
    }

  private:
    /// An atom of the candidate with the row that holds its arguments.
    struct Covered {
        AtomId atom;
        const Part* part;
        const Object* row;
        std::uint32_t condition;
    };

    void index_operators() {
        std::vector<std::uint32_t> count(task_.first_atom.size() + 1, 0);
        const auto visit = [&](auto&& use) {
            std::vector<std::uint32_t> predicates;
            for (std::size_t o = 0; o < task_.operator_count(); ++o) {
                predicates.clear();
                for (const PropositionEffect& effect : task_.effects[o])
                    if (!is_negative(effect.literal))
                        predicates.push_back(predicate_of_[atom_of(effect.literal)]);
                std::sort(predicates.begin(), predicates.end());
                predicates.erase(std::unique(predicates.begin(), predicates.end()), predicates.end());
                for (std::uint32_t predicate : predicates) use(predicate, static_cast<std::uint32_t>(o));
            }
        };
        visit([&](std::uint32_t predicate, std::uint32_t) { ++count[predicate + 1]; });
        for (std::size_t p = 1; p < count.size(); ++p) count[p] += count[p - 1];
        adders_begin_ = count;
        adders_.resize(count.back());
        visit([&](std::uint32_t predicate, std::uint32_t o) { adders_[count[predicate]++] = o; });
        // Candidates mostly fail by schema, so one operator of each schema is looked at before the others.
        for (std::size_t p = 0; p + 1 < adders_begin_.size(); ++p) {
            std::set<std::uint32_t> met;
            std::size_t front = adders_begin_[p];
            for (std::size_t i = front; i < adders_begin_[p + 1]; ++i)
                if (met.insert(task_.schemas[adders_[i]]).second) std::swap(adders_[front++], adders_[i]);
        }
    }

    std::optional<Covered> cover(AtomId atom, std::uint32_t condition) const {
        if (atom >= predicate_of_.size()) return std::nullopt;
        const std::uint32_t predicate = predicate_of_[atom];
        if (part_of_[predicate] == kNone) return std::nullopt;
        return Covered{atom, &(*current_)[part_of_[predicate]],
                       relations_[predicate].row(atom - task_.first_atom[predicate]), condition};
    }

    static bool same_weight(const Covered& a, const Covered& b) {
        for (std::size_t i = 0; i < a.part->columns.size(); ++i)
            if (a.row[a.part->columns[i]] != b.row[b.part->columns[i]]) return false;
        return true;
    }

    bool balanced(const Candidate& candidate, std::vector<Candidate>& extensions) {
        current_ = &candidate;
        for (std::uint32_t i = 0; i < candidate.size(); ++i) part_of_[candidate[i].predicate] = i;
        bool result = true;
        // Of the known rejecters the one that suggests fewest extensions keeps the search narrow.
        std::vector<Candidate> fewer;
        for (std::size_t i = 0; i < rejecters_.size() && (result || !extensions.empty()); ++i) {
            fewer.clear();
            if (balanced(rejecters_[i], fewer)) continue;
            if (result || fewer.size() < extensions.size()) extensions.swap(fewer);
            result = false;
            if (extensions.empty()) std::swap(rejecters_[i], rejecters_[i / 2]);
        }
        for (std::size_t i = 0; i < candidate.size() && result; ++i) {
            const std::uint32_t predicate = candidate[i].predicate;
            for (std::uint32_t a = adders_begin_[predicate]; a < adders_begin_[predicate + 1] && result;
                 ++a) {
                if ((a & 4095) == 4095 && budget_.exhausted() != Stop::none) {
                    result = false;
                    break;
                }
                result = balanced(adders_[a], extensions);
                if (!result) remember(adders_[a]);
            }
        }
        for (const Part& part : candidate) part_of_[part.predicate] = kNone;
        return result;
    }

    /// What rejects one candidate often rejects the next, so it is looked at first.
    void remember(std::uint32_t o) {
        if (rejecters_.size() < kMostRejecters)
            rejecters_.push_back(o);
        else
            rejecters_[kMostRejecters / 2 + next_rejecter_++ % (kMostRejecters / 2)] = o;
    }

    bool balanced(std::uint32_t o, std::vector<Candidate>& extensions) {
        adds_.clear();
        deletes_.clear();
        for (const PropositionEffect& effect : task_.effects[o]) {
            ++steps_;
            if (const auto covered = cover(atom_of(effect.literal), effect.condition))
                (is_negative(effect.literal) ? deletes_ : adds_).push_back(*covered);
        }
        if (adds_.empty()) return true;
        collect_required(task_.preconditions[o], required_);
        for (std::size_t a = 0; a < adds_.size(); ++a) {
            const Covered& add = adds_[a];
            for (std::size_t b = 0; b < a; ++b)
                if (adds_[b].atom != add.atom && same_weight(adds_[b], add) && !exclusive(adds_[b], add))
                    return false;
            if (!covered_by_delete(o, add)) {
                extend(o, add, extensions);
                return false;
            }
        }
        return true;
    }

    void collect_required(std::span<const Literal> literals, std::vector<Covered>& result) const {
        result.clear();
        for (Literal literal : literals)
            if (!is_negative(literal))
                if (const auto covered = cover(atom_of(literal), 0)) result.push_back(*covered);
    }

    /// Two different atoms of the add's weight: what requires both never happens where the weight is at most
    /// one.
    static bool contradictory(const std::vector<Covered>& required, const std::vector<Covered>& more,
                              const Covered& add) {
        const Covered* met = nullptr;
        for (const auto* list : {&required, &more})
            for (const Covered& atom : *list) {
                if (!same_weight(atom, add)) continue;
                if (met != nullptr && met->atom != atom.atom) return true;
                met = &atom;
            }
        return false;
    }

    /// Two conditional adds that cannot both happen.
    bool exclusive(const Covered& a, const Covered& b) {
        if (a.condition == 0 || b.condition == 0) return false;
        for (Literal literal : task_.conditions[a.condition])
            for (Literal other : task_.conditions[b.condition])
                if (literal == opposite(other)) return true;
        collect_required(task_.conditions[a.condition], extra_);
        std::vector<Covered> others;
        collect_required(task_.conditions[b.condition], others);
        return contradictory(extra_, others, a);
    }

    /// The condition contains an atom of the add's weight, which goes away (or is the added atom itself).
    bool covered_by_delete(std::uint32_t o, const Covered& add) {
        const auto goes = [&](const Covered& atom) {
            if (!same_weight(atom, add)) return false;
            if (atom.atom == add.atom) return true;
            return std::any_of(deletes_.begin(), deletes_.end(), [&](const Covered& deleted) {
                return deleted.atom == atom.atom && happens(o, deleted.condition, add.condition);
            });
        };
        if (std::any_of(required_.begin(), required_.end(), goes)) return true;
        extra_.clear();
        if (add.condition != 0) collect_required(task_.conditions[add.condition], extra_);
        if (std::any_of(extra_.begin(), extra_.end(), goes)) return true;
        return contradictory(required_, extra_, add);
    }

    /// An effect with condition `condition` happens whenever the operator's effect with condition `given`
    /// does.
    bool happens(std::uint32_t o, std::uint32_t condition, std::uint32_t given) const {
        if (condition == 0 || condition == given) return true;
        const auto precondition = task_.preconditions[o];
        const auto more = task_.conditions[given];
        const auto wanted = task_.conditions[condition];
        return std::all_of(wanted.begin(), wanted.end(), [&](Literal literal) {
            return std::binary_search(precondition.begin(), precondition.end(), literal) ||
                   std::binary_search(more.begin(), more.end(), literal);
        });
    }

    /// Candidates with one more part, such that a delete of the operator balances the add.
    void extend(std::uint32_t o, const Covered& add, std::vector<Candidate>& extensions) {
        const auto precondition = task_.preconditions[o];
        const auto more = task_.conditions[add.condition];
        for (const PropositionEffect& effect : task_.effects[o]) {
            ++steps_;
            const AtomId atom = atom_of(effect.literal);
            if (!is_negative(effect.literal) || atom >= predicate_of_.size()) continue;
            const std::uint32_t predicate = predicate_of_[atom];
            if (part_of_[predicate] != kNone || !happens(o, effect.condition, add.condition)) continue;
            if (!std::binary_search(precondition.begin(), precondition.end(), positive(atom)) &&
                !std::binary_search(more.begin(), more.end(), positive(atom)))
                continue;
            const std::uint32_t arity = relations_[predicate].arity();
            const std::size_t parameters = add.part->columns.size();
            if (arity != parameters && arity != parameters + 1) continue;
            Part part{predicate, {}};
            match(add, relations_[predicate].row(atom - task_.first_atom[predicate]), arity, part,
                  extensions);
        }
    }

    /// Every way to assign different columns with the right objects to the parameters.
    void match(const Covered& add, const Object* row, std::uint32_t arity, Part& part,
               std::vector<Candidate>& extensions) {
        const std::size_t parameter = part.columns.size();
        if (parameter == add.part->columns.size()) {
            extensions.push_back(*current_);
            extensions.back().push_back(part);
            return;
        }
        for (std::uint32_t c = 0; c < arity; ++c) {
            ++steps_;
            if (row[c] != add.row[add.part->columns[parameter]] ||
                std::find(part.columns.begin(), part.columns.end(), c) != part.columns.end())
                continue;
            part.columns.push_back(c);
            match(add, row, arity, part, extensions);
            part.columns.pop_back();
        }
    }

    /// The atoms of each parameter tuple whose initial weight is one.
    void instantiate(const Candidate& candidate) {
        const std::size_t parameters = candidate.front().columns.size();
        const std::vector<ColumnRange> columns(parameters);
        TupleStore keys(columns, 0);
        std::vector<std::uint32_t> weight;
        std::vector<std::pair<std::uint32_t, AtomId>> members;
        std::vector<Object> key(parameters);
        for (const Part& part : candidate) {
            for (AtomId atom = task_.first_atom[part.predicate]; atom < task_.first_atom[part.predicate + 1];
                 ++atom) {
                const Object* row = relations_[part.predicate].row(atom - task_.first_atom[part.predicate]);
                for (std::size_t i = 0; i < parameters; ++i) key[i] = row[part.columns[i]];
                const auto [number, fresh] = keys.insert(key.data());
                if (fresh) weight.push_back(0);
                weight[number] += task_.initial[atom];
                if (!task_.constant[atom]) members.emplace_back(number, atom);
            }
        }
        std::sort(members.begin(), members.end());
        for (std::size_t begin = 0; begin < members.size();) {
            std::size_t end = begin;
            while (end < members.size() && members[end].first == members[begin].first) ++end;
            if (end - begin > 1 && weight[members[begin].first] == 1) {
                for (std::size_t i = begin; i < end; ++i) result_.groups.add(members[i].second);
                result_.groups.close();
            }
            begin = end;
        }
    }

    const PropositionTask& task_;
    const Relations& relations_;
    const Budget& budget_;
    std::vector<std::uint32_t> predicate_of_;  ///< by atom
    std::vector<std::uint32_t> adders_begin_;  ///< by predicate
    std::vector<std::uint32_t> adders_;        ///< operators that add an atom of the predicate
    std::vector<std::uint32_t> rejecters_;     ///< operators that were not balanced, useful ones first
    std::size_t next_rejecter_ = 0;
    std::unordered_set<std::uint64_t> seen_;  ///< fingerprints of candidates
    std::size_t steps_ = 0;
    MutexGroups result_;

    const Candidate* current_ = nullptr;
    std::vector<std::uint32_t> part_of_;  ///< by predicate: its part in the current candidate
    std::vector<Covered> adds_, deletes_, required_, extra_;
};

}  // namespace

MutexGroups find_mutex_groups(const PropositionTask& task, const Relations& relations, const Budget& budget) {
    return Search(task, relations, budget).run();
}

}  // namespace praxis::grounding
