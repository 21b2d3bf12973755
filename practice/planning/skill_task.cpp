#include "practice/planning/skill_task.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <unordered_map>

#include "parser/parser.hpp"
#include "search/ground/ground.hpp"

namespace praxis::practice {

namespace {

/// The numbers of names, and of the words of a table of names by those numbers.
class Numbers {
  public:
    Numbers(std::span<const std::string> names, const char* kind) : kind_(kind) {
        for (const std::string& name : names) {
            const auto number = static_cast<std::int32_t>(numbers_.size());
            if (!numbers_.emplace(name, number).second)
                throw std::invalid_argument(std::string("two ") + kind + "s are named '" + name + "'");
        }
    }
    std::int32_t operator[](const std::string& name) const {
        const auto found = numbers_.find(name);
        if (found == numbers_.end())
            throw std::invalid_argument(std::string("the environment does not know the ") + kind_ + " '" +
                                        name + "' of its domain");
        return found->second;
    }

  private:
    const char* kind_;
    std::unordered_map<std::string_view, std::int32_t> numbers_;
};

std::vector<std::string> names_of(std::span<const SkillSchema> schemas) {
    std::vector<std::string> names;
    for (const SkillSchema& schema : schemas) names.push_back(schema.name);
    return names;
}

/// Words of a name: the first by one table, the others by another.
std::pair<std::int32_t, std::vector<std::int32_t>> numbers_of(const NameTable& table, std::size_t name,
                                                              const Numbers& first, const Numbers& others) {
    const std::span<const std::uint32_t> words = table.names[name];
    std::pair<std::int32_t, std::vector<std::int32_t>> result{first[table.symbols[words[0]]], {}};
    for (std::uint32_t word : words.subspan(1)) result.second.push_back(others[table.symbols[word]]);
    return result;
}

/// Tasks bring goals of their own; that of the problem must not make anything impossible.
Task without_goal(const LiftedTask& task) {
    auto result = std::make_shared<LiftedTask>(task);
    result->goal_scope = {};
    result->goal = {};
    result->goal.kind = Connective::conjunction;
    return result;
}

template <class Id, class Items>
Id find_id(const Items& items, const std::string& name, const char* kind) {
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (items[i].name == name) return Id(static_cast<std::uint32_t>(i));
    }
    throw std::invalid_argument(std::string("the domain has no ") + kind + " '" + name + "'");
}

/// The name that an atom of a goal means by a number.
const std::string& name_of(const std::vector<std::string>& names, std::int32_t number, const char* kind) {
    if (number >= 0 && static_cast<std::size_t>(number) < names.size())
        return names[static_cast<std::size_t>(number)];
    throw std::invalid_argument("a goal has an atom of " + std::string(kind) + " " + std::to_string(number) +
                                "; the environment's description has " + std::to_string(names.size()) + " " +
                                kind + "s, numbered from 0");
}

}  // namespace

SkillTask::SkillTask(const Environment& environment) : environment_(&environment) {
    const Description& description = environment.description();
    const Task parsed = parse_task({description.name + " domain", description.domain},
                                   {description.name + " problem", description.problem})
                            .task;
    lifted_ = without_goal(*parsed);
    const GroundResult grounded = ground(*lifted_, {.prune_irrelevant = false});
    atoms_ = std::make_unique<const AtomIndex>(*lifted_, *grounded.task);
    prepared_ = std::make_shared<const PreparedTask>(grounded.task);
    bind_skills();
    bind_variables();
}

void SkillTask::bind_skills() {
    const Description& description = environment_->description();
    const std::vector<std::string> schema_names = names_of(description.schemas);
    const Numbers schemas(schema_names, "skill");
    const Numbers objects(description.objects, "object");
    for (std::size_t i = 0; i < task().operator_count(); ++i) {
        auto [schema, arguments] = numbers_of(task().operator_names, i, schemas, objects);
        skills_.push_back({schema, std::move(arguments)});
    }
}

