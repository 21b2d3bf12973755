#include "tamp/collision/fcl_checker.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tamp/collision/motion_order.hpp"
#include "tamp/collision/standing_bodies.hpp"

namespace praxis::tamp {

namespace {

using Kind = Participant::Kind;

Contact contact_of(const Participant& first, const Participant& second) {
    return first < second ? Contact{first, second} : Contact{second, first};
}

/// A link, or a body that is attached to one.
struct Owner {
    Participant who = {};
    int link = 0;
    Pose in_link = Pose::Identity();
    std::vector<Solid> solids = {};
    Ball bound = {};
    int cluster = 0;                 ///< owners of one cluster do not move against each other
    std::vector<bool> checked = {};  ///< by standing body: not allowed to touch it

    Pose pose = Pose::Identity();      ///< in the world, now
    Vector3 center = Vector3::Zero();  ///< of the bound, in the world, now
    bool placed = false;               ///< the next two are of now
    std::vector<Pose> poses = {};
    std::vector<AxisBox> boxes = {};
};

void check_problem(const CollisionProblem& problem) {
    if (!problem.robot || !problem.world) {
        throw std::invalid_argument("a collision problem needs a robot and a world");
    }
    const Robot& robot = *problem.robot;
    if (problem.group < 0 || static_cast<std::size_t>(problem.group) >= robot.groups.size()) {
        throw std::invalid_argument("robot '" + robot.name + "' has no group number " +
                                    std::to_string(problem.group));
    }
    if (problem.rest.size() != robot.dimension() ||
        !std::ranges::all_of(problem.rest, [](double number) { return std::isfinite(number); })) {
        throw std::invalid_argument("a collision problem's rest needs one finite number a variable of '" +
                                    robot.name + "'");
    }
    for (const BodyState& body : problem.world->bodies()) {
        if (body.attachment && (body.attachment->link < 0 ||
                                static_cast<std::size_t>(body.attachment->link) >= robot.links.size())) {
            throw std::invalid_argument("body '" + body.model->name + "' is attached to a link that '" +
                                        robot.name + "' does not have");
        }
    }
}

/// By link: links have the same number if and only if the group does not move them against each other.
std::vector<int> rigid_clusters(const Robot& robot, const Group& group) {
    std::vector<int> clusters(robot.links.size(), 0);
    int last = 0;
    for (std::size_t link = 1; link < robot.links.size(); ++link) {
        const Joint& joint = robot.joints[static_cast<std::size_t>(robot.links[link].parent_joint)];
        const bool moves = std::ranges::find(group.variables, joint.variable) != group.variables.end();
        clusters[link] = moves ? ++last : clusters[static_cast<std::size_t>(joint.parent)];
    }
    return clusters;
}

class FclChecker final : public CollisionChecker {
  public:
    FclChecker(const CollisionProblem& problem, SolidCache& cache)
        : problem_(problem),
          standing_(*problem.world, cache),
          configuration_(problem.rest),
          link_poses_(problem.robot->links.size()) {
        add_owners(cache);
        add_pairs();
        find_fixed_contacts();
    }

    const CollisionProblem& problem() const override { return problem_; }

    bool is_free(std::span<const double> positions) override {
        require_positions(positions);
        if (!fixed_contacts_.empty()) return false;
        move_to(positions);
        return !each_contact([](const Contact&) { return true; });
    }

    bool is_motion_free(std::span<const double> from, std::span<const double> to, double step) override {
        require_positions(from);
        require_positions(to);
        if (!(step > 0)) throw std::invalid_argument("motions are checked at a step above 0");
        double squared_length = 0;
        for (std::size_t i = 0; i < from.size(); ++i) squared_length += (to[i] - from[i]) * (to[i] - from[i]);
        const double pieces = std::max(1.0, std::ceil(std::sqrt(squared_length) / step));
        if (!(pieces < 1e9)) throw std::invalid_argument("a motion is too long for its step");
        const auto count = static_cast<std::size_t>(pieces);
        between_.resize(from.size());
        return is_free(from) && is_free(to) && coarse_to_fine(count, [&](std::size_t point) {
                   const double share = static_cast<double>(point) / pieces;
                   for (std::size_t i = 0; i < from.size(); ++i) {
                       between_[i] = from[i] + share * (to[i] - from[i]);
                   }
                   return is_free(between_);
               });
    }

