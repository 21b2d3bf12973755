#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <stdexcept>
#include <string_view>

#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

namespace {

using Document = TrajectoryDocument;

/// A member of the document: "links" in "robot", the fourth of "segments". Its text is made only for errors.
class Place {
  public:
    explicit Place(std::string_view name, const Place* parent = nullptr) : parent_(parent), name_(name) {}
    Place member(std::string_view name) const& { return Place(name, this); }
    Place at(std::size_t index) const& {
        Place place(name_, parent_);
        place.index_ = index;
        place.indexed_ = true;
        return place;
    }
    [[noreturn]] void refuse(const std::string& wanted) const {
        throw std::invalid_argument(text() + " must be " + wanted);
    }
    void require(bool condition, const char* wanted) const {
        if (!condition) refuse(wanted);
    }

  private:
    std::string text() const {
        std::string result = parent_ ? parent_->text() + "." : "";
        result += name_;
        return indexed_ ? result + "[" + std::to_string(index_) + "]" : result;
    }

    const Place* parent_;
    std::string_view name_;
    std::size_t index_ = 0;
    bool indexed_ = false;
};

void check_finite(double number, const Place& place) {
    place.require(std::isfinite(number), "a finite number");
}

template <class Numbers>
void check_all_finite(const Numbers& numbers, const Place& place) {
    for (std::size_t i = 0; i < numbers.size(); ++i) check_finite(numbers[i], place.at(i));
}

void check_pose(const Document::PoseNumbers& pose, const Place& place) {
    check_all_finite(pose, place);
    const double length = std::hypot(std::hypot(pose[3], pose[4], pose[5]), pose[6]);
    place.require(std::abs(length - 1) < 1e-6, "x y z qx qy qz qw with a quaternion of length 1");
    place.require(pose[6] >= 0, "x y z qx qy qz qw with qw >= 0 (negate all four of the quaternion)");
}

template <class Named>
void check_names(const std::vector<Named>& all, const Place& place) {
    std::set<std::string_view> seen;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Place name = place.at(i);
        std::string_view text;
        if constexpr (std::is_same_v<Named, std::string>) {
            text = all[i];
        } else {
            text = all[i].name;
        }
        name.require(seen.insert(text).second, "named otherwise than those before it");
    }
}

void check_length(double length, const Place& place) {
    place.require(std::isfinite(length) && length >= 0, "a finite length >= 0");
}

struct CheckShape {
    const Place& place;

    void operator()(const Sphere& sphere) const { check_length(sphere.radius, place.member("radius")); }
    void operator()(const Box& box) const {
        const Place size = place.member("size");
        for (std::size_t i = 0; i < 3; ++i) check_length(box.size[static_cast<int>(i)], size.at(i));
    }
    template <class Round>
    void operator()(const Round& round) const {
        check_length(round.radius, place.member("radius"));
        check_length(round.length, place.member("length"));
    }
    void operator()(const std::shared_ptr<const Mesh>& mesh) const {
        place.require(mesh != nullptr, "a mesh");
        const Place vertices = place.member("vertices");
        for (std::size_t i = 0; i < mesh->vertices.size(); ++i)
            vertices.require(mesh->vertices[i].allFinite(), "finite numbers");
        const Place triangles = place.member("triangles");
        for (const auto& triangle : mesh->triangles)
            for (const std::uint32_t corner : triangle)
                triangles.require(corner < mesh->vertices.size(), "indices of vertices");
    }
    void operator()(const Document::Voxels& voxels) const {
        check_length(voxels.edge, place.member("edge"));
        const Place centers = place.member("centers");
        for (const Vector3& center : voxels.centers) centers.require(center.allFinite(), "finite numbers");
    }
};

void check_shapes(const std::vector<Document::PlacedShape>& shapes, const Place& owner) {
    const Place place = owner.member("shapes");
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Place shape = place.at(i);
        check_pose(shapes[i].pose, shape.member("pose"));
        std::visit(CheckShape{shape}, shapes[i].shape);
    }
}

