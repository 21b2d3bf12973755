#include "search/ground/mutex_pruning.hpp"

#include <algorithm>
#include <utility>

#include "search/ground/operator_rewriter.hpp"

namespace praxis::grounding {
namespace {

class Pruning {
  public:
    Pruning(PropositionTask& task, MutexGroups& groups) : task_(task), groups_(groups) {}

    void run() {
        index_groups();
        mark_impossible();
        reach();
        rewrite_operators();
        rewrite_axioms();
        rewrite_goal();
        rewrite_groups();
    }

  private:
    void index_groups() {
        std::vector<std::uint32_t> count(task_.atom_count + 1, 0);
        for (AtomId atom : groups_.groups.items()) ++count[atom + 1];
        for (std::size_t i = 1; i < count.size(); ++i) count[i] += count[i - 1];
        group_begin_ = count;
        groups_of_.resize(groups_.groups.total());
        for (std::size_t g = 0; g < groups_.groups.size(); ++g)
            for (AtomId atom : groups_.groups[g]) groups_of_[count[atom]++] = static_cast<std::uint32_t>(g);
        holder_.assign(groups_.groups.size(), kNobody);
    }

    /// Notes the groups that the positive literals occupy. False if two atoms share a group.
    bool occupy(std::span<const Literal> literals) {
        for (Literal literal : literals) {
            if (is_negative(literal)) continue;
            const AtomId atom = atom_of(literal);
            for (std::uint32_t i = group_begin_[atom]; i < group_begin_[atom + 1]; ++i) {
                AtomId& holder = holder_[groups_of_[i]];
                if (holder != kNobody && holder != atom) return false;
                if (holder == kNobody) occupied_.push_back(groups_of_[i]);
                holder = atom;
            }
        }
        return true;
    }
    void vacate() {
        for (std::uint32_t group : occupied_) holder_[group] = kNobody;
        occupied_.clear();
    }
    /// Some occupied group has another atom than this one.
    bool excluded(AtomId atom) const {
        for (std::uint32_t i = group_begin_[atom]; i < group_begin_[atom + 1]; ++i) {
            const AtomId holder = holder_[groups_of_[i]];
            if (holder != kNobody && holder != atom) return true;
        }
        return false;
    }

    void mark_impossible() {
        impossible_.assign(task_.operator_count(), false);
        for (std::size_t o = 0; o < task_.operator_count(); ++o) {
            impossible_[o] = !occupy(task_.preconditions[o]);
            any_impossible_ = any_impossible_ || impossible_[o];
            vacate();
        }
    }

    /// Relaxed reachability without the impossible operators (only if there are any: before, everything was
    /// reachable).
    void reach() {
        task_.never.assign(task_.atom_count, false);
        if (!any_impossible_) return;
        const std::size_t operators = task_.operator_count();
        std::vector<std::uint32_t> begin(task_.atom_count + 1, 0);
        std::vector<std::uint32_t> missing(operators + task_.heads.size(), 0);
        const auto each_list = [&](auto&& use) {
            for (std::size_t o = 0; o < operators; ++o)
                if (!impossible_[o]) use(o, task_.preconditions[o]);
            for (std::size_t a = 0; a < task_.heads.size(); ++a) use(operators + a, task_.bodies[a]);
        };
        each_list([&](std::size_t item, std::span<const Literal> literals) {
            for (Literal literal : literals) {
                if (is_negative(literal)) continue;
                ++begin[atom_of(literal) + 1];
                ++missing[item];
            }
        });
        for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
        std::vector<std::uint32_t> readers(begin.back());
        std::vector<std::uint32_t> fill(begin.begin(), begin.end() - 1);
        each_list([&](std::size_t item, std::span<const Literal> literals) {
            for (Literal literal : literals)
                if (!is_negative(literal))
                    readers[fill[atom_of(literal)]++] = static_cast<std::uint32_t>(item);
        });
        std::vector<bool> reached(task_.initial);
        std::vector<AtomId> queue;
        for (AtomId atom = 0; atom < task_.atom_count; ++atom)
            if (reached[atom]) queue.push_back(atom);
        const auto derive = [&](AtomId atom) {
            if (reached[atom]) return;
            reached[atom] = true;
            queue.push_back(atom);
        };
        const auto fire = [&](std::size_t item) {
            if (item >= operators) return derive(task_.heads[item - operators]);
            for (const PropositionEffect& effect : task_.effects[item])
                if (!is_negative(effect.literal)) derive(atom_of(effect.literal));
        };
        each_list([&](std::size_t item, std::span<const Literal>) {
            if (missing[item] == 0) fire(item);
        });
        for (std::size_t next = 0; next < queue.size(); ++next)
            for (std::uint32_t i = begin[queue[next]]; i < begin[queue[next] + 1]; ++i)
                if (--missing[readers[i]] == 0) fire(readers[i]);
        for (AtomId atom = 0; atom < task_.atom_count; ++atom) task_.never[atom] = !reached[atom];
    }