    void find_contacts(std::span<const double> positions, std::vector<Contact>& contacts) override {
        require_positions(positions);
        move_to(positions);
        const auto old = static_cast<std::ptrdiff_t>(contacts.size());
        contacts.insert(contacts.end(), fixed_contacts_.begin(), fixed_contacts_.end());
        each_contact([&](const Contact& contact) {
            contacts.push_back(contact);
            return false;
        });
        std::sort(contacts.begin() + old, contacts.end());
        contacts.erase(std::unique(contacts.begin() + old, contacts.end()), contacts.end());
    }

    const std::vector<Contact>& fixed_contacts() const override { return fixed_contacts_; }

  private:
    const Group& group() const { return problem_.robot->groups[static_cast<std::size_t>(problem_.group)]; }

    void require_positions(std::span<const double> positions) const {
        if (positions.size() != group().variables.size() ||
            !std::ranges::all_of(positions, [](double number) { return std::isfinite(number); })) {
            throw std::invalid_argument("group '" + group().name + "' needs " +
                                        std::to_string(group().variables.size()) + " finite positions");
        }
    }

    void add_owners(SolidCache& cache) {
        const Robot& robot = *problem_.robot;
        const std::vector<int> clusters = rigid_clusters(robot, group());
        const auto add = [&](Participant who, int link, const Pose& in_link, std::vector<Solid> solids) {
            if (solids.empty()) return;
            Owner owner;
            owner.who = who;
            owner.link = link;
            owner.in_link = in_link;
            owner.bound = bound_of(solids);
            owner.cluster = clusters[static_cast<std::size_t>(link)];
            owner.poses.resize(solids.size());
            owner.boxes.resize(solids.size());
            owner.solids = std::move(solids);
            for (int body = 0; static_cast<std::size_t>(body) < problem_.world->size(); ++body) {
                owner.checked.push_back(!problem_.world->allowed(who, {Kind::body, body}));
            }
            owners_.push_back(std::move(owner));
        };
        for (int link = 0; static_cast<std::size_t>(link) < robot.links.size(); ++link) {
            add({Kind::link, link}, link, Pose::Identity(),
                cache.make(robot.links[static_cast<std::size_t>(link)].collision));
        }
        for (int body = 0; static_cast<std::size_t>(body) < problem_.world->size(); ++body) {
            const BodyState& state = (*problem_.world)[body];
            if (!state.attachment) continue;
            add({Kind::body, body}, state.attachment->link, state.attachment->in_link,
                cache.make(state.model->shapes));
        }
    }

    bool may_touch(const Owner& first, const Owner& second) const {
        if (problem_.world->allowed(first.who, second.who)) return true;
        if (first.who.kind == Kind::link && second.who.kind == Kind::link) {
            return !problem_.robot->may_collide(first.link, second.link);
        }
        const auto holds = [&](const Owner& link, const Owner& body) {
            if (link.who.kind != Kind::link || body.who.kind != Kind::body) return false;
            const Attachment& attachment = *(*problem_.world)[body.who.index].attachment;
            return attachment.link == link.link ||
                   std::ranges::find(attachment.touching, link.link) != attachment.touching.end();
        };
        return holds(first, second) || holds(second, first);
    }

    void add_pairs() {
        for (std::size_t i = 0; i < owners_.size(); ++i) {
            if (owners_[i].cluster != 0) moving_.push_back(i);
            for (std::size_t j = i + 1; j < owners_.size(); ++j) {
                if (may_touch(owners_[i], owners_[j])) continue;
                (owners_[i].cluster == owners_[j].cluster ? fixed_pairs_ : pairs_).emplace_back(i, j);
            }
        }
    }

