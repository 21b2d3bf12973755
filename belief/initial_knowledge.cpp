#include "belief/initial_knowledge.hpp"

#include <algorithm>
#include <utility>

namespace praxis::belief {
namespace {

/// Variables tried after one reading.
constexpr std::size_t kMostTries = 400;

}  // namespace

InitialKnowledge::InitialKnowledge(const BeliefTask& task, bool only_invariants,
                                   std::vector<std::int32_t> values)
    : task_(&task), values_(std::move(values)) {
    auto occurrences = std::make_shared<Occurrences>();
    occurrences->clauses.resize(values_.size());
    occurrences->groups.resize(values_.size());
    for (std::uint32_t c = 0; c < task.clauses.size(); ++c) {
        if (only_invariants && !task.invariant_clauses[c]) continue;
        empty_ = false;
        for (const Fact& fact : task.clauses[c]) occurrences->clauses[index(fact.variable)].push_back(c);
    }
    for (std::uint32_t g = 0; g < task.groups.size(); ++g) {
        if (only_invariants && !task.invariant_groups[g]) continue;
        empty_ = false;
        for (const Fact& fact : task.groups[g])
            occurrences->groups[index(fact.variable)].push_back({g, fact.value});
    }
    occurrences_ = std::move(occurrences);
}

InitialKnowledge::InitialKnowledge(const BeliefTask& task)
    : InitialKnowledge(task, false, task.initial_values) {
    std::vector<std::int32_t> news;
    for (std::size_t c = 0; c < task.clauses.size() && consistent_; ++c)
        if (task.clauses[c].size() == 1) consistent_ = learn(task.clauses[c][0], news);
}

InitialKnowledge InitialKnowledge::of_invariants(const BeliefTask& task) {
    return InitialKnowledge(task, true,
                            std::vector<std::int32_t>(task.initial_values.size(), BeliefTask::kUnknown));
}

InitialKnowledge InitialKnowledge::with(std::vector<std::int32_t> values) const {
    InitialKnowledge result = *this;
    result.values_ = std::move(values);
    return result;
}

bool InitialKnowledge::set(Fact fact, std::vector<std::int32_t>& news) {
    std::int32_t& value = values_[index(fact.variable)];
    if (value == fact.value) return true;
    if (value != BeliefTask::kUnknown) return false;
    value = fact.value;
    news.push_back(fact.variable);
    return true;
}

bool InitialKnowledge::learn(Fact fact, std::vector<std::int32_t>& news, bool try_values) {
    const std::size_t first = news.size();
    if (assign(fact, news) && (!try_values || try_nearby(news, first))) return true;
    take_back(news, first);
    return false;
}

bool InitialKnowledge::assign(Fact fact, std::vector<std::int32_t>& news) {
    const std::size_t first = news.size();
    if (set(fact, news) && propagate(news, first)) return true;
    take_back(news, first);
    return false;
}

/// Tries the open variables that share a clause with something new.
bool InitialKnowledge::try_nearby(std::vector<std::int32_t>& news, std::size_t first) {
    std::vector<std::int32_t> open;
    std::vector<std::int32_t> consequences;
    std::size_t tries = kMostTries;
    for (std::size_t i = first; i < news.size() && tries > 0; ++i) {
        open.clear();
        collect_nearby(news[i], open);
        for (std::int32_t variable : open) {
            if (values_[index(variable)] != BeliefTask::kUnknown || tries-- == 0) continue;
            for (std::int32_t value : {0, 1}) {
                consequences.clear();
                if (assign({variable, value}, consequences)) {
                    take_back(consequences, 0);
                    continue;
                }
                if (!assign({variable, 1 - value}, news)) return false;
                break;
            }
            if (tries == 0) break;
        }
    }
    return true;
}

void InitialKnowledge::collect_nearby(std::int32_t variable, std::vector<std::int32_t>& open) const {
    for (std::uint32_t clause : occurrences_->clauses[index(variable)])
        for (const Fact& fact : task_->clauses[clause])
            if (values_[index(fact.variable)] == BeliefTask::kUnknown) open.push_back(fact.variable);
    std::sort(open.begin(), open.end());
    open.erase(std::unique(open.begin(), open.end()), open.end());
}

void InitialKnowledge::take_back(std::vector<std::int32_t>& news, std::size_t first) {
    for (std::size_t i = first; i < news.size(); ++i) values_[index(news[i])] = BeliefTask::kUnknown;
    news.resize(first);
}

bool InitialKnowledge::propagate(std::vector<std::int32_t>& news, std::size_t first) {
    for (std::size_t i = first; i < news.size(); ++i) {
        const std::size_t variable = index(news[i]);
        for (const Watch& watch : occurrences_->groups[variable]) {
            if (values_[variable] != watch.value) continue;
            for (const Fact& other : task_->groups[watch.list])
                if (other.variable != news[i] && !set({other.variable, 1 - other.value}, news)) return false;
        }
        for (std::uint32_t clause : occurrences_->clauses[variable]) {
            const Fact* open = nullptr;
            std::size_t left = 0;
            for (const Fact& fact : task_->clauses[clause]) {
                const std::int32_t value = values_[index(fact.variable)];
                if (value != BeliefTask::kUnknown && value != fact.value) continue;
                open = &fact;
                left = value == fact.value ? 2 : left + 1;
                if (left > 1) break;
            }
            if (left == 0 || (left == 1 && !set(*open, news))) return false;
        }
    }
    return true;
}

}  // namespace praxis::belief
