#include "practice/environments/stated_environment.hpp"

#include <array>
#include <stdexcept>

namespace praxis::practice {

double StatedEnvironment::success_probability(const State& state, const GroundSkill& skill,
                                              std::span<const double> parameters) const {
    if (parameters.empty()) return 1;
    std::array<double, 8> best{};
    if (parameters.size() > best.size()) throw std::invalid_argument("a skill has at most 8 parameters");
    const std::span<double> optimal(best.data(), parameters.size());
    optimum(state, skill, optimal);
    return model(state, skill).probability(euclidean_distance(parameters, optimal));
}

void StatedEnvironment::act(State& state, const GroundSkill& skill, std::span<const double> parameters,
                            Random& random) const {
    if (uniform(random) < success_probability(state, skill, parameters))
        succeed(state, skill, random);
    else
        fail(state, skill, random);
}

void StatedEnvironment::draw_parameters(const State&, const GroundSkill&, Random& random,
                                        std::span<double> parameters) const {
    for (double& parameter : parameters) parameter = uniform(random, -1, 1);
}

}  // namespace praxis::practice