    void find_fixed_contacts() {
        forward_kinematics(*problem_.robot, configuration_, link_poses_);
        for (Owner& owner : owners_) update(owner);
        const auto keep = [&](const Contact& contact) {
            fixed_contacts_.push_back(contact);
            return false;
        };
        for (Owner& owner : owners_) {
            if (owner.cluster == 0) each_contact_with_bodies(owner, keep);
        }
        for (const auto& [i, j] : fixed_pairs_) contact_of_pair(owners_[i], owners_[j], keep);
        std::ranges::sort(fixed_contacts_);
        fixed_contacts_.erase(std::unique(fixed_contacts_.begin(), fixed_contacts_.end()),
                              fixed_contacts_.end());
    }

    void update(Owner& owner) {
        owner.pose = link_poses_[static_cast<std::size_t>(owner.link)] * owner.in_link;
        owner.center = owner.pose * owner.bound.center;
        owner.placed = false;
    }

    void move_to(std::span<const double> positions) {
        problem_.robot->insert(group(), positions, configuration_);
        forward_kinematics(*problem_.robot, configuration_, link_poses_);
        for (const std::size_t owner : moving_) update(owners_[owner]);
    }

    static void place(Owner& owner) {
        if (owner.placed) return;
        for (std::size_t i = 0; i < owner.solids.size(); ++i) {
            owner.poses[i] = owner.pose * owner.solids[i].pose;
            owner.boxes[i] = owner.solids[i].radius >= 0
                                 ? box_around(owner.poses[i].translation(), owner.solids[i].radius)
                                 : moved(owner.solids[i].extent, owner.poses[i]);
        }
        owner.placed = true;
    }

    /// Calls `report` with each contact until it returns true; whether it did. May repeat a contact.
    template <class Report>
    bool each_contact(Report&& report) {
        for (const std::size_t owner : moving_) {
            if (each_contact_with_bodies(owners_[owner], report)) return true;
        }
        for (const auto& [i, j] : pairs_) {
            if (contact_of_pair(owners_[i], owners_[j], report)) return true;
        }
        return false;
    }

    template <class Report>
    bool each_contact_with_bodies(Owner& owner, Report&& report) {
        const double squared_radius = owner.bound.radius * owner.bound.radius;
        return standing_.tree().any_of(box_around(owner.center, owner.bound.radius), [&](std::size_t index) {
            const StandingBodies::Part& part = standing_[index];
            if (!owner.checked[static_cast<std::size_t>(part.body)] ||
                part.box.squared_distance(owner.center) > squared_radius) {
                return false;
            }
            place(owner);
            for (std::size_t i = 0; i < owner.solids.size(); ++i) {
                if (owner.boxes[i].overlaps(part.box) &&
                    touch(owner.solids[i], owner.poses[i], part.solid, part.pose)) {
                    return report(contact_of(owner.who, {Kind::body, part.body}));
                }
            }
            return false;
        });
    }

    template <class Report>
    static bool contact_of_pair(Owner& first, Owner& second, Report&& report) {
        const double reach = first.bound.radius + second.bound.radius;
        if ((first.center - second.center).squaredNorm() > reach * reach) return false;
        place(first);
        place(second);
        for (std::size_t i = 0; i < first.solids.size(); ++i) {
            for (std::size_t j = 0; j < second.solids.size(); ++j) {
                if (first.boxes[i].overlaps(second.boxes[j]) &&
                    touch(first.solids[i], first.poses[i], second.solids[j], second.poses[j])) {
                    return report(contact_of(first.who, second.who));
                }
            }
        }
        return false;
    }

    CollisionProblem problem_;
    StandingBodies standing_;
    std::vector<Owner> owners_;
    std::vector<std::size_t> moving_;  ///< owners that the group moves
    std::vector<std::pair<std::size_t, std::size_t>> pairs_;
    std::vector<std::pair<std::size_t, std::size_t>> fixed_pairs_;
    std::vector<Contact> fixed_contacts_;
    Configuration configuration_;
    std::vector<Pose> link_poses_;
    Configuration between_;
};

}  // namespace

std::shared_ptr<SolidCache> make_solid_cache() {
    return std::make_shared<SolidCache>();
}

std::unique_ptr<CollisionChecker> make_fcl_checker(const CollisionProblem& problem,
                                                   std::shared_ptr<SolidCache> cache) {
    check_problem(problem);
    if (!cache) cache = make_solid_cache();
    return std::make_unique<FclChecker>(problem, *cache);
}

}  // namespace praxis::tamp
