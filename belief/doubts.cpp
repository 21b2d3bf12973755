#include "belief/doubts.hpp"

#include <algorithm>

namespace praxis::belief {
namespace {

const Doubt::Change* find(const Doubt& doubt, std::int32_t variable) {
    for (const Doubt::Change& change : doubt.changes)
        if (change.variable == variable) return &change;
    return nullptr;
}

bool concerns(const Doubt& doubt, std::span<const Fact> facts, const FiniteDomainTask& task) {
    return std::any_of(facts.begin(), facts.end(), [&](const Fact& fact) {
        return task.derived(fact.variable) || find(doubt, fact.variable) != nullptr;
    });
}

void append(const Doubt& doubt, bool happened, std::vector<Fact>& news) {
    for (const Doubt::Change& change : doubt.changes)
        news.push_back({change.variable, happened ? change.after : change.before});
}

}  // namespace

std::string to_string(const Supposition& supposed, const FiniteDomainTask& task) {
    return task.operator_name(OperatorId(supposed.action)) +
           (supposed.happened ? " has happened" : " has not happened");
}

bool Doubts::about(std::int32_t variable) const {
    return std::any_of(doubts_.begin(), doubts_.end(),
                       [&](const Doubt& doubt) { return find(doubt, variable) != nullptr; });
}

bool Doubts::has_action(std::uint32_t action) const {
    return std::any_of(doubts_.begin(), doubts_.end(),
                       [&](const Doubt& doubt) { return doubt.supposed.action == action; });
}

std::size_t Doubts::count(std::span<const Fact> facts, const FiniteDomainTask& task) const {
    return static_cast<std::size_t>(std::count_if(
        doubts_.begin(), doubts_.end(), [&](const Doubt& doubt) { return concerns(doubt, facts, task); }));
}

void Doubts::overwrite(std::int32_t variable) {
    for (Doubt& doubt : doubts_)
        std::erase_if(doubt.changes,
                      [&](const Doubt::Change& change) { return change.variable == variable; });
    forget_empty();
}

void Doubts::settle(Fact fact, std::vector<Fact>& news) {
    // Later doubts last: what they say of a variable is later, too.
    for (Doubt& doubt : doubts_) {
        const Doubt::Change* const change = find(doubt, fact.variable);
        if (change == nullptr || (fact.value != change->before && fact.value != change->after)) continue;
        append(doubt, fact.value == change->after, news);
        doubt.changes.clear();
    }
    overwrite(fact.variable);
}

std::optional<Supposition> Doubts::turn(std::span<const Fact> facts, const FiniteDomainTask& task,
                                        bool settled, std::vector<Fact>& news) {
    const auto last = std::find_if(doubts_.rbegin(), doubts_.rend(),
                                   [&](const Doubt& doubt) { return concerns(doubt, facts, task); });
    if (last == doubts_.rend()) return std::nullopt;
    last->supposed.happened = !last->supposed.happened;
    const Supposition now = last->supposed;
    append(*last, now.happened, news);
    if (settled) {
        last->changes.clear();
        forget_empty();
    }
    return now;
}

void Doubts::forget_empty() {
    std::erase_if(doubts_, [](const Doubt& doubt) { return doubt.changes.empty(); });
}

}  // namespace praxis::belief
