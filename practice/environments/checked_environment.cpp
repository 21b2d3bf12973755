#include "practice/environments/checked_environment.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace praxis::practice {

namespace {

[[noreturn]] void refuse(const std::string& environment, const std::string& what) {
    throw std::invalid_argument("environment '" + environment + "': " + what);
}

template <class Range>
bool fits(const std::vector<std::int32_t>& objects, const std::vector<Range>& signature) {
    return std::equal(
        objects.begin(), objects.end(), signature.begin(), signature.end(),
        [](std::int32_t object, Range range) { return object >= range.first && object <= range.last; });
}

}  // namespace

CheckedEnvironment::CheckedEnvironment(Description description, Signatures signatures, std::size_t state_size)
    : description_(std::move(description)), signatures_(std::move(signatures)), state_size_(state_size) {
    if (signatures_.predicates.size() != description_.predicates.size() ||
        signatures_.schemas.size() != description_.schemas.size())
        refuse(description_.name, "each predicate and each schema needs its signature");
}

void CheckedEnvironment::check(const State& state) const {
    if (state.size() != state_size_)
        refuse(description_.name, "a state has " + std::to_string(state_size_) + " numbers, not " +
                                      std::to_string(state.size()));
}

const SkillSchema& CheckedEnvironment::checked_schema(const State& state, const GroundSkill& skill) const {
    check(state);
    const auto schema = static_cast<std::size_t>(skill.schema);
    if (skill.schema < 0 || schema >= description_.schemas.size())
        refuse(description_.name, "there is no skill schema number " + std::to_string(skill.schema));
    if (!fits(skill.objects, signatures_.schemas[schema]))
        refuse(description_.name, "skill '" + description_.schemas[schema].name + "' takes " +
                                      std::to_string(signatures_.schemas[schema].size()) +
                                      " objects of its types");
    return description_.schemas[schema];
}

bool CheckedEnvironment::holds(const State& state, const GroundAtom& atom) const {
    check(state);
    const auto predicate = static_cast<std::size_t>(atom.predicate);
    if (atom.predicate < 0 || predicate >= description_.predicates.size())
        refuse(description_.name, "there is no predicate number " + std::to_string(atom.predicate));
    if (!fits(atom.objects, signatures_.predicates[predicate]))
        refuse(description_.name, "predicate '" + description_.predicates[predicate] + "' takes " +
                                      std::to_string(signatures_.predicates[predicate].size()) +
                                      " objects of its types");
    return atom_holds(state, atom);
}

void CheckedEnvironment::propose(const State& state, const GroundSkill& skill, Random& random,
                                 std::span<double> parameters) const {
    if (parameters.size() != checked_schema(state, skill).parameters.size())
        refuse(description_.name, "wrong number of parameters");
    if (!parameters.empty()) draw_parameters(state, skill, random, parameters);
}

void CheckedEnvironment::features(const State& state, const GroundSkill& skill,
                                  std::span<double> features) const {
    if (features.size() != checked_schema(state, skill).features.size())
        refuse(description_.name, "wrong number of features");
    if (!features.empty()) write_features(state, skill, features);
}

void CheckedEnvironment::execute(State& state, const GroundSkill& skill, std::span<const double> parameters,
                                 Random& random) const {
    const SkillSchema& schema = checked_schema(state, skill);
    if (parameters.size() != schema.parameters.size())
        refuse(description_.name, "skill '" + schema.name + "' takes " +
                                      std::to_string(schema.parameters.size()) + " parameters, not " +
                                      std::to_string(parameters.size()));
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (!std::isfinite(parameters[i]))
            refuse(description_.name,
                   "parameter '" + schema.parameters[i] + "' of skill '" + schema.name + "' is not finite");
    }
    if (can_start(state, skill)) act(state, skill, parameters, random);
}

}  // namespace praxis::practice
