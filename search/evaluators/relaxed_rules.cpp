#include "search/evaluators/relaxed_rules.hpp"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <numeric>

namespace praxis::relaxed {

namespace {

/// Makes rules; scratch lists live as long as it does.
class RuleMaker {
  public:
    RuleMaker(const FiniteDomainTask& task, std::size_t max_preconditions)
        : task_(task), max_preconditions_(max_preconditions) {
        rules_.fact_count = static_cast<std::uint32_t>(task.fact_count());
        default_state_.resize(task.variable_count(), Default::free);
        no_operator_ = static_cast<std::uint32_t>(task.operator_count());
    }

    Rules make(std::span<const Fact> goal) {
        const std::size_t rules = task_.operator_count() + task_.axioms.size() + 1;
        rules_.preconditions.reserve(rules, task_.preconditions.total() + task_.axiom_bodies.total());
        rules_.effects.reserve(rules, task_.effects.total() + task_.axioms.size());
        rules_.operators.reserve(rules);
        rules_.conditions.reserve(rules);
        find_definable_defaults();
        for (std::uint32_t op = 0; op < task_.operator_count(); ++op) add_operator(op);
        for (std::uint32_t axiom = 0; axiom < task_.axioms.size(); ++axiom) add_axiom(axiom);
        body_.clear();
        for (const Fact fact : goal) require(fact);
        define_defaults();
        rules_.goal = make_up_fact();
        add_rule(rules_.goal, no_operator_);
        return std::move(rules_);
    }

  private:
    /// What is known about the default value of a derived variable.
    enum class Default : std::uint8_t {
        free,       ///< counts as always reached
        definable,  ///< rules could define it
        defined,    ///< rules define it, or will
    };

    std::uint32_t make_up_fact() { return rules_.fact_count++; }

    bool is_default(Fact fact) const {
        const auto variable = static_cast<std::size_t>(fact.variable);
        return task_.axiom_layers[variable] >= 0 && fact.value == task_.initial_values[variable];
    }

    /// Adds a precondition to the rule in the making.
    void require(Fact fact) {
        if (is_default(fact)) {
            Default& state = default_state_[static_cast<std::size_t>(fact.variable)];
            if (state == Default::free) return;
            if (state == Default::definable) {
                state = Default::defined;
                to_define_.push_back(fact.variable);
            }
        }
        body_.push_back(task_.fact_number(fact));
    }

    void add_operator(std::uint32_t op) {
        const std::span<const GroundEffect> effects = task_.effects[op];
        const bool conditional =
            std::ranges::any_of(effects, [](const GroundEffect& e) { return e.condition != 0; });
        effects_.assign(effects.begin(), effects.end());
        if (conditional) {
            std::ranges::stable_sort(effects_, {}, &GroundEffect::condition);
        }
        for (std::size_t begin = 0, end = 0; begin < effects_.size(); begin = end) {
            const std::uint32_t condition = effects_[begin].condition;
            while (end < effects_.size() && effects_[end].condition == condition) ++end;
            if (condition != 0 && contradict(task_.preconditions[op], task_.conditions[condition])) continue;
            body_.clear();
            for (const Fact fact : task_.preconditions[op]) require(fact);
            for (const Fact fact : task_.conditions[condition]) require(fact);
            heads_.clear();
            for (std::size_t i = begin; i < end; ++i) heads_.push_back(task_.fact_number(effects_[i].fact));
            close_rule(op, condition);
        }
    }

    /// Whether two sorted conditions ask for different values of a variable.
    static bool contradict(std::span<const Fact> a, std::span<const Fact> b) {
        std::size_t i = 0;
        for (const Fact fact : b) {
            while (i < a.size() && a[i].variable < fact.variable) ++i;
            if (i < a.size() && a[i].variable == fact.variable && a[i].value != fact.value) return true;
        }
        return false;
    }

    void add_axiom(std::uint32_t axiom) {
        body_.clear();
        for (const Fact fact : task_.axiom_bodies[axiom]) require(fact);
        add_rule(task_.fact_number(task_.axioms[axiom].head), no_operator_);
    }

    /// Ends a rule with one effect.
    void add_rule(std::uint32_t head, std::uint32_t op) {
        heads_.assign(1, head);
        close_rule(op, 0);
    }

    void close_rule(std::uint32_t op, std::uint32_t condition) {
        sort_unique(body_);
        sort_unique(heads_);
        std::erase_if(heads_, [this](std::uint32_t head) { return std::ranges::binary_search(body_, head); });
        if (heads_.empty()) return;
        while (body_.size() > max_preconditions_) {
            const std::uint32_t part = make_up_fact();
            const auto rest = body_.end() - static_cast<std::ptrdiff_t>(max_preconditions_);
            rules_.preconditions.append(std::span<const std::uint32_t>(rest, body_.end()));
            rules_.effects.append(std::span<const std::uint32_t>(&part, 1));
            rules_.operators.push_back(no_operator_);
            rules_.conditions.push_back(0);
            body_.erase(rest, body_.end());
            body_.push_back(part);
        }
        rules_.preconditions.append(body_);
        rules_.effects.append(heads_);
        rules_.operators.push_back(op);
        rules_.conditions.push_back(condition);
    }

    static void sort_unique(std::vector<std::uint32_t>& list) {
        if (!std::ranges::is_sorted(list)) std::ranges::sort(list);
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }

