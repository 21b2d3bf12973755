#include "tamp/skills/simulated_driver.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "tamp/report/replay.hpp"

namespace praxis::tamp {

namespace {

using Document = TrajectoryDocument;

Pose pose_of_link(const Document& scene, const Configuration& positions, const std::string& link) {
    return link_poses(scene.robot, positions)[static_cast<std::size_t>(scene.find_link(link))];
}

}  // namespace

SimulatedDriver::SimulatedDriver(Document scene, const SimulationOptions& options)
    : scene_(std::move(scene)), options_(options), random_(options.seed), positions_(scene_.start) {
    check_document(scene_);
    if (!(options.noise >= 0) || !(options.slip >= 0) || !(options.slip <= 1) || !(options.reach > 0))
        throw std::invalid_argument("noise must be >= 0, slip from 0 to 1, reach > 0");
    for (const Document::Body& body : scene_.bodies) stands_[body.name] = pose_from_numbers(body.pose);
    for (const Document::Hold& hold : scene_.held) holds_[hold.body] = hold;
}

double SimulatedDriver::chance() {
    return static_cast<double>(random_.next() >> 11) * 0x1.0p-53;
}

Configuration SimulatedDriver::positions() {
    Configuration measured = positions_;
    if (options_.noise > 0)
        for (double& position : measured) position += options_.noise * (2 * chance() - 1);
    return measured;
}

Pose SimulatedDriver::pose_of(const std::string& name) const {
    const auto hold = holds_.find(name);
    if (hold == holds_.end()) return stands_.at(name);
    return pose_of_link(scene_, positions_, hold->second.link) * pose_from_numbers(hold->second.pose);
}

BodyPoses SimulatedDriver::bodies() {
    BodyPoses result;
    for (const Document::Body& body : scene_.bodies)
        if (body.movable) result[body.name] = pose_of(body.name);
    return result;
}

Execution SimulatedDriver::command(const RobotCommand& command) {
    positions_ = command.positions;
    return {};
}

Execution SimulatedDriver::grasp(const Document::Hold& hold) {
    if (chance() < options_.slip) return {Execution::Status::failed, "the hand slips off " + hold.body};
    const Pose link = pose_of_link(scene_, positions_, hold.link);
    const Pose now = pose_of(hold.body);
    const Vector3 planned = (link * pose_from_numbers(hold.pose)).translation();
    if ((now.translation() - planned).norm() > options_.reach)
        return {Execution::Status::failed, "the hand closes on nothing: " + hold.body + " is not there"};
    holds_[hold.body] = {hold.body, hold.link, to_numbers(link.inverse() * now)};
    return {};
}

Execution SimulatedDriver::release(const Document::Stand& stand) {
    if (!holds_.contains(stand.body)) return {Execution::Status::failed, stand.body + " is not in the hand"};
    put(stand.body, pose_of(stand.body));
    return {};
}

void SimulatedDriver::wait_until(double seconds) {
    seconds_ = std::max(seconds_, seconds);
}

void SimulatedDriver::put(const std::string& name, const Pose& pose) {
    if (scene_.find_body(name) < 0) throw std::invalid_argument("there is no body '" + name + "'");
    holds_.erase(name);
    stands_[name] = pose;
}

void SimulatedDriver::put_robot(Configuration positions) {
    if (positions.size() != positions_.size())
        throw std::invalid_argument("the robot has " + std::to_string(positions_.size()) + " variables");
    positions_ = std::move(positions);
}

}  // namespace praxis::tamp
