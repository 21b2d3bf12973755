#include "tamp/validate/trajectory_validator.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tamp/collision/body_checker.hpp"
#include "tamp/collision/fcl_checker.hpp"
#include "tamp/report/describe.hpp"
#include "tamp/report/replay.hpp"
#include "tamp/sampling/placements.hpp"

namespace praxis::tamp {

namespace {

using Document = TrajectoryDocument;
using Knot = Trajectory::Knot;

/// What is wrong, on its way out of the checks.
struct Violation {
    std::string reason;
    double time = 0;
};

[[noreturn]] void refuse(std::string reason, double time) {
    throw Violation{std::move(reason), time};
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

double distance(const Pose& first, const Pose& second) {
    const double angle = Eigen::AngleAxisd(first.linear().transpose() * second.linear()).angle();
    return std::max((first.translation() - second.translation()).norm(), std::abs(angle));
}

class Execution {
  public:
    Execution(const Document& document, const Robot& robot, const World& world, const Configuration& start,
              const TrajectoryCheck& check)
        : document_(document),
          check_(check),
          robot_(std::make_shared<Robot>(robot)),
          world_(std::make_shared<World>(world)),
          positions_(start),
          velocities_(start.size(), 0.0) {}

    TrajectoryVerdict run() {
        TrajectoryVerdict verdict;
        try {
            check_start();
            for (std::size_t i = 0; i < document_.segments.size(); ++i) {
                verdict.segment = static_cast<int>(i);
                execute(document_.segments[i]);
            }
            verdict.segment = -1;
            require_rest();
        } catch (const Violation& violation) {
            verdict.valid = false;
            verdict.reason = violation.reason;
            verdict.time = violation.time;
        }
        verdict.checked = checked_;
        return verdict;
    }

  private:
    const Variable& variable(int index) const { return robot_->variables[static_cast<std::size_t>(index)]; }
    double& position(int index) { return positions_[static_cast<std::size_t>(index)]; }
    double& velocity(int index) { return velocities_[static_cast<std::size_t>(index)]; }

    void check_start() {
        if (document_.start.size() != positions_.size() || robot_->variables.size() != positions_.size()) {
            refuse("the robot of the document has another number of variables", 0);
        }
        for (std::size_t i = 0; i < positions_.size(); ++i) {
            if (robot_->variables[i].name != document_.robot.variables[i]) {
                refuse("variable '" + document_.robot.variables[i] + "' is none of the robot", 0);
            }
            if (std::abs(document_.start[i] - positions_[i]) > check_.tolerance) {
                refuse("variable '" + robot_->variables[i].name + "' does not start where the robot is", 0);
            }
        }
        check_robot();
        check_bodies();
    }

    /// The document's links are where the robot's are.
    void check_robot() const {
        const std::vector<Pose> shown = link_poses(document_.robot, document_.start);
        for (std::size_t i = 0; i < robot_->links.size(); ++i) {
            const std::string& name = robot_->links[i].name;
            const int link = document_.find_link(name);
            if (link < 0) refuse("link '" + name + "' is not in the document", 0);
            if (distance(shown[static_cast<std::size_t>(link)],
                         link_pose(*robot_, positions_, static_cast<int>(i))) > check_.tolerance) {
                refuse("link '" + name + "' of the document is not where the robot's is", 0);
            }
        }
    }

    /// The document's bodies stand, or are held, as those of the world.
    void check_bodies() const {
        if (document_.bodies.size() != world_->size())
            refuse("the document has other bodies than the world", 0);
        for (const BodyState& state : world_->bodies()) {
            const std::string& name = state.model->name;
            const int body = document_.find_body(name);
            if (body < 0) refuse("body '" + name + "' is not in the document", 0);
            const auto hold = std::ranges::find(document_.held, name, &Document::Hold::body);
            const bool held = hold != document_.held.end();
            if (held != state.attachment.has_value())
                refuse("body '" + name + "' is held at the start in the document or the world, not in both",
                       0);
            const Document::PoseNumbers& shown =
                held ? hold->pose : document_.bodies[static_cast<std::size_t>(body)].pose;
            if ((held &&
                 hold->link != robot_->links[static_cast<std::size_t>(state.attachment->link)].name) ||
                distance(pose_from_numbers(shown), held ? state.attachment->in_link : state.pose) >
                    check_.tolerance)
                refuse("body '" + name + "' does not start where it is in the world", 0);
        }
    }

    void execute(const Document::Segment& segment) {
        if (segment.start < time_ - check_.tolerance)
            refuse("a segment starts before the last one has ended", time_);
        if (segment.start > time_ + check_.tolerance) require_rest();
        time_ = segment.start;
        if (!segment.knots.empty()) {
            follow(segment);
        } else if (segment.end > segment.start) {
            require_rest();
        }
        time_ = segment.end;
        if (segment.attach || segment.detach) require_rest();
        if (segment.attach) attach(*segment.attach);
        if (segment.detach) detach(*segment.detach);
    }

    void require_rest() const {
        for (std::size_t i = 0; i < velocities_.size(); ++i) {
            if (std::abs(velocities_[i]) > check_.tolerance) {
                refuse("variable '" + robot_->variables[i].name + "' is not at rest where nothing moves it",
                       time_);
            }
        }
    }

    void follow(const Document::Segment& segment) {
        for (std::size_t i = 0; i < velocities_.size(); ++i) {
            const bool moves =
                std::ranges::find(segment.variables, static_cast<int>(i)) != segment.variables.end();
            if (!moves && std::abs(velocities_[i]) > check_.tolerance) require_rest();
        }
        const Knot& first = segment.knots.front();
        for (std::size_t column = 0; column < segment.variables.size(); ++column) {
            const int index = segment.variables[column];
            if (std::abs(first.positions[column] - position(index)) > check_.tolerance ||
                std::abs(first.velocities[column] - velocity(index)) > check_.tolerance) {
                refuse("variable '" + variable(index).name + "' jumps where the segment begins", time_);
            }
        }
        const auto checker = make_checker(segment.variables);
        check_free(*checker, first.positions, first.time);
        for (std::size_t i = 0; i + 1 < segment.knots.size(); ++i) {
            check_piece(segment, segment.knots[i], segment.knots[i + 1]);
            check_collisions(*checker, segment.knots[i], segment.knots[i + 1]);
        }
        const Knot& last = segment.knots.back();
        for (std::size_t column = 0; column < segment.variables.size(); ++column) {
            position(segment.variables[column]) = last.positions[column];
            velocity(segment.variables[column]) = last.velocities[column];
        }
    }

    void check_piece(const Document::Segment& segment, const Knot& from, const Knot& to) const {
        const double dt = to.time - from.time;
        for (std::size_t column = 0; column < segment.variables.size(); ++column) {
            const Variable& moved = variable(segment.variables[column]);
            const double p = from.positions[column];
            const double v = from.velocities[column];
            const double a = from.accelerations[column];
            const std::string name = "variable '" + moved.name + "' ";
            if (std::abs(p + v * dt + a * dt * dt / 2 - to.positions[column]) > check_.tolerance ||
                std::abs(v + a * dt - to.velocities[column]) >
                    check_.tolerance * std::max(1.0, std::abs(a))) {
                refuse(name + "does not get from one knot to the next", from.time);
            }
            const double slack = 1 + check_.limit_tolerance;
            if (std::abs(a) > moved.max_acceleration * slack) {
                refuse(
                    name + "accelerates by " + number(a) + ", its limit is " + number(moved.max_acceleration),
                    from.time);
            }
            const double fastest = std::max(std::abs(v), std::abs(to.velocities[column]));
            if (fastest > moved.max_velocity * slack) {
                refuse(name + "moves at " + number(fastest) + ", its limit is " + number(moved.max_velocity),
                       from.time);
            }
            double lowest = std::min(p, to.positions[column]);
            double highest = std::max(p, to.positions[column]);
            if (const double turn = a == 0 ? -1 : -v / a; turn > 0 && turn < dt) {
                const double extreme = p + v * turn / 2;
                lowest = std::min(lowest, extreme);
                highest = std::max(highest, extreme);
            }
            if (lowest < moved.lower - check_.tolerance || highest > moved.upper + check_.tolerance) {
                refuse(name + "leaves its limits", from.time);
            }
        }
    }

    /// A checker whose group is the variables of a segment.
    std::unique_ptr<CollisionChecker> make_checker(const std::vector<int>& variables) {
        auto robot = std::make_shared<Robot>(*robot_);
        std::vector<int> sorted = variables;
        std::ranges::sort(sorted);
        if (sorted != variables) refuse("a segment's variables are not in order", time_);
        robot->groups.push_back({.name = "moving", .variables = sorted});
        auto checker = make_fcl_checker({.robot = robot,
                                         .world = world_,
                                         .group = static_cast<int>(robot->groups.size()) - 1,
                                         .rest = positions_});
        if (!checker->fixed_contacts().empty()) refuse_contact(checker->fixed_contacts().front(), time_);
        return checker;
    }

    void check_collisions(CollisionChecker& checker, const Knot& from, const Knot& to) {
        const double dt = to.time - from.time;
        double fastest = 0;
        for (std::size_t column = 0; column < from.positions.size(); ++column) {
            const double speed = std::max(std::abs(from.velocities[column]), std::abs(to.velocities[column]));
            fastest += speed * speed;
        }
        const double length = std::sqrt(fastest) * dt;
        const int steps = std::max(1, static_cast<int>(std::ceil(length / check_.step)));
        Configuration positions(from.positions.size());
        for (int i = 1; i <= steps; ++i) {
            const double t = dt * i / steps;
            for (std::size_t column = 0; column < positions.size(); ++column) {
                positions[column] = from.positions[column] + from.velocities[column] * t +
                                    from.accelerations[column] * t * t / 2;
            }
            check_free(checker, positions, from.time + t);
        }
    }

    void check_free(CollisionChecker& checker, const Configuration& positions, double time) {
        ++checked_;
        if (checker.is_free(positions)) return;
        std::vector<Contact> contacts;
        checker.find_contacts(positions, contacts);
        if (contacts.empty()) refuse("a collision", time);
        refuse_contact(contacts.front(), time);
    }

    [[noreturn]] void refuse_contact(const Contact& contact, double time) const {
        const auto [first, second] = describe_contact(*robot_, *world_, contact);
        refuse("'" + first + "' touches '" + second + "'", time);
    }

    void attach(const Document::Hold& hold) {
        const int body = world_->find(hold.body);
        const BodyState& state = (*world_)[body];
        if (!state.model->movable) refuse("body '" + hold.body + "' cannot be moved", time_);
        const int link = robot_->find_link(hold.link);
        if (link < 0) refuse("there is no link '" + hold.link + "'", time_);
        const Pose in_link = pose_from_numbers(hold.pose);
        const double gap = distance(link_pose(*robot_, positions_, link) * in_link, state.pose);
        if (gap > check_.tolerance) {
            refuse("body '" + hold.body + "' is not where the hand takes it, but " + number(gap) + " away",
                   time_);
        }
        Attachment attachment{.link = link, .in_link = in_link};
        for (const EndEffector& effector : robot_->end_effectors) {
            if (effector.link == link) attachment.touching = effector.links;
        }
        if (!is_near_hand(state, attachment))
            refuse("body '" + hold.body + "' is out of reach of the hand that takes it", time_);
        world_ = std::make_shared<World>(world_->with_attached(body, attachment));
    }

    /// Balls around the hand's links and the body are at most `grip` apart; or there are none.
    bool is_near_hand(const BodyState& body, const Attachment& attachment) const {
        std::vector<int> hand = attachment.touching;
        hand.push_back(attachment.link);
        bool looked = false;
        for (const int link : hand) {
            const Pose in_body = body.pose.inverse() * link_pose(*robot_, positions_, link);
            for (const Ball& of_hand : robot_->links[static_cast<std::size_t>(link)].balls) {
                for (const Ball& of_body : body.model->balls) {
                    looked = true;
                    const double apart = (in_body * of_hand.center - of_body.center).norm();
                    if (apart <= of_hand.radius + of_body.radius + check_.grip) return true;
                }
            }
        }
        return !looked;
    }

    void detach(const Document::Stand& stand) {
        const int body = world_->find(stand.body);
        const BodyState& state = (*world_)[body];
        const Pose pose = pose_from_numbers(stand.pose);
        const Pose held = link_pose(*robot_, positions_, state.attachment->link) * state.attachment->in_link;
        if (const double gap = distance(held, pose); gap > check_.tolerance) {
            refuse("body '" + stand.body + "' is not where the hand lets it go, but " + number(gap) + " away",
                   time_);
        }
        world_ = std::make_shared<World>(world_->with_pose(body, pose));
        if (!is_supported(body)) refuse("body '" + stand.body + "' is let go in the air", time_);
    }

    /// Lowered by `drop`, the body touches another; or it stands on a floor.
    bool is_supported(int body) const {
        Pose lowered = (*world_)[body].pose;
        for (const Area& floor : check_.floors)
            if (stands_in(*(*world_)[body].model, lowered, *world_, floor, check_.drop)) return true;
        lowered.translation().z() -= check_.drop;
        return !BodyChecker(world_).is_free(body, lowered);
    }

    const Document& document_;
    const TrajectoryCheck& check_;
    std::shared_ptr<const Robot> robot_;
    WorldPointer world_;
    Configuration positions_;
    Configuration velocities_;
    double time_ = 0;
    std::size_t checked_ = 0;
};

}  // namespace

TrajectoryVerdict validate_trajectory(const TrajectoryDocument& document, const Robot& robot,
                                      const World& world, const Configuration& start,
                                      const TrajectoryCheck& check) {
    check_document(document);
    return Execution(document, robot, world, start, check).run();
}

}  // namespace praxis::tamp