void check_robot(const Document::Robot& robot) {
    const Place place("robot");
    check_pose(robot.base, place.member("base"));
    const Place variables = place.member("variables");
    check_names(robot.variables, variables);
    const Place links = place.member("links");
    check_names(robot.links, links);
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
        const Document::Link& link = robot.links[i];
        const Place at = links.at(i);
        const bool placed =
            i == 0 ? link.parent == -1 : link.parent >= 0 && static_cast<std::size_t>(link.parent) < i;
        at.member("parent").require(placed, "the index of a link before it (-1 for the first link)");
        check_pose(link.origin, at.member("origin"));
        check_all_finite(link.axis, at.member("axis"));
        const bool moves = link.type != JointType::fixed;
        at.member("axis").require(!moves || std::hypot(link.axis[0], link.axis[1], link.axis[2]) > 1e-9,
                                  "longer than zero");
        const bool known =
            link.variable >= -1 && link.variable < static_cast<int>(robot.variables.size()) && moves;
        at.member("variable")
            .require(known || link.variable == -1,
                     "the index of a variable (-1 for a joint that does not move)");
        check_finite(link.multiplier, at.member("multiplier"));
        check_finite(link.offset, at.member("offset"));
        check_shapes(link.shapes, at);
    }
    const Place tools = place.member("tools");
    for (std::size_t i = 0; i < robot.tools.size(); ++i) {
        const Place tool = tools.at(i);
        const int link = robot.tools[i].link;
        tool.member("link").require(link >= 0 && static_cast<std::size_t>(link) < robot.links.size(),
                                    "the index of a link");
        check_pose(robot.tools[i].pose, tool.member("pose"));
    }
}

void check_bodies(const Document& document) {
    const Place bodies("bodies");
    check_names(document.bodies, bodies);
    for (std::size_t i = 0; i < document.bodies.size(); ++i) {
        const Document::Body& body = document.bodies[i];
        const Place at = bodies.at(i);
        check_pose(body.pose, at.member("pose"));
        const Place color = at.member("color");
        for (std::size_t k = 0; k < 3; ++k)
            color.at(k).require(body.color[k] >= 0 && body.color[k] <= 1, "from 0 to 1");
        check_shapes(body.shapes, at);
    }
}

void check_body(const Document& document, const std::string& name, const Place& owner) {
    const Place place = owner.member("body");
    place.require(document.find_body(name) >= 0, "the name of a body");
}

void check_hold(const Document& document, const Document::Hold& hold, const Place& place) {
    check_body(document, hold.body, place);
    place.member("link").require(document.find_link(hold.link) >= 0, "the name of a link");
    check_pose(hold.pose, place.member("pose"));
}

void check_stand(const Document& document, const Document::Stand& stand, const Place& place) {
    check_body(document, stand.body, place);
    check_pose(stand.pose, place.member("pose"));
}

void check_configuration(const Document& document, const Configuration& configuration, const Place& place) {
    place.require(configuration.size() == document.robot.variables.size(),
                  "one number for each of robot.variables");
    check_all_finite(configuration, place);
}

void check_times(double start, double end, const Place& place) {
    place.member("start").require(std::isfinite(start) && start >= 0, "a finite time >= 0");
    place.member("end").require(std::isfinite(end) && end >= start, "a finite time that is not before start");
}

void check_plan(const Document& document) {
    const Place plan("plan");
    double before = 0;
    for (std::size_t i = 0; i < document.plan.size(); ++i) {
        const Document::Action& action = document.plan[i];
        const Place at = plan.at(i);
        check_times(action.start, action.end, at);
        at.member("start").require(action.start >= before, "not before that of the action before it");
        before = action.start;
    }
    const Place values("values");
    for (const auto& [name, value] : document.values) {
        const Place at = values.member(name);
        check_all_finite(value.numbers, at.member("numbers"));
    }
}

void check_knots(const Document::Segment& segment, const Place& owner) {
    if (segment.knots.empty()) return;
    const Place knots = owner.member("knots");
    const std::size_t size = segment.variables.size();
    for (std::size_t i = 0; i < segment.knots.size(); ++i) {
        const Trajectory::Knot& knot = segment.knots[i];
        const Place at = knots.at(i);
        check_finite(knot.time, at.member("t"));
        if (i > 0) at.member("t").require(knot.time > segment.knots[i - 1].time, "after that before it");
        const auto check_row = [&](const Configuration& row, const char* name) {
            const Place place = at.member(name);
            place.require(row.size() == size, "one number for each of the segment's variables");
            check_all_finite(row, place);
        };
        check_row(knot.positions, "q");
        check_row(knot.velocities, "v");
        check_row(knot.accelerations, "a");
    }
    knots.at(0).require(segment.knots.front().time == segment.start, "at the segment's start");
    knots.at(segment.knots.size() - 1)
        .require(segment.knots.back().time == segment.end, "at the segment's end");
}

