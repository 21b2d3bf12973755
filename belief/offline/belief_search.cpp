#include "belief/offline/belief_search.hpp"

#include <algorithm>
#include <utility>

namespace praxis::belief {
namespace {

constexpr std::int64_t kUnreachable = StateGraph::kUnreachable;
constexpr std::size_t kMostMembers = 100'000'000;  // 800 MB

}  // namespace

std::size_t BeliefSearch::Hash::operator()(BeliefIndex belief) const {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const Member& member : search->members(belief)) {
        hash = (hash ^ member.state) * 0x9e3779b97f4a7c15ULL;
        hash = (hash ^ (hash >> 31) ^ member.worlds) * 0xff51afd7ed558ccdULL;
    }
    return static_cast<std::size_t>(hash ^ (hash >> 32));
}

bool BeliefSearch::Equal::operator()(BeliefIndex a, BeliefIndex b) const {
    const auto left = search->members(a), right = search->members(b);
    return std::equal(left.begin(), left.end(), right.begin(), right.end());
}

BeliefSearch::BeliefSearch(const StateGraph& graph, const FiniteDomainTask& task, Criterion criterion,
                           std::size_t most_beliefs, const Budget& budget)
    : graph_(&graph),
      task_(&task),
      criterion_(criterion),
      most_beliefs_(most_beliefs),
      budget_(&budget),
      index_(16, Hash{this}, Equal{this}) {}

BeliefSearch::BeliefIndex BeliefSearch::add(std::vector<Member> members) {
    std::sort(members.begin(), members.end());
    const auto number = static_cast<BeliefIndex>(values_.size());
    for (const Member& member : members) {
        if (members_.size() > begin_.back() && members_.back().state == member.state) {
            if (criterion_ == Criterion::expected_cost) members_.back().worlds += member.worlds;
        } else {
            members_.push_back(member);
        }
    }
    begin_.push_back(static_cast<std::uint32_t>(members_.size()));
    const auto [place, fresh] = index_.insert(number);
    if (fresh) {
        values_.push_back({estimate(this->members(number))});
    } else {
        begin_.pop_back();
        members_.resize(begin_.back());
    }
    return *place;
}

bool BeliefSearch::goal(BeliefIndex belief) const {
    const auto all = members(belief);
    return std::all_of(all.begin(), all.end(),
                       [&](const Member& member) { return graph_->goal(member.state); });
}

std::int64_t BeliefSearch::estimate(std::span<const Member> members) const {
    std::int64_t result = 0;
    for (const Member& member : members) {
        const std::int64_t distance = graph_->distance(member.state);
        if (distance >= kUnreachable) return kUnreachable;
        result = criterion_ == Criterion::expected_cost ? result + distance * member.worlds
                                                        : std::max(result, distance);
    }
    return result;
}

std::int64_t BeliefSearch::price(std::uint32_t action, BeliefIndex belief) const {
    const std::int64_t cost = task_->costs[action];
    if (criterion_ == Criterion::worst_cost) return cost;
    std::int64_t worlds = 0;
    for (const Member& member : members(belief)) worlds += member.worlds;
    return cost * worlds;
}

std::int64_t BeliefSearch::lower(const Exit& exit) const {
    std::int64_t result = 0;
    for (const Part& part : exit.parts) {
        const std::int64_t value = values_[part.belief].lower;
        if (value >= kUnreachable) return kUnreachable;
        result = criterion_ == Criterion::expected_cost ? result + value : std::max(result, value);
    }
    return result + exit.cost;
}

bool BeliefSearch::apply(BeliefIndex belief, std::uint32_t action, std::vector<Part>& parts) {
    successors_.clear();
    for (const Member& member : members(belief)) {
        const auto steps = graph_->steps(member.state);
        const auto step =
            std::lower_bound(steps.begin(), steps.end(), action,
                             [](const StateGraph::Step& a, std::uint32_t b) { return a.action < b; });
        if (step == steps.end() || step->action != action) return false;
        successors_.push_back({step->observation, {step->target, member.worlds}});
    }
    std::sort(successors_.begin(), successors_.end());
    parts.clear();
    for (std::size_t i = 0; i < successors_.size();) {
        const std::uint32_t observation = successors_[i].first;
        std::vector<Member> part;
        for (; i < successors_.size() && successors_[i].first == observation; ++i)
            part.push_back(successors_[i].second);
        parts.push_back({observation, add(std::move(part))});
    }
    return true;
}

void BeliefSearch::expand(Level& level, BeliefIndex belief, std::int64_t cost) {
    const auto all = members(belief);
    const Member first = *std::min_element(all.begin(), all.end(), [&](const Member& a, const Member& b) {
        return graph_->steps(a.state).size() < graph_->steps(b.state).size();
    });
    for (const StateGraph::Step& step : graph_->steps(first.state)) {
        if (!apply(belief, step.action, parts_)) continue;
        const std::int64_t after = cost + price(step.action, belief);
        if (parts_.size() > 1) {
            Exit exit{belief, step.action, after, parts_};
            const std::int64_t bound = lower(exit);
            if (bound >= kUnreachable) continue;
            level.open.push({bound, after, belief, static_cast<std::uint32_t>(level.exits.size())});
            level.exits.push_back(std::move(exit));
            continue;
        }
        const BeliefIndex target = parts_.front().belief;
        const std::int64_t rest = values_[target].lower;
        if (rest >= kUnreachable) continue;
        const auto [place, fresh] = level.reached.try_emplace(target);
        if (!fresh && place->second.cost <= after) continue;
        place->second = {after, belief, step.action, false};
        level.open.push({after + rest, after, target, kNone});
    }
}

