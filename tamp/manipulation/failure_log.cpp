#include "tamp/manipulation/failure_log.hpp"

#include <algorithm>
#include <cmath>

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

/// The bodies of a contact that an action could move: those that stand and are movable.
void append_movable(const World& world, const Contact& contact, std::vector<int>& bodies) {
    for (const Participant& participant : {contact.first, contact.second}) {
        if (participant.kind != Participant::Kind::body) continue;
        const BodyState& body = world[participant.index];
        if (body.model->movable && !body.attachment) bodies.push_back(participant.index);
    }
}

}  // namespace

void FailureLog::keep(Reason reason, const std::string& message) {
    const int weight = static_cast<int>(reason == Reason::kinematics  ? 0
                                        : reason == Reason::collision ? 1
                                                                      : 2);
    if (weight <= weight_) return;
    weight_ = weight;
    failure_.reason = reason;
    failure_.message = "cannot " + what_ + ": " + message;
}

void FailureLog::blame(int body) {
    if (std::ranges::find(failure_.bodies, body) == failure_.bodies.end()) failure_.bodies.push_back(body);
}

void FailureLog::add_unreachable(const std::string& message, bool definite) {
    keep(Reason::kinematics, message);
    failure_.definite = failure_.definite && definite;
}

bool FailureLog::add_contact(CollisionChecker& checker, std::span<const double> positions,
                             const std::string& phase) {
    const CollisionProblem& problem = checker.problem();
    std::vector<Contact> contacts;
    checker.find_contacts(positions, contacts);
    std::vector<int> movable;
    bool fixed = contacts.empty();
    bool of_hand = false;
    for (const Contact& contact : contacts) {
        of_hand = of_hand || is_of_hand(*problem.world, contact);
        const std::size_t before = movable.size();
        append_movable(*problem.world, contact, movable);
        if (movable.size() == before) fixed = true;
    }
    if (!fixed) {
        const auto known = std::ranges::find_if(movable, [&](int body) {
            return std::ranges::find(failure_.bodies, body) != failure_.bodies.end();
        });
        if (known == movable.end()) blame(movable.front());
    }
    std::string message = phase + " is in collision";
    if (!contacts.empty()) {
        const auto [first, second] = describe_contact(*problem.robot, *problem.world, contacts.front());
        message += ": '" + first + "' touches '" + second + "'";
    }
    keep(Reason::collision, message);
    if (failure_.contacts.empty()) {
        failure_.contacts = std::move(contacts);
        failure_.configuration = whole(problem, positions);
        failure_.world = problem.world;
    }
    return of_hand;
}

bool FailureLog::is_of_hand(const World& world, const Contact& contact) const {
    const auto moves_with_hand = [&](const Participant& who) {
        if (who.kind == Participant::Kind::link)
            return std::ranges::find(hand_links_, who.index) != hand_links_.end();
        return world[who.index].attachment.has_value();
    };
    const auto stands = [&](const Participant& who) {
        return who.kind == Participant::Kind::body && !world[who.index].attachment;
    };
    return (moves_with_hand(contact.first) && stands(contact.second)) ||
           (moves_with_hand(contact.second) && stands(contact.first));
}

bool FailureLog::add_blocked_path(CollisionChecker& checker, const Path& path, const std::string& phase) {
    Configuration point = path.front();
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        double length = 0;
        for (std::size_t k = 0; k < point.size(); ++k) length += std::pow(path[i + 1][k] - path[i][k], 2);
        const int steps = std::max(1, static_cast<int>(std::ceil(std::sqrt(length) / (kCheckStep / 4))));
        for (int step = 0; step <= steps; ++step) {
            const double share = static_cast<double>(step) / steps;
            for (std::size_t k = 0; k < point.size(); ++k) {
                point[k] = path[i][k] + share * (path[i + 1][k] - path[i][k]);
            }
            if (!checker.is_free(point)) {
                return add_contact(checker, point, phase);
            }
        }
    }
    // Only a finer look than this one saw the contact.
    failure_.definite = false;
    keep(Reason::collision, phase + " is in collision");
    return false;
}

void FailureLog::add_no_path(const CollisionProblem& problem, const std::vector<int>& bodies,
                             const std::string& phase) {
    failure_.definite = false;
    std::string names;
    for (const int body : bodies) {
        const BodyState& state = (*problem.world)[body];
        if (!state.model->movable || state.attachment) continue;
        blame(body);
        names += (names.empty() ? "" : ", ") + ("'" + state.model->name + "'");
    }
    keep(Reason::no_path, "no path found for " + phase + (names.empty() ? "" : "; in the way: " + names));
}

ActionFailure FailureLog::take() {
    std::ranges::sort(failure_.bodies);
    return std::move(failure_);
}

}  // namespace praxis::tamp