    /// The list without negations of atoms that never hold; false if it cannot hold.
    bool rewritten(std::span<const Literal> list, Conjunction& result) const {
        result.clear();
        for (Literal literal : list) {
            if (!task_.never[atom_of(literal)])
                result.push_back(literal);
            else if (!is_negative(literal))
                return false;
        }
        return true;
    }

    void rewrite_operators() {
        OperatorRewriter rewriter(task_);
        Conjunction precondition;
        Conjunction condition;
        std::vector<PropositionEffect> effects;
        for (std::size_t o = 0; o < task_.operator_count(); ++o) {
            if (impossible_[o] || !rewritten(task_.preconditions[o], precondition)) continue;
            occupy(precondition);
            effects.clear();
            for (PropositionEffect effect : task_.effects[o]) {
                const AtomId atom = atom_of(effect.literal);
                if (task_.never[atom] || (is_negative(effect.literal) && excluded(atom))) continue;
                if (effect.condition != 0) {
                    if (!rewritten(task_.conditions[effect.condition], condition) ||
                        contradicts_occupied(condition))
                        continue;
                    effect.condition = rewriter.condition(condition);
                }
                effects.push_back(effect);
            }
            vacate();
            if (!effects.empty()) rewriter.keep(o, precondition, effects);
        }
        rewriter.finish();
    }

    bool contradicts_occupied(const Conjunction& condition) const {
        return std::any_of(condition.begin(), condition.end(), [&](Literal literal) {
            return !is_negative(literal) && excluded(atom_of(literal));
        });
    }

    void rewrite_axioms() {
        std::vector<AtomId> heads;
        PackedLists<Literal> bodies;
        Conjunction body;
        for (std::size_t a = 0; a < task_.heads.size(); ++a) {
            const bool possible =
                !task_.never[task_.heads[a]] && rewritten(task_.bodies[a], body) && occupy(body);
            vacate();
            if (!possible) continue;
            heads.push_back(task_.heads[a]);
            bodies.append(body);
        }
        task_.heads = std::move(heads);
        task_.bodies = std::move(bodies);
    }

    void rewrite_goal() {
        Conjunction goal;
        task_.goal_reachable = task_.goal_reachable && rewritten(task_.goal, goal) && occupy(goal);
        vacate();
        task_.goal = std::move(goal);
    }

    void rewrite_groups() {
        PackedLists<AtomId> groups;
        std::vector<AtomId> kept;
        for (std::size_t g = 0; g < groups_.groups.size(); ++g) {
            kept.clear();
            for (AtomId atom : groups_.groups[g])
                if (!task_.never[atom]) kept.push_back(atom);
            if (kept.size() > 1) groups.append(kept);
        }
        groups_.groups = std::move(groups);
    }

    static constexpr AtomId kNobody = static_cast<AtomId>(-1);

    PropositionTask& task_;
    MutexGroups& groups_;
    std::vector<std::uint32_t> group_begin_;  ///< by atom, into groups_of_
    std::vector<std::uint32_t> groups_of_;
    std::vector<AtomId> holder_;  ///< by group: the atom that a condition requires
    std::vector<std::uint32_t> occupied_;
    std::vector<bool> impossible_;
    bool any_impossible_ = false;
};

}  // namespace

void prune_with_mutexes(PropositionTask& task, MutexGroups& groups) {
    Pruning(task, groups).run();
}

}  // namespace praxis::grounding