bool BeliefSearch::exhausted() {
    stopped_ = stopped_ || values_.size() > most_beliefs_ || members_.size() > kMostMembers ||
               budget_->exhausted() != Stop::none;
    return stopped_;
}

void BeliefSearch::advance(BeliefIndex root, std::int64_t limit) {
    std::unique_ptr<Level>& place = levels_[root];
    if (!place) {
        place = std::make_unique<Level>();
        place->open.push({values_[root].lower, 0, root, kNone});
        place->reached[root] = {};
    }
    Level& level = *place;
    while (!values_[root].solved && !exhausted()) {
        if (level.open.empty() || level.open.top().estimate >= kUnreachable) {
            values_[root] = {kUnreachable, true, kNone};
            levels_.erase(root);
            return;
        }
        const Item item = level.open.top();
        values_[root].lower = std::max(values_[root].lower, item.estimate);
        if (item.estimate > limit) return;
        level.open.pop();
        if (item.exit != kNone) {
            const std::int64_t bound = lower(level.exits[item.exit]);
            const auto& parts = level.exits[item.exit].parts;
            const bool exact = std::all_of(parts.begin(), parts.end(),
                                           [&](const Part& part) { return values_[part.belief].solved; });
            if (bound == item.estimate && exact) {
                solved(root, level, item.belief, item.estimate);
                return;
            }
            if (bound == item.estimate) {
                const std::int64_t other =
                    level.open.empty() ? limit : std::min(limit, level.open.top().estimate);
                advance_part(level.exits[item.exit], std::max(other, bound) - bound);
            }
            const std::int64_t better = lower(level.exits[item.exit]);
            if (better < kUnreachable) level.open.push({better, item.cost, item.belief, item.exit});
            continue;
        }
        Reached& reached = level.reached[item.belief];
        if (reached.expanded || item.cost > reached.cost) continue;
        const Value& value = values_[item.belief];
        if (value.lower >= kUnreachable) continue;
        if (item.cost + value.lower > item.estimate) {
            level.open.push({item.cost + value.lower, item.cost, item.belief, kNone});
            continue;
        }
        // Solved in a level that began elsewhere, or the goal, where nothing is left to do.
        if (value.solved || goal(item.belief)) {
            solved(root, level, item.belief, item.estimate);
            return;
        }
        reached.expanded = true;
        expand(level, item.belief, item.cost);
    }
}

/// Resumes the search of a part that is not solved, until the exit's bound is known to have grown by more
/// than `slack`.
void BeliefSearch::advance_part(const Exit& exit, std::int64_t slack) {
    for (const Part& part : exit.parts) {
        if (values_[part.belief].solved) continue;
        const std::int64_t own = values_[part.belief].lower;
        const std::int64_t limit =
            criterion_ == Criterion::expected_cost ? own + slack : lower(exit) - exit.cost + slack;
        advance(part.belief, limit);
        return;
    }
}

/// The best way from the root leads to `last`, and from there on by an exit, a policy that is known, or not
/// at all (the goal).
void BeliefSearch::solved(BeliefIndex root, Level& level, BeliefIndex last, std::int64_t cost) {
    const bool by_exit = !values_[last].solved && !goal(last);
    if (!values_[last].solved) {
        std::uint32_t action = kNone;
        if (by_exit) {
            for (const Exit& exit : level.exits)
                if (exit.from == last && lower(exit) == cost &&
                    std::all_of(exit.parts.begin(), exit.parts.end(),
                                [&](const Part& part) { return values_[part.belief].solved; })) {
                    action = exit.action;
                    break;
                }
        }
        values_[last] = {cost - level.reached[last].cost, true, action};
    }
    for (BeliefIndex belief = last; belief != root;) {
        const Reached& reached = level.reached[belief];
        // What is solved already keeps its action: otherwise two actions without cost might point at each
        // other.
        if (!values_[reached.parent].solved)
            values_[reached.parent] = {cost - level.reached[reached.parent].cost, true, reached.action};
        belief = reached.parent;
    }
    levels_.erase(root);
}

std::optional<std::int64_t> BeliefSearch::solve(BeliefIndex belief) {
    if (!values_[belief].solved) advance(belief, kUnreachable);
    if (!values_[belief].solved) return std::nullopt;
    return values_[belief].lower;
}

std::uint32_t BeliefSearch::write(BeliefIndex belief, PlanDraft& draft) {
    if (const auto place = written_.find(belief); place != written_.end()) return place->second;
    // Actions that keep the belief together make a chain; only parts are written by recursion.
    std::vector<std::pair<BeliefIndex, std::uint32_t>> chain;
    BeliefIndex at = belief;
    std::uint32_t node = draft.goal();
    std::vector<Part> parts;
    for (;;) {
        if (const auto place = written_.find(at); place != written_.end()) {
            node = place->second;
            break;
        }
        const std::uint32_t action = values_[at].action;
        if (action == kNone) break;
        apply(at, action, parts);
        if (parts.size() > 1) {
            std::vector<PlanDraft::Edge> edges;
            for (const Part& part : std::vector<Part>(parts))
                edges.push_back({graph_->observation(part.observation), write(part.belief, draft)});
            node = draft.add(action, edges);
            written_.emplace(at, node);
            break;
        }
        chain.emplace_back(at, action);
        at = parts.front().belief;
    }
    while (!chain.empty()) {
        node = draft.add(chain.back().second, {{{}, node}});
        written_.emplace(chain.back().first, node);
        chain.pop_back();
    }
    return node;
}

}  // namespace praxis::belief
