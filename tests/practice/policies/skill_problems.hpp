// Small problems of choosing a skill's parameters, for tests and measurements of classifiers: a situation is
// drawn, candidates are proposed in it, and each is a row of numbers that succeeds or not.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "practice/environment.hpp"
#include "practice/policies/classifier.hpp"

namespace praxis::practice::test {

struct Trial {
    std::vector<float> row;
    bool success = false;
};

struct SkillProblem {
    std::string name;
    std::size_t width;
    std::vector<double> (*situation)(Random& random);
    Trial (*propose)(const std::vector<double>& situation, Random& random);
};

constexpr double kTableRadius = 0.098;
constexpr double kSafeRadius = 0.35 * kTableRadius;

struct Point {
    double x, y;
};

inline Point in_disc(double radius, Random& random) {
    const double angle = uniform(random, 0, 2 * std::numbers::pi);
    const double distance = radius * std::sqrt(uniform(random));
    return {distance * std::cos(angle), distance * std::sin(angle)};
}

/// One of five tables on a circle, with a safe disc somewhere on it: table x, y, disc x, y.
inline std::vector<double> table_with_disc(Random& random) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(random.below(5)) / 5;
    const Point table{0.5 + std::cos(angle) / 3, 0.5 + std::sin(angle) / 3};
    const Point offset = in_disc(kTableRadius - kSafeRadius, random);
    return {table.x, table.y, table.x + offset.x, table.y + offset.y};
}

inline std::vector<float> floats(std::initializer_list<double> values) {
    std::vector<float> result;
    for (const double value : values) result.push_back(static_cast<float>(value));
    return result;
}

/// Somewhere on the table; it succeeds inside the disc. Seen relative to the disc, or raw.
inline Trial place(const std::vector<double>& s, Random& random, bool relative) {
    const Point offset = in_disc(kTableRadius, random);
    const Point at{s[0] + offset.x, s[1] + offset.y};
    const Point away{at.x - s[2], at.y - s[3]};
    const double distance = std::hypot(away.x, away.y);
    return {relative ? floats({away.x, away.y, distance})
                     : floats({s[0], s[1], kTableRadius, s[2], s[3], at.x, at.y}),
            distance < kSafeRadius};
}

inline SkillProblem relative_placing() {
    return {"ball-ring relative", 3, table_with_disc,
            [](const std::vector<double>& s, Random& random) { return place(s, random, true); }};
}
inline SkillProblem raw_placing() {
    return {"ball-ring raw", 7, table_with_disc,
            [](const std::vector<double>& s, Random& random) { return place(s, random, false); }};
}

/// A dimmer is turned by d, from a level towards a target.
inline SkillProblem dimming() {
    return {"light", 3,
            [](Random& random) {
                const double level = uniform(random);
                return std::vector<double>{level, uniform(random)};
            },
            [](const std::vector<double>& s, Random& random) {
                const double turn = uniform(random, -1, 1);
                return Trial{floats({s[0], s[1], turn}),
                             std::abs(std::clamp(s[0] + turn, 0.0, 1.0) - s[1]) < 0.1};
            }};
}

/// So many trials of the base sampler; more, if not both outcomes are among them.
inline Examples examples(const SkillProblem& problem, std::size_t count, Random& random) {
    Examples result;
    result.width = problem.width;
    std::size_t successes = 0;
    while (result.size() < count || successes == 0 || successes == result.size()) {
        const Trial trial = problem.propose(problem.situation(random), random);
        result.rows.insert(result.rows.end(), trial.row.begin(), trial.row.end());
        result.success.push_back(trial.success ? 1 : 0);
        successes += trial.success ? 1 : 0;
    }
    return result;
}

/// How often the likeliest of 100 candidates succeeds, over so many new situations.
inline double success_of_best(const SkillProblem& problem, const Classifier& classifier, int situations,
                              Random& random) {
    constexpr std::size_t kCandidates = 100;
    int successes = 0;
    for (int s = 0; s < situations; ++s) {
        const std::vector<double> situation = problem.situation(random);
        std::vector<float> rows;
        std::vector<bool> outcomes;
        for (std::size_t c = 0; c < kCandidates; ++c) {
            const Trial trial = problem.propose(situation, random);
            rows.insert(rows.end(), trial.row.begin(), trial.row.end());
            outcomes.push_back(trial.success);
        }
        std::vector<float> probabilities(kCandidates);
        classifier.probabilities(rows, probabilities);
        const auto best =
            std::max_element(probabilities.begin(), probabilities.end()) - probabilities.begin();
        successes += outcomes[static_cast<std::size_t>(best)] ? 1 : 0;
    }
    return static_cast<double>(successes) / situations;
}

}  // namespace praxis::practice::test
