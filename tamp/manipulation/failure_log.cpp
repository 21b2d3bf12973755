#include "tamp/manipulation/failure_log.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tamp/report/describe.hpp"

namespace praxis::tamp {

namespace {

using Reason = TrajectoryDocument::Reason;

Configuration whole(const CollisionProblem& problem, std::span<const double> positions) {
    Configuration configuration = problem.rest;
    problem.robot->insert(problem.robot->groups[static_cast<std::size_t>(problem.group)], positions,
                          configuration);
    return configuration;
}

ActionFailure contact_at(CollisionChecker& checker, const Configuration& positions, const std::string& phase) {
    const CollisionProblem& problem = checker.problem();
    ActionFailure failure{.reason = Reason::collision, .message = phase + " is in collision"};
    checker.find_contacts(positions, failure.contacts);
    if (!failure.contacts.empty()) {
        const auto [first, second] = describe_contact(*problem.robot, *problem.world, failure.contacts.front());
        failure.message += ": '" + first + "' touches '" + second + "'";
    }
    failure.configuration = whole(problem, positions);
    failure.world = problem.world;
    return failure;
}

}  // namespace

ActionFailure contact_on_path(CollisionChecker& checker, const Path& path, const std::string& phase) {
    Configuration point = path.front();
    if (!checker.is_free(point)) return contact_at(checker, point, phase);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        double length = 0;
        for (std::size_t k = 0; k < point.size(); ++k) length += std::pow(path[i + 1][k] - path[i][k], 2);
        const int steps = std::max(1, static_cast<int>(std::ceil(std::sqrt(length) / (kCheckStep / 4))));
        for (int step = 1; step <= steps; ++step) {
            const double share = static_cast<double>(step) / steps;
            for (std::size_t k = 0; k < point.size(); ++k)
                point[k] = path[i][k] + share * (path[i + 1][k] - path[i][k]);
            if (!checker.is_free(point)) return contact_at(checker, point, phase);
        }
    }
    // Only a finer look than this one saw the contact.
    return {.reason = Reason::collision, .message = phase + " is in collision", .definite = false};
}

void FailureLog::keep(const ActionFailure& why) {
    failure_.definite = failure_.definite && why.definite;
    const int weight = why.reason == Reason::kinematics ? 0 : why.reason == Reason::collision ? 1 : 2;
    if (weight <= weight_) return;
    weight_ = weight;
    failure_.reason = why.reason;
    failure_.message = "cannot " + what_ + ": " + why.message;
    failure_.configuration = why.configuration;
    failure_.contacts = why.contacts;
    failure_.world = why.world;
}

void FailureLog::add_fixed(const ActionFailure& why) {
    keep(why);
}

void FailureLog::add_blocked(std::vector<int> bodies, const ActionFailure& why) {
    keep(why);
    std::ranges::sort(bodies);
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
    blocked_.push_back(std::move(bodies));
}

void FailureLog::add_no_path(const std::vector<int>& bodies, const ActionFailure& why) {
    keep(why);
    suspects_.insert(suspects_.end(), bodies.begin(), bodies.end());
    failure_.definite = false;
}

ActionFailure FailureLog::take() {
    std::vector<int> chosen = suspects_;
    if (suspects_.empty() && !blocked_.empty()) {
        std::vector<int> common = blocked_.front();
        for (const std::vector<int>& bodies : blocked_) {
            std::vector<int> both;
            std::ranges::set_intersection(common, bodies, std::back_inserter(both));
            common = std::move(both);
        }
        failure_.each = common.size() > 1;
        chosen = common;
    }
    const auto is_explained = [&](const std::vector<int>& bodies) {
        return std::ranges::any_of(bodies, [&](int body) { return std::ranges::find(chosen, body) != chosen.end(); });
    };
    for (;;) {
        std::vector<std::pair<int, int>> counts;  // how many ways a body explains, less the body
        for (const std::vector<int>& bodies : blocked_) {
            if (is_explained(bodies)) continue;
            for (const int body : bodies) {
                const auto known = std::ranges::find(counts, -body, &std::pair<int, int>::second);
                if (known == counts.end())
                    counts.emplace_back(1, -body);
                else
                    ++known->first;
            }
        }
        if (counts.empty()) break;
        chosen.push_back(-std::ranges::max(counts).second);
    }
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    failure_.bodies = std::move(chosen);
    return std::move(failure_);
}

}  // namespace praxis::tamp
