#include "tamp/report/replay.hpp"

#include <algorithm>
#include <limits>

namespace praxis::tamp {

namespace {

using Document = TrajectoryDocument;

Pose joint_motion(const Document::Link& link, double position) {
    Pose motion = Pose::Identity();
    const Vector3 axis = Vector3(link.axis[0], link.axis[1], link.axis[2]).normalized();
    if (link.type == JointType::prismatic) {
        motion.translate(position * axis);
    } else if (link.type != JointType::fixed) {
        motion.rotate(Eigen::AngleAxisd(position, axis));
    }
    return motion;
}

/// The last knot that is not after `time`; the first if all are.
const Trajectory::Knot& knot_at(const Document::Segment& segment, double time) {
    const auto after = std::ranges::upper_bound(segment.knots, time, {}, &Trajectory::Knot::time);
    return after == segment.knots.begin() ? segment.knots.front() : *std::prev(after);
}

}  // namespace

std::vector<Pose> link_poses(const TrajectoryDocument::Robot& robot, std::span<const double> configuration) {
    std::vector<Pose> poses;
    poses.reserve(robot.links.size());
    for (const Document::Link& link : robot.links) {
        const double position =
            link.variable < 0
                ? link.offset
                : link.multiplier * configuration[static_cast<std::size_t>(link.variable)] + link.offset;
        const Pose& parent =
            link.parent < 0 ? pose_from_numbers(robot.base) : poses[static_cast<std::size_t>(link.parent)];
        poses.push_back(parent * pose_from_numbers(link.origin) * joint_motion(link, position));
    }
    return poses;
}

Replay::Replay(const TrajectoryDocument& document)
    : document_(document), pieces_(document.robot.variables.size()), changes_(document.bodies.size()) {
    check_document(document);
    for (std::vector<Change>& changes : changes_)
        changes.push_back({-std::numeric_limits<double>::infinity(), nullptr, nullptr});
    const auto changes_of = [&](const std::string& body) -> std::vector<Change>& {
        return changes_[static_cast<std::size_t>(document.find_body(body))];
    };
    for (const Document::Hold& hold : document.held) changes_of(hold.body).front().hold = &hold;
    for (const Document::Segment& segment : document.segments) {
        if (!segment.knots.empty())
            for (std::size_t k = 0; k < segment.variables.size(); ++k)
                pieces_[static_cast<std::size_t>(segment.variables[k])].push_back({&segment, k});
        if (segment.attach)
            changes_of(segment.attach->body).push_back({segment.end, &*segment.attach, nullptr});
        if (segment.detach)
            changes_of(segment.detach->body).push_back({segment.end, nullptr, &*segment.detach});
    }
    for (std::vector<Change>& changes : changes_) std::ranges::stable_sort(changes, {}, &Change::time);
}

RobotMotion Replay::motion_at(double time) const {
    const std::size_t size = document_.start.size();
    RobotMotion motion{document_.start, Configuration(size, 0), Configuration(size, 0)};
    for (std::size_t v = 0; v < size; ++v) {
        const std::vector<Piece>& pieces = pieces_[v];
        const auto after = std::ranges::upper_bound(pieces, time, {},
                                                    [](const Piece& piece) { return piece.segment->start; });
        if (after == pieces.begin()) continue;
        const Piece& piece = *std::prev(after);
        if (time >= piece.segment->end) {
            motion.positions[v] = piece.segment->knots.back().positions[piece.column];
            continue;
        }
        const Trajectory::Knot& knot = knot_at(*piece.segment, time);
        const double elapsed = time - knot.time;
        const double velocity = knot.velocities[piece.column];
        const double acceleration = knot.accelerations[piece.column];
        motion.positions[v] =
            knot.positions[piece.column] + elapsed * (velocity + 0.5 * elapsed * acceleration);
        motion.velocities[v] = velocity + elapsed * acceleration;
        motion.accelerations[v] = acceleration;
    }
    return motion;
}

const Replay::Change& Replay::last_change(std::size_t body, double time) const {
    const std::vector<Change>& changes = changes_[body];
    return *std::prev(std::ranges::upper_bound(changes, std::max(time, 0.0), {}, &Change::time));
}

std::vector<std::string> Replay::held_at(double time) const {
    std::vector<std::string> result;
    for (std::size_t b = 0; b < changes_.size(); ++b)
        if (last_change(b, time).hold) result.push_back(document_.bodies[b].name);
    return result;
}

std::vector<Pose> Replay::links_at(double time) const {
    return link_poses(document_.robot, motion_at(time).positions);
}

std::vector<Pose> Replay::bodies_at(double time) const {
    const std::vector<Pose> links = links_at(time);
    std::vector<Pose> result;
    for (std::size_t b = 0; b < changes_.size(); ++b) {
        const Change& change = last_change(b, time);
        if (change.hold) {
            const auto link = static_cast<std::size_t>(document_.find_link(change.hold->link));
            result.push_back(links[link] * pose_from_numbers(change.hold->pose));
        } else {
            result.push_back(pose_from_numbers(change.stand ? change.stand->pose : document_.bodies[b].pose));
        }
    }
    return result;
}

}  // namespace praxis::tamp
