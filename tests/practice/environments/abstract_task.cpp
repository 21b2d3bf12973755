#include "tests/practice/environments/abstract_task.hpp"

#include <algorithm>
#include <deque>
#include <set>
#include <stdexcept>
#include <utility>

#include "parser/parser.hpp"
#include "search/ground/ground.hpp"

namespace praxis::practice::test {

namespace {

using Form = FiniteDomainTask::FactForm;

std::int32_t number_of(const std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::invalid_argument("the environment does not know '" + name + "'");
    return static_cast<std::int32_t>(found - names.begin());
}

std::vector<std::int32_t> objects_of(const NameTable& names, std::size_t i,
                                     const std::vector<std::string>& objects) {
    std::vector<std::int32_t> result;
    for (const std::uint32_t word : names.names[i].subspan(1))
        result.push_back(number_of(objects, names.symbols[word]));
    return result;
}

}  // namespace

AbstractTask::AbstractTask(const SimulatedEnvironment& environment) : environment_(environment) {
    const Description& description = environment.description();
    const LoadResult loaded =
        parse_task({description.name, description.domain}, {"problem", description.problem});
    for (const Diagnostic& warning : loaded.warnings)
        ADD_FAILURE() << to_string(warning, *loaded.task->sources);
    ground_ = ground(*loaded.task, {.prune_irrelevant = false}).task;
    prepared_ = std::make_unique<PreparedTask>(ground_);
    std::vector<std::string> schemas;
    for (const SkillSchema& schema : description.schemas) schemas.push_back(schema.name);
    for (std::size_t i = 0; i < ground_->operator_count(); ++i) {
        const NameTable& names = ground_->operator_names;
        skills_.push_back({number_of(schemas, names.symbols[names.names[i][0]]),
                           objects_of(names, i, description.objects)});
    }
    for (std::size_t i = 0; i < ground_->fact_count(); ++i) {
        const NameTable& names = ground_->fact_names;
        FactAtom fact{{}, ground_->fact_forms[i]};
        if (fact.form != Form::none_of_those)
            fact.atom = {number_of(description.predicates, names.symbols[names.names[i][0]]),
                         objects_of(names, i, description.objects)};
        facts_.push_back(std::move(fact));
    }
}

std::size_t AbstractTask::parameter_count(std::size_t skill) const {
    return environment_.description()
        .schemas[static_cast<std::size_t>(skills_[skill].schema)]
        .parameters.size();
}

const std::string& AbstractTask::schema_name(std::size_t skill) const {
    return environment_.description().schemas[static_cast<std::size_t>(skills_[skill].schema)].name;
}

std::size_t AbstractTask::find(const std::string& name) const {
    for (std::size_t i = 0; i < skills_.size(); ++i)
        if (this->name(i) == name) return i;
    throw std::invalid_argument("no ground skill '" + name + "'");
}

bool AbstractTask::fact_holds(const State& state, std::size_t fact) const {
    return environment_.holds(state, facts_[fact].atom) == (facts_[fact].form == Form::atom);
}

std::optional<AbstractTask::Values> AbstractTask::values(const State& state) const {
    Values values(ground_->variable_count(), -1);
    for (std::size_t v = 0; v < values.size(); ++v) {
        std::int32_t none_of_those = -1;
        for (std::int32_t i = 0; i < ground_->domain_sizes[v]; ++i) {
            const std::size_t fact = ground_->first_fact[v] + static_cast<std::size_t>(i);
            if (facts_[fact].form == Form::none_of_those) {
                none_of_those = i;
            } else if (fact_holds(state, fact)) {
                if (values[v] >= 0) {
                    ADD_FAILURE() << ground_->fact_names.words(fact) << " and another atom of its group hold";
                    return std::nullopt;
                }
                values[v] = i;
            }
        }
        if (values[v] < 0) values[v] = none_of_those;
        if (values[v] < 0) {
            ADD_FAILURE() << "no atom holds beside " << ground_->fact_names.words(ground_->first_fact[v]);
            return std::nullopt;
        }
    }
    return values;
}

bool AbstractTask::applicable(const Values& values, std::size_t skill) const {
    return all_hold(ground_->preconditions[skill], values.data());
}

AbstractTask::Values AbstractTask::successor(const Values& values, std::size_t skill) const {
    Values result = values;
    for (const GroundEffect& effect : ground_->effects[skill])
        if (all_hold(ground_->conditions[effect.condition], values.data()))
            result[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
    return result;
}

bool AbstractTask::reached(const State& state, const std::vector<GroundAtom>& goal) const {
    return std::all_of(goal.begin(), goal.end(),
                       [&](const GroundAtom& atom) { return environment_.holds(state, atom); });
}

std::size_t AbstractTask::reachable(const State& from, std::size_t limit) const {
    std::set<Values> seen = {values(from).value()};
    std::deque<Values> queue(seen.begin(), seen.end());
    while (!queue.empty() && seen.size() < limit) {
        const Values current = std::move(queue.front());
        queue.pop_front();
        for (std::size_t i = 0; i < skills_.size(); ++i) {
            if (!applicable(current, i)) continue;
            Values next = successor(current, i);
            if (seen.insert(next).second) queue.push_back(std::move(next));
        }
    }
    return seen.size();
}

std::optional<std::int64_t> AbstractTask::distance(const PracticeTask& task,
                                                   const std::vector<std::string>& without) const {
    constexpr std::int32_t kProhibitive = 1000000;
    FiniteDomainTask priced = *ground_;
    priced.unit_cost = false;
    for (std::size_t i = 0; i < skills_.size(); ++i)
        if (std::find(without.begin(), without.end(), schema_name(i)) != without.end())
            priced.costs[i] = kProhibitive;
    const Outcome outcome =
        search(PreparedTask(std::make_shared<FiniteDomainTask>(std::move(priced))),
               {values(task.initial).value(), facts(task.goal)}, configuration("astar(lmcut())"));
    if (!outcome.plan || outcome.cost >= kProhibitive) return std::nullopt;
    return outcome.cost;
}

std::optional<std::int64_t> AbstractTask::steps_before(const State& from, std::size_t skill) const {
    const std::span<const Fact> goal = ground_->preconditions[skill];
    const Outcome outcome = search(*prepared_, {values(from).value(), {goal.begin(), goal.end()}},
                                   configuration("astar(lmcut())"));
    if (!outcome.plan) return std::nullopt;
    return outcome.cost;
}

std::vector<Fact> AbstractTask::facts(const std::vector<GroundAtom>& atoms) const {
    std::vector<Fact> result;
    for (std::size_t v = 0; v < ground_->variable_count(); ++v)
        for (std::int32_t i = 0; i < ground_->domain_sizes[v]; ++i) {
            const FactAtom& fact = facts_[ground_->first_fact[v] + static_cast<std::size_t>(i)];
            if (fact.form == Form::atom && std::find(atoms.begin(), atoms.end(), fact.atom) != atoms.end())
                result.push_back({static_cast<std::int32_t>(v), i});
        }
    if (result.size() != atoms.size()) throw std::invalid_argument("an atom is not of the ground task");
    return result;
}

std::vector<std::size_t> AbstractTask::plan(const Values& from, std::span<const Fact> goal) const {
    const Outcome outcome =
        search(*prepared_, {from, {goal.begin(), goal.end()}}, configuration("lazy_greedy([ff()])"));
    std::vector<std::size_t> steps;
    if (outcome.plan)
        for (const OperatorId id : *outcome.plan) steps.push_back(id.index());
    return steps;
}

bool AbstractTask::solves(const PracticeTask& task, const Choice& parameters, Random& random) const {
    const std::vector<Fact> goal = facts(task.goal);
    State state = task.initial;
    std::vector<OperatorId> steps;
    std::size_t next = 0;
    for (int step = 0; step < environment_.description().horizon && !reached(state, task.goal); ++step) {
        const Values before = values(state).value();
        if (next == steps.size()) {
            steps = search(*prepared_, {before, goal}, configuration("astar(lmcut())")).plan.value();
            next = 0;
        }
        const std::size_t skill = steps[next++].index();
        environment_.execute(state, skills_[skill], parameters(state, skill), random);
        if (values(state) != successor(before, skill)) next = steps.size();
    }
    return reached(state, task.goal);
}

double AbstractTask::solved_share(int count, const Choice& parameters, Random& random) const {
    int solved = 0;
    for (int i = 0; i < count; ++i)
        solved += solves(environment_.sample_task(random), parameters, random) ? 1 : 0;
    return static_cast<double>(solved) / count;
}

void AbstractTask::expect_practice_goes_on(const State& from) const {
    const Values start = values(from).value();
    for (std::size_t i = 0; i < skills_.size(); ++i) {
        if (applicable(start, i)) continue;
        EXPECT_FALSE(plan(start, ground_->preconditions[i]).empty()) << name(i);
    }
}

}  // namespace praxis::practice::test
