#include "tamp/sampling/grasps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tamp/geometry/extent.hpp"

namespace praxis::tamp {

namespace {

/// Collects grasps, each given by where the tool is in the body and how its axes lie there.
class Collector {
  public:
    Collector(const EndEffector& effector, const GraspOptions& options)
        : widest_(effector.max_opening - options.clearance) {}

    /// The tool's origin at `place`, its z along `approach` and its y along `fingers`, and the same turned by
    /// half a turn about z.
    void add(const Vector3& place, const Vector3& approach, const Vector3& fingers, double width) {
        if (width > widest_) return;
        for (const double sign : {1.0, -1.0}) {
            Pose tool_in_body = Pose::Identity();
            tool_in_body.translation() = place;
            tool_in_body.linear().col(2) = approach;
            tool_in_body.linear().col(1) = sign * fingers;
            tool_in_body.linear().col(0) = (sign * fingers).cross(approach);
            grasps_.push_back({tool_in_body.inverse(), width, approach});
        }
    }

    std::vector<Grasp> take() { return std::move(grasps_); }

  private:
    double widest_;
    std::vector<Grasp> grasps_;
};

/// Places along a side from -length/2 to length/2 where fingers of a width fit: the middle first, then
/// outwards.
std::vector<double> places_along(double length, const GraspOptions& options) {
    const double reach = (length - options.finger_width) / 2;
    std::vector<double> places = {0};
    if (reach <= options.finger_width / 2) return places;
    for (int i = 1; i < options.places; ++i) {
        const int ring = (i + 1) / 2;
        const double share = static_cast<double>(ring) / ((options.places) / 2);
        places.push_back((i % 2 == 1 ? share : -share) * reach);
    }
    return places;
}

/// How far from the middle the tool stays when it comes along a side of this half length.
double stand_off(double half_length, const GraspOptions& options) {
    return std::max(0.0, half_length - options.depth);
}

void add_box_face(const Vector3& size, int approach_axis, double approach_sign, const GraspOptions& options,
                  Collector& collector) {
    const Vector3 approach = approach_sign * Vector3::Unit(approach_axis);
    for (int turn = 1; turn <= 2; ++turn) {
        const int finger_axis = (approach_axis + turn) % 3;
        const int along = 3 - approach_axis - finger_axis;
        for (const double offset : places_along(size[along], options)) {
            const Vector3 place =
                -stand_off(size[approach_axis] / 2, options) * approach + offset * Vector3::Unit(along);
            collector.add(place, approach, Vector3::Unit(finger_axis), size[finger_axis]);
        }
    }
}

/// A body of revolution about z.
void add_round(double radius, double length, const GraspOptions& options, Collector& collector) {
    const auto direction = [](double angle) { return Vector3(std::cos(angle), std::sin(angle), 0); };
    const auto along_axis = [&](double sign) {
        const Vector3 approach = sign * Vector3::UnitZ();
        // Half turns are added by the collector.
        for (int i = 0; i < options.turns; ++i) {
            collector.add(-stand_off(length / 2, options) * approach, approach,
                          direction(std::numbers::pi * i / options.turns), 2 * radius);
        }
    };
    if (options.top) along_axis(-1);
    if (options.side) {
        for (const double height : places_along(length, options)) {
            for (int i = 0; i < options.turns; ++i) {
                const Vector3 approach = direction(2 * std::numbers::pi * i / options.turns);
                collector.add(-stand_off(radius, options) * approach + height * Vector3::UnitZ(), approach,
                              Vector3::UnitZ().cross(approach), 2 * radius);
            }
        }
    }
    if (options.bottom) along_axis(1);
}

void add_box(const Vector3& size, const GraspOptions& options, Collector& collector) {
    if (options.top) add_box_face(size, 2, -1, options, collector);
    if (options.side) {
        for (int axis = 0; axis < 2; ++axis) {
            for (const double sign : {-1.0, 1.0}) add_box_face(size, axis, sign, options, collector);
        }
    }
    if (options.bottom) add_box_face(size, 2, 1, options, collector);
}

}  // namespace

std::vector<Grasp> make_grasps(const BodyModel& body, const EndEffector& effector,
                               const GraspOptions& options) {
    Collector collector(effector, options);
    Pose frame = Pose::Identity();
    const bool single = body.shapes.size() == 1;
    if (single) frame = body.shapes[0].pose;
    if (single && std::holds_alternative<Cylinder>(body.shapes[0].shape)) {
        const auto& shape = std::get<Cylinder>(body.shapes[0].shape);
        add_round(shape.radius, shape.length, options, collector);
    } else if (single && std::holds_alternative<Capsule>(body.shapes[0].shape)) {
        const auto& shape = std::get<Capsule>(body.shapes[0].shape);
        add_round(shape.radius, shape.length + 2 * shape.radius, options, collector);
    } else if (single && std::holds_alternative<Sphere>(body.shapes[0].shape)) {
        const double radius = std::get<Sphere>(body.shapes[0].shape).radius;
        add_round(radius, 2 * radius, options, collector);
    } else if (single && std::holds_alternative<Box>(body.shapes[0].shape)) {
        add_box(std::get<Box>(body.shapes[0].shape).size, options, collector);
    } else if (!body.shapes.empty()) {
        const AxisBox box = extent(body.shapes);
        frame.translation() = box.center();
        add_box(box.size(), options, collector);
    }
    std::vector<Grasp> grasps = collector.take();
    for (Grasp& grasp : grasps) {
        grasp.body_in_tool = grasp.body_in_tool * frame.inverse();
        grasp.approach = frame.linear() * grasp.approach;
    }
    return grasps;
}

}  // namespace praxis::tamp
