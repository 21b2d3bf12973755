#include "tamp/refine/skeleton.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace praxis::tamp {
namespace {

constexpr std::uint32_t kNone = OptimisticTask::kNone;
constexpr std::uint32_t kAllSteps = kNone;

class SkeletonMaker {
  public:
    SkeletonMaker(const StreamTask& streams, const SymbolicTask& task, SymbolicPlan plan)
        : streams_(streams), task_(task), state_(task.lifted()) {
        made_.plan = std::move(plan);
    }

    Skeleton run() {
        std::vector<Support> supports;
        const auto count = static_cast<std::uint32_t>(made_.plan.steps.size());
        for (std::uint32_t s = 0; s < count; ++s) {
            const PlanStep& step = made_.plan.steps[s];
            supports.clear();
            find_supports(task_.rules(), state_, step, supports);
            for (const Support& support : supports)
                rely_on(support.atom, {s, support.because, support.choice}, s);
            for (const ObjectId object : step.arguments)
                if (const std::uint32_t instance = producer(object); instance != kNone)
                    use(instance, s, {s, {}, false});
            auto& arguments = made_.arguments.emplace_back();
            for (const ObjectId object : step.arguments) arguments.push_back(slot(object, s));
            if (const auto why_not = state_.execute(step))
                throw std::logic_error("the symbolic plan cannot be executed: " + *why_not);
        }
        supports.clear();
        find_goal_supports(task_.rules(), state_, supports);
        for (const Support& support : supports)
            rely_on(support.atom, {count, support.because, support.choice}, count);
        return std::move(made_);
    }

  private:
    std::uint32_t producer(ObjectId object) const { return task_.optimistic().producer[object.index()]; }
    bool shared(ObjectId object) const { return producer(object) == kNone || task_.shared()[object.index()]; }

    std::uint32_t slot(ObjectId object, std::uint32_t step) {
        const auto [at, is_new] = slots_.try_emplace(Tuple{object.index(), shared(object) ? kAllSteps : step},
                                                     static_cast<std::uint32_t>(made_.slots.size()));
        if (is_new) made_.slots.push_back({object, kNone});
        return at->second;
    }

    std::uint32_t rely_on(const GroundAtom& atom, const Need& need, std::uint32_t step) {
        const auto found = task_.optimistic().certified_by.find(atom);
        if (found == task_.optimistic().certified_by.end()) return kNone;
        return use(found->second, step, need);
    }

    /// The step that a node belongs to; kAllSteps: one node for all.
    std::uint32_t home(const StreamInstance& instance, std::uint32_t step) const {
        const bool any_state = streams_.streams[instance.stream.index()].fluents.empty();
        const auto is_shared = [&](ObjectId object) { return shared(object); };
        if (!instance.outputs.empty()) {
            if (!is_shared(instance.outputs.front())) return step;
            if (!any_state) refuse_fluents(instance);
            return kAllSteps;
        }
        return any_state && std::ranges::all_of(instance.inputs, is_shared) ? kAllSteps : step;
    }

    [[noreturn]] void refuse_fluents(const StreamInstance& instance) const {
        const StreamSchema& stream = streams_.streams[instance.stream.index()];
        Diagnostic diagnostic;
        diagnostic.severity = Severity::unsupported;
        diagnostic.where = stream.where;
        diagnostic.message = "an output of '" + stream.name +
                             "' gets into the state, but what it is depends on the state (':fluents')";
        throw UnsupportedError(to_string(diagnostic, *task_.lifted().sources), {diagnostic});
    }

    std::uint32_t use(std::uint32_t number, std::uint32_t step, const Need& need) {
        const StreamInstance& instance = task_.optimistic().instances[number];
        const Tuple key{number, home(instance, step)};
        const auto known = nodes_.find(key);
        std::vector<std::uint32_t> after;
        if (known == nodes_.end() || std::ranges::find(made_.nodes[known->second].needs, need) ==
                                         made_.nodes[known->second].needs.end()) {
            for (const ObjectId object : instance.inputs)
                if (producer(object) != kNone) use(producer(object), step, need);
            after = use_domain(instance, step, need);
        }
        if (known != nodes_.end()) {
            auto& needs = made_.nodes[known->second].needs;
            if (std::ranges::find(needs, need) == needs.end()) needs.push_back(need);
            return known->second;
        }
        SkeletonNode node;
        node.stream = instance.stream;
        node.step = step;
        node.after = std::move(after);
        node.needs.push_back(need);
        for (const ObjectId object : instance.inputs) node.inputs.push_back(slot(object, step));
        add_fluents(node, step);
        const auto id = static_cast<std::uint32_t>(made_.nodes.size());
        for (const ObjectId object : instance.outputs) {
            node.outputs.push_back(slot(object, step));
            made_.slots[node.outputs.back()].node = id;
        }
        made_.nodes.push_back(std::move(node));
        nodes_.emplace(key, id);
        return id;
    }

