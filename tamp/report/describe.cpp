#include "tamp/report/describe.hpp"

#include <algorithm>

#include "tamp/scenes/occupancy_map.hpp"

namespace praxis::tamp {

namespace {

using Document = TrajectoryDocument;

/// Occupied cells, without those that others hide on all sides.
Document::Voxels describe_voxels(const OccupancyMap& map) {
    const VoxelGrid& grid = map.grid();
    const auto occupied = [&](int i, int j, int k) {
        return grid.has(i, j, k) && map.cells()[grid.index(i, j, k)] == Occupancy::occupied;
    };
    Document::Voxels voxels;
    voxels.edge = grid.edge;
    for (int k = 0; k < grid.cells[2]; ++k)
        for (int j = 0; j < grid.cells[1]; ++j)
            for (int i = 0; i < grid.cells[0]; ++i) {
                if (!occupied(i, j, k)) continue;
                const bool hidden = occupied(i - 1, j, k) && occupied(i + 1, j, k) && occupied(i, j - 1, k) &&
                                    occupied(i, j + 1, k) && occupied(i, j, k - 1) && occupied(i, j, k + 1);
                if (hidden) continue;
                const Vector3 cell(i + 0.5, j + 0.5, k + 0.5);
                voxels.centers.emplace_back(Vector3(grid.origin[0], grid.origin[1], grid.origin[2]) +
                                            grid.edge * cell);
            }
    return voxels;
}

struct DescribeShape {
    Document::PlacedShape& result;

    template <class Shape>
    void operator()(const Shape& shape) const {
        result.shape = shape;
    }
    void operator()(const std::shared_ptr<const OccupancyMap>& map) const {
        result.shape = describe_voxels(*map);
    }
};

Document::PlacedShape describe_shape(const PlacedShape& placed) {
    Document::PlacedShape result;
    result.pose = to_numbers(placed.pose);
    std::visit(DescribeShape{result}, placed.shape);
    return result;
}

std::vector<Document::PlacedShape> describe_shapes(const std::vector<PlacedShape>& shapes) {
    std::vector<Document::PlacedShape> result;
    for (const PlacedShape& shape : shapes) result.push_back(describe_shape(shape));
    return result;
}

Document::Link describe_link(const Robot& robot, const Link& link) {
    Document::Link result;
    result.name = link.name;
    result.shapes = describe_shapes(link.visual.empty() ? link.collision : link.visual);
    if (link.parent_joint < 0) return result;
    const Joint& joint = robot.joints[static_cast<std::size_t>(link.parent_joint)];
    result.parent = joint.parent;
    result.origin = to_numbers(joint.origin);
    result.type = joint.type;
    result.axis = {joint.axis.x(), joint.axis.y(), joint.axis.z()};
    result.variable = joint.variable;
    result.multiplier = joint.multiplier;
    result.offset = joint.offset;
    return result;
}

Document::Robot describe_robot(const Robot& robot) {
    Document::Robot result;
    result.name = robot.name;
    result.base = to_numbers(robot.base);
    for (const Variable& variable : robot.variables) result.variables.push_back(variable.name);
    for (const Link& link : robot.links) result.links.push_back(describe_link(robot, link));
    for (const EndEffector& hand : robot.end_effectors)
        result.tools.push_back({hand.name, hand.link, to_numbers(hand.tool)});
    return result;
}

Document::Body describe_body(const BodyState& state, const std::vector<Pose>& links) {
    Document::Body result;
    const BodyModel& model = *state.model;
    result.name = model.name;
    const Pose pose =
        state.attachment ? links[static_cast<std::size_t>(state.attachment->link)] * state.attachment->in_link
                         : state.pose;
    result.pose = to_numbers(pose);
    result.shapes = describe_shapes(model.shapes);
    for (std::size_t i = 0; i < 3; ++i) result.color[i] = std::clamp<double>(model.color[i], 0, 1);
    result.movable = model.movable;
    return result;
}

const std::string& name_of(const Robot& robot, const World& world, const Participant& participant) {
    return participant.kind == Participant::Kind::link
               ? robot.links[static_cast<std::size_t>(participant.index)].name
               : world[participant.index].model->name;
}

}  // namespace

TrajectoryDocument begin_document(const Robot& robot, const World& world, const Configuration& start) {
    Document document;
    document.robot = describe_robot(robot);
    document.start = start;
    std::vector<Pose> links(robot.links.size());
    forward_kinematics(robot, start, links);
    for (std::size_t i = 0; i < world.size(); ++i) {
        const int body = static_cast<int>(i);
        const BodyState& state = world[body];
        document.bodies.push_back(describe_body(state, links));
        if (state.attachment) document.held.push_back(describe_hold(robot, world, body, *state.attachment));
    }
    return document;
}

TrajectoryDocument::Segment describe_motion(const Group& group, const Trajectory& trajectory, int action,
                                            TrajectoryDocument::Motion kind, double start) {
    Document::Segment segment;
    segment.action = action;
    segment.kind = kind;
    segment.start = start;
    segment.end = start + trajectory.duration();
    segment.variables = group.variables;
    segment.knots = trajectory.knots;
    for (Trajectory::Knot& knot : segment.knots) knot.time += start;
    return segment;
}

TrajectoryDocument::Hold describe_hold(const Robot& robot, const World& world, int body,
                                       const Attachment& attachment) {
    return {world[body].model->name, robot.links[static_cast<std::size_t>(attachment.link)].name,
            to_numbers(attachment.in_link)};
}

TrajectoryDocument::Stand describe_stand(const World& world, int body, const Pose& pose) {
    return {world[body].model->name, to_numbers(pose)};
}

std::pair<std::string, std::string> describe_contact(const Robot& robot, const World& world,
                                                     const Contact& contact) {
    return {name_of(robot, world, contact.first), name_of(robot, world, contact.second)};
}

TrajectoryDocument::Attempt describe_attempt(const Robot& robot, const World& first, const World& world,
                                             const Configuration& configuration,
                                             const std::vector<Contact>& contacts) {
    Document::Attempt attempt;
    attempt.reason = Document::Reason::collision;
    attempt.configuration = configuration;
    for (std::size_t i = 0; i < world.size(); ++i) {
        const int body = static_cast<int>(i);
        const BodyState& state = world[body];
        if (state.attachment) {
            attempt.held = describe_hold(robot, world, body, *state.attachment);
        } else if (first[body].attachment || !first[body].pose.isApprox(state.pose, 1e-12)) {
            attempt.elsewhere.push_back(describe_stand(world, body, state.pose));
        }
    }
    for (const Contact& contact : contacts)
        attempt.contacts.push_back(describe_contact(robot, world, contact));
    return attempt;
}

}  // namespace praxis::tamp