void check_variables(const Document& document, const Document::Segment& segment,
                     std::vector<double>& free_from, const Place& owner) {
    const Place variables = owner.member("variables");
    for (std::size_t k = 0; k < segment.variables.size(); ++k) {
        const int variable = segment.variables[k];
        const Place at = variables.at(k);
        at.require(variable >= 0 && static_cast<std::size_t>(variable) < document.robot.variables.size(),
                   "the index of a variable");
        double& free = free_from[static_cast<std::size_t>(variable)];
        at.require(std::ranges::count(segment.variables, variable) == 1, "another than those before it");
        at.require(segment.start >= free, "a variable that no segment moves at this time");
        free = segment.end;
    }
}

/// Attachments follow one another: in order of the ends of the segments.
void check_holds(const Document& document) {
    const Place held("held");
    std::set<std::string_view> in_hand;
    for (std::size_t i = 0; i < document.held.size(); ++i) {
        const Place at = held.at(i);
        check_hold(document, document.held[i], at);
        at.member("body").require(in_hand.insert(document.held[i].body).second, "held once");
    }
    std::vector<std::size_t> order(document.segments.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return document.segments[i].end; });
    const Place segments("segments");
    for (const std::size_t i : order) {
        const Document::Segment& segment = document.segments[i];
        const Place at = segments.at(i);
        if (segment.attach) {
            const Place place = at.member("attach");
            at.require(!segment.detach, "one that attaches or detaches, not both");
            check_hold(document, *segment.attach, place);
            place.member("body").require(in_hand.insert(segment.attach->body).second,
                                         "a body that is not held already");
        }
        if (segment.detach) {
            const Place place = at.member("detach");
            check_stand(document, *segment.detach, place);
            place.member("body").require(in_hand.erase(segment.detach->body) == 1, "a body that is held");
        }
    }
}

void check_segments(const Document& document) {
    const Place segments("segments");
    std::vector<double> free_from(document.robot.variables.size(), 0);
    double before = 0;
    for (std::size_t i = 0; i < document.segments.size(); ++i) {
        const Document::Segment& segment = document.segments[i];
        const Place at = segments.at(i);
        at.member("action").require(
            segment.action >= 0 && static_cast<std::size_t>(segment.action) < document.plan.size(),
            "the index of an action of the plan");
        check_times(segment.start, segment.end, at);
        at.member("start").require(segment.start >= before, "not before that of the segment before it");
        before = segment.start;
        check_variables(document, segment, free_from, at);
        check_knots(segment, at);
    }
}

void check_attempts(const Document& document) {
    const Place attempts("attempts");
    for (std::size_t i = 0; i < document.attempts.size(); ++i) {
        const Document::Attempt& attempt = document.attempts[i];
        const Place at = attempts.at(i);
        if (!attempt.configuration.empty())
            check_configuration(document, attempt.configuration, at.member("configuration"));
        if (attempt.held) check_hold(document, *attempt.held, at.member("held"));
        const Place elsewhere = at.member("elsewhere");
        for (std::size_t k = 0; k < attempt.elsewhere.size(); ++k)
            check_stand(document, attempt.elsewhere[k], elsewhere.at(k));
        const Place contacts = at.member("contacts");
        const auto known = [&](const std::string& name) {
            return document.find_body(name) >= 0 || document.find_link(name) >= 0;
        };
        for (std::size_t k = 0; k < attempt.contacts.size(); ++k)
            contacts.at(k).require(known(attempt.contacts[k].first) && known(attempt.contacts[k].second),
                                   "two names of links or bodies");
        at.member("count").require(attempt.count >= 1, "at least 1");
    }
}

}  // namespace

void check_document(const TrajectoryDocument& document) {
    check_robot(document.robot);
    check_bodies(document);
    check_configuration(document, document.start, Place("start"));
    check_plan(document);
    check_segments(document);
    check_holds(document);
    check_attempts(document);
    const Place statistics("statistics");
    for (const auto& [name, number] : document.statistics) check_finite(number, statistics.member(name));
}

}  // namespace praxis::tamp
