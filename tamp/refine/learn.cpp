#include "tamp/refine/learn.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace praxis::tamp {
namespace {

class Learner {
  public:
    Learner(const StreamTask& streams, const SymbolicTask& task, const Skeleton& skeleton,
            const SampleOutcome& failure)
        : streams_(streams), task_(task), skeleton_(skeleton), failure_(failure) {}

    Lesson run() {
        Lesson lesson;
        lesson.definite = failure_.definite;
        find_causes();
        for (const std::uint32_t n : causes_) {
            const Need& need = choose(n);
            std::set<GroundAtom>& atoms = events_[need.step];
            atoms.insert(need.because.begin(), need.because.end());
            if (need.choice) lesson.definite = false;
        }
        for (const auto& [n, fluent] : failure_.fluents)
            events_[skeleton_.nodes[n].step].insert(skeleton_.nodes[n].fluents[fluent].atom);
        for (const auto& [step, atoms] : events_) {
            Event& event = lesson.nogood.events.emplace_back();
            if (step < skeleton_.plan.operators.size()) event.op = skeleton_.plan.operators[step];
            bool known = true;
            for (const GroundAtom& atom : atoms)
                if (const auto fact = task_.fact(atom, known)) event.facts.push_back(*fact);
            std::ranges::sort(event.facts);
            event.facts.erase(std::unique(event.facts.begin(), event.facts.end()), event.facts.end());
            if (!known) lesson.definite = false;
        }
        lesson.reason = reason();
        return lesson;
    }

  private:
    /// The nodes that are not there anyway where another of them, or a blamed fluent, is.
    void find_causes() {
        std::set<std::uint32_t> implied;
        const auto imply = [&](std::uint32_t slot) {
            if (skeleton_.slots[slot].node != OptimisticTask::kNone)
                implied.insert(skeleton_.slots[slot].node);
        };
        for (const auto& [n, fluent] : failure_.fluents)
            for (const std::uint32_t slot : skeleton_.nodes[n].fluents[fluent].slots) imply(slot);
        // Nodes come after those that they depend on.
        std::vector<std::uint32_t> nodes = failure_.nodes;
        std::ranges::sort(nodes, std::greater<>{});
        std::set<std::uint32_t> reached;
        for (std::uint32_t n = static_cast<std::uint32_t>(skeleton_.nodes.size()); n-- > 0;) {
            if (implied.contains(n)) reached.insert(n);
            const bool failed = std::ranges::binary_search(nodes, n, std::greater<>{});
            if (failed && !implied.contains(n)) causes_.push_back(n);
            if (!failed && !reached.contains(n)) continue;
            for (const std::uint32_t slot : skeleton_.nodes[n].inputs) imply(slot);
            for (const std::uint32_t before : skeleton_.nodes[n].after) implied.insert(before);
        }
    }

    /// The need that asks for the least that is not asked for yet.
    const Need& choose(std::uint32_t n) const {
        const auto price = [&](const Need& need) {
            const auto known = events_.find(need.step);
            std::size_t news = known == events_.end() ? 1000 : 0;
            for (const GroundAtom& atom : need.because)
                news += known != events_.end() && known->second.contains(atom) ? 0 : 1;
            return 2 * news + (need.choice ? 1 : 0);
        };
        const std::vector<Need>& needs = skeleton_.nodes[n].needs;
        return *std::ranges::min_element(needs, {}, price);
    }

    std::string reason() const {
        std::string text;
        for (const auto& [step, atoms] : events_) {
            if (!text.empty()) text += " together with ";
            text += step_text(task_, skeleton_, step);
            const char* joint = " while ";
            for (const GroundAtom& atom : atoms) {
                text += joint + atom_text(task_.lifted(), atom);
                joint = " and ";
            }
        }
        std::set<std::string> names;
        for (const std::uint32_t n : causes_)
            names.insert(streams_.streams[skeleton_.nodes[n].stream.index()].name);
        const char* joint = ": ";
        for (const std::string& name : names) {
            text += joint + name;
            joint = ", ";
        }
        return text + (names.empty() ? "" : " failed");
    }

    const StreamTask& streams_;
    const SymbolicTask& task_;
    const Skeleton& skeleton_;
    const SampleOutcome& failure_;
    std::vector<std::uint32_t> causes_;
    std::map<std::uint32_t, std::set<GroundAtom>> events_;  ///< by step
};

}  // namespace

std::vector<Lesson> learn(const StreamTask& streams, const SymbolicTask& task, const Skeleton& skeleton,
                          SampleOutcome failure) {
    std::vector<Lesson> lessons{Learner(streams, task, skeleton, failure).run()};
    const auto others = std::move(failure.others);
    for (const auto& other : others) {
        failure.fluents = {other};
        lessons.push_back(Learner(streams, task, skeleton, failure).run());
    }
    return lessons;
}

Lesson exclude(const SymbolicTask& task, const Skeleton& skeleton) {
    Lesson lesson;
    lesson.definite = false;
    std::set<OperatorId> operators(skeleton.plan.operators.begin(), skeleton.plan.operators.end());
    for (const OperatorId op : operators) lesson.nogood.events.push_back({op, {}});
    lesson.nogood.events.push_back({});
    lesson.reason = "these actions together, from " + step_text(task, skeleton, 0);
    return lesson;
}

}  // namespace praxis::tamp