    /// Derived variables that do not depend on themselves through non-default values.
    void find_definable_defaults() {
        if (!task_.has_axioms()) return;
        boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> graph(task_.variable_count());
        std::vector<char> recursive(task_.variable_count(), false);
        for (std::size_t axiom = 0; axiom < task_.axioms.size(); ++axiom) {
            const auto head = static_cast<std::size_t>(task_.axioms[axiom].head.variable);
            for (const Fact fact : task_.axiom_bodies[axiom]) {
                const auto variable = static_cast<std::size_t>(fact.variable);
                if (!task_.derived(fact.variable) || is_default(fact)) continue;
                if (variable == head) recursive[head] = true;
                boost::add_edge(head, variable, graph);
            }
        }
        std::vector<std::size_t> component(task_.variable_count());
        const auto components = boost::strong_components(
            graph,
            boost::make_iterator_property_map(component.begin(), boost::get(boost::vertex_index, graph)));
        std::vector<std::size_t> sizes(static_cast<std::size_t>(components), 0);
        for (const std::size_t c : component) ++sizes[c];
        for (std::size_t v = 0; v < task_.variable_count(); ++v) {
            if (task_.axiom_layers[v] >= 0 && sizes[component[v]] == 1 && !recursive[v]) {
                default_state_[v] = Default::definable;
            }
        }
    }

    /// Rules for the default values that rules so far need, and for those that these rules need.
    void define_defaults() {
        if (to_define_.empty()) return;
        const std::vector<std::uint32_t> goal_body = body_;
        std::vector<std::vector<std::uint32_t>> axioms_of(task_.variable_count());
        for (std::uint32_t axiom = 0; axiom < task_.axioms.size(); ++axiom) {
            axioms_of[static_cast<std::size_t>(task_.axioms[axiom].head.variable)].push_back(axiom);
        }
        std::size_t budget = kDefaultRules;
        for (std::size_t done = 0; done < to_define_.size(); ++done) {
            const std::int32_t variable = to_define_[done];
            const auto& axioms = axioms_of[static_cast<std::size_t>(variable)];
            std::vector<std::uint32_t> all_fail;
            for (std::size_t i = 0; i < axioms.size() && budget > 0; ++i) {
                all_fail.push_back(define_failure(axioms[i], budget));
            }
            body_ = budget > 0 ? all_fail : std::vector<std::uint32_t>{};
            add_rule(task_.fact_number({variable, task_.initial_values[static_cast<std::size_t>(variable)]}),
                     no_operator_);
        }
        body_ = goal_body;
    }

    /// A made-up fact "the axiom's body is false", with its rules.
    std::uint32_t define_failure(std::uint32_t axiom, std::size_t& budget) {
        const std::uint32_t failure = make_up_fact();
        for (const Fact fact : task_.axiom_bodies[axiom]) {
            const std::int32_t size = task_.domain_sizes[static_cast<std::size_t>(fact.variable)];
            budget -= std::min(budget, static_cast<std::size_t>(size));
            if (budget == 0) break;
            for (std::int32_t value = 0; value < size; ++value) {
                if (value == fact.value) continue;
                body_.clear();
                require({fact.variable, value});
                add_rule(failure, no_operator_);
            }
        }
        return failure;
    }

    static constexpr std::size_t kDefaultRules = 2'000'000;

    const FiniteDomainTask& task_;
    std::size_t max_preconditions_;
    std::uint32_t no_operator_ = 0;
    Rules rules_;
    std::vector<std::uint32_t> body_;
    std::vector<std::uint32_t> heads_;
    std::vector<GroundEffect> effects_;
    std::vector<Default> default_state_;
    std::vector<std::int32_t> to_define_;
};

}  // namespace

Rules make_rules(const FiniteDomainTask& task, std::span<const Fact> goal, std::size_t max_preconditions) {
    return RuleMaker(task, max_preconditions).make(goal);
}

Achievers::Achievers(const Rules& rules) : begin(rules.fact_count + 1, 0), entries(rules.effects.total()) {
    for (const std::uint32_t fact : rules.effects.items()) ++begin[fact];
    std::exclusive_scan(begin.begin(), begin.end(), begin.begin(), 0u);
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t rule = 0; rule < rules.size(); ++rule) {
        std::uint32_t effect = rules.effects.begin_of(rule);
        for (const std::uint32_t fact : rules.effects[rule]) entries[next[fact]++] = {rule, effect++};
    }
}

std::vector<char> relevant_facts(const Rules& rules, const Achievers& achievers) {
    std::vector<char> relevant(rules.fact_count, false);
    std::vector<char> seen(rules.size(), false);
    std::vector<std::uint32_t> queue{rules.goal};
    relevant[rules.goal] = true;
    while (!queue.empty()) {
        const std::uint32_t fact = queue.back();
        queue.pop_back();
        for (const Achievers::Entry entry : achievers.of(fact)) {
            if (seen[entry.rule]) continue;
            seen[entry.rule] = true;
            for (const std::uint32_t precondition : rules.preconditions[entry.rule]) {
                if (relevant[precondition]) continue;
                relevant[precondition] = true;
                queue.push_back(precondition);
            }
        }
    }
    return relevant;
}

}  // namespace praxis::relaxed