void SkillTask::bind_variables() {
    const Description& description = environment_->description();
    const Numbers predicates(description.predicates, "predicate");
    const Numbers objects(description.objects, "object");
    places_.resize(task().variable_count());
    empty_values_.assign(task().variable_count(), -1);
    for (std::size_t variable = 0; variable < places_.size(); ++variable) {
        if (task().derived(static_cast<std::int32_t>(variable))) continue;
        for (std::int32_t value = 0; value < task().domain_sizes[variable]; ++value) {
            const std::uint32_t fact = task().fact_number({static_cast<std::int32_t>(variable), value});
            if (task().fact_forms[fact] != FiniteDomainTask::FactForm::atom) {
                empty_values_[variable] = value;
                continue;
            }
            auto [predicate, arguments] = numbers_of(task().fact_names, fact, predicates, objects);
            places_[variable].push_back({value, {predicate, std::move(arguments)}});
        }
    }
}

const SkillSchema& SkillTask::schema(SkillIndex i) const {
    return environment_->description().schemas[static_cast<std::size_t>(skills_[i].schema)];
}

SkillIndex SkillTask::find(const std::string& name) const {
    for (SkillIndex i = 0; i < size(); ++i) {
        if (this->name(i) == name) return i;
    }
    throw std::invalid_argument("there is no skill " + name);
}

void SkillTask::read(const State& state, std::vector<std::int32_t>& values) const {
    values = task().initial_values;
    for (std::size_t variable = 0; variable < places_.size(); ++variable) {
        if (places_[variable].empty()) continue;
        const Place* found = nullptr;
        for (const Place& place : places_[variable]) {
            if (!environment_->holds(state, place.atom)) continue;
            if (found != nullptr)
                throw std::logic_error(
                    "the environment says that two facts hold of which the domain allows one: " +
                    task().fact_name({static_cast<std::int32_t>(variable), found->value}) + " and " +
                    task().fact_name({static_cast<std::int32_t>(variable), place.value}));
            found = &place;
        }
        values[variable] = found != nullptr ? found->value : empty_values_[variable];
        if (values[variable] < 0)
            throw std::logic_error("the environment says that no fact holds of those of which one must: " +
                                   task().fact_name({static_cast<std::int32_t>(variable), 0}) + ", ...");
    }
    AxiomEvaluator::Scratch scratch;
    prepared_->parts().axioms.complete(values.data(), scratch);
}

std::vector<Fact> SkillTask::goal(std::span<const GroundAtom> atoms) const {
    const Description& description = environment_->description();
    std::vector<Fact> facts;
    for (const GroundAtom& atom : atoms) {
        const std::string& predicate = name_of(description.predicates, atom.predicate, "predicate");
        std::vector<ObjectId> arguments;
        std::string text = "(" + predicate;
        for (std::int32_t object : atom.objects) {
            const std::string& name = name_of(description.objects, object, "object");
            arguments.push_back(find_id<ObjectId>(lifted_->objects, name, "object"));
            text += " " + name;
        }
        const std::uint32_t entry =
            atoms_->find(find_id<PredicateId>(lifted_->predicates, predicate, "predicate"), arguments);
        if (entry == AtomIndex::kAbsent)
            throw std::invalid_argument("no skills can make the goal " + text + ") true");
        if ((*atoms_)[entry].kind == AtomIndex::Entry::Kind::fact) facts.push_back((*atoms_)[entry].fact);
    }
    std::sort(facts.begin(), facts.end());
    return facts;
}

bool SkillTask::holds(std::span<const Fact> facts, const State& state) const {
    std::vector<std::int32_t> values;
    read(state, values);
    return all_hold(facts, values.data());
}

bool SkillTask::succeeded(SkillIndex i, const std::vector<std::int32_t>& before,
                          const std::vector<std::int32_t>& after) const {
    for (const GroundEffect& effect : task().effects[i]) {
        if (task().fact_forms[task().fact_number(effect.fact)] != FiniteDomainTask::FactForm::atom) continue;
        if (effect.condition != 0 && !all_hold(task().conditions[effect.condition], before.data())) continue;
        if (after[static_cast<std::size_t>(effect.fact.variable)] != effect.fact.value) return false;
    }
    return true;
}

}  // namespace praxis::practice