    std::vector<std::uint32_t> use_domain(const StreamInstance& instance, std::uint32_t step,
                                          const Need& need) {
        std::vector<std::uint32_t> nodes;
        for (const LiftedAtom& atom : streams_.streams[instance.stream.index()].domain) {
            if (!streams_.certified[atom.predicate.index()]) continue;
            GroundAtom ground{atom.predicate.index()};
            for (const Term term : atom.terms)
                ground.push_back(term.is_variable() ? instance.inputs[term.variable_index()].index()
                                                    : term.object_id().index());
            const std::uint32_t node = rely_on(ground, need, step);
            if (node != kNone) nodes.push_back(node);
        }
        return nodes;
    }

    void add_fluents(SkeletonNode& node, std::uint32_t step) {
        for (const PredicateId predicate : streams_.streams[node.stream.index()].fluents) {
            const validation::FactTable& table = state_.tables()[predicate.index()];
            for (std::uint32_t row = 0; row < table.row_count(); ++row) {
                if (!table.alive(row)) continue;
                SkeletonFluent fluent;
                fluent.atom.push_back(predicate.index());
                for (std::uint32_t i = 0; i < table.arity(); ++i) {
                    const ObjectId object(table.row(row)[i]);
                    fluent.atom.push_back(table.row(row)[i]);
                    fluent.slots.push_back(slot(object, step));
                }
                node.fluents.push_back(std::move(fluent));
            }
        }
    }

    const StreamTask& streams_;
    const SymbolicTask& task_;
    validation::Executor state_;
    Skeleton made_;
    TupleMap<std::uint32_t> slots_;  ///< by object and step
    TupleMap<std::uint32_t> nodes_;  ///< by instance and step
};

}  // namespace

Skeleton make_skeleton(const StreamTask& streams, const SymbolicTask& task, SymbolicPlan plan) {
    return SkeletonMaker(streams, task, std::move(plan)).run();
}

std::string atom_text(const LiftedTask& task, const GroundAtom& atom) {
    std::string text = "(" + task.predicates[atom[0]].name;
    for (std::size_t i = 1; i < atom.size(); ++i) text += " " + task.objects[atom[i]].name;
    return text + ")";
}

Skeleton alone(const Skeleton& skeleton, std::uint32_t step) {
    const auto is_of_step = [&](const Need& need) { return need.step == step; };
    std::vector<bool> wanted(skeleton.nodes.size(), false);
    const auto want = [&](std::uint32_t slot) {
        if (skeleton.slots[slot].node != kNone) wanted[skeleton.slots[slot].node] = true;
    };
    for (std::uint32_t n = static_cast<std::uint32_t>(wanted.size()); n-- > 0;) {
        const SkeletonNode& node = skeleton.nodes[n];
        if (!wanted[n] && std::ranges::none_of(node.needs, is_of_step)) continue;
        wanted[n] = true;
        for (const std::uint32_t slot : node.inputs) want(slot);
        for (const SkeletonFluent& fluent : node.fluents)
            for (const std::uint32_t slot : fluent.slots) want(slot);
        for (const std::uint32_t before : node.after) wanted[before] = true;
    }
    Skeleton one{skeleton.plan, skeleton.arguments, skeleton.slots, {}};
    std::vector<std::uint32_t> number(wanted.size(), kNone);
    for (std::uint32_t n = 0; n < wanted.size(); ++n) {
        if (!wanted[n]) continue;
        number[n] = static_cast<std::uint32_t>(one.nodes.size());
        SkeletonNode& node = one.nodes.emplace_back(skeleton.nodes[n]);
        for (std::uint32_t& before : node.after) before = number[before];
        if (std::ranges::any_of(node.needs, is_of_step))
            std::erase_if(node.needs, [&](const Need& need) { return !is_of_step(need); });
    }
    for (Slot& slot : one.slots)
        if (slot.node != kNone) slot.node = number[slot.node];
    return one;
}

std::string step_text(const SymbolicTask& task, const Skeleton& skeleton, std::uint32_t step) {
    if (step >= skeleton.plan.steps.size()) return "the goal";
    const PlanStep& action = skeleton.plan.steps[step];
    std::string text = "(" + task.lifted().schemas[action.schema.index()].name;
    for (const ObjectId object : action.arguments) text += " " + task.lifted().objects[object.index()].name;
    return text + ")";
}

}  // namespace praxis::tamp
