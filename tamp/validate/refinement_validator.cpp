#include "tamp/validate/refinement_validator.hpp"

#include <algorithm>
#include <cmath>

#include "search/validate.hpp"
#include "search/validate/executor.hpp"
#include "tamp/report/replay.hpp"
#include "tamp/sampling/grasps.hpp"
#include "tamp/sampling/placements.hpp"
#include "tamp/validate/completed_task.hpp"

namespace praxis::tamp {
namespace {

double distance(const Pose& first, const Pose& second) {
    const double angle = Eigen::AngleAxisd(first.linear().transpose() * second.linear()).angle();
    return std::max((first.translation() - second.translation()).norm(), std::abs(angle));
}

/// What is wrong, on its way out of the checks.
struct Violation {
    std::string reason;
};

class Agreement {
  public:
    Agreement(const CompletedTask& completed, const Scene& scene, const TrajectoryDocument& document,
              double tolerance)
        : completed_(completed),
          scene_(scene),
          document_(document),
          replay_(document),
          areas_(areas_of(scene)),
          tolerance_(tolerance) {}

    void check() {
        check_named_poses();
        check_regions();
        if (document_.plan.size() != completed_.plan.steps.size())
            throw Violation{"the document has another number of actions than the plan"};
        validation::Executor executor(completed_.task);
        compare(executor, 0, "at the start");
        for (std::size_t i = 0; i < completed_.plan.steps.size(); ++i) {
            check_action(i);
            if (const auto failure = executor.execute(completed_.plan.steps[i])) throw Violation{*failure};
            compare(executor, document_.plan[i].end, "after action " + std::to_string(i + 1));
        }
    }

  private:
    /// Where the document has what after an action.
    struct Moment {
        std::string when;
        std::vector<Pose> links;
        std::vector<Pose> bodies;
        std::vector<std::string> held;
    };

    const std::string& name(ObjectId object) const { return completed_.task.objects[object.index()].name; }
    const Value& value(ObjectId object) const { return completed_.values[object.index()]; }
    /// -1: the object is no body of the scene.
    int body(ObjectId object) const {
        const auto found = scene_.objects.find(name(object));
        return found == scene_.objects.end() ? -1 : found->second;
    }

    void check_action(std::size_t number) const {
        const TrajectoryDocument::Action& action = document_.plan[number];
        const PlanStep& step = completed_.plan.steps[number];
        const auto same = [&](ObjectId object, const std::string& word) { return name(object) == word; };
        if (action.name != completed_.task.schemas[step.schema.index()].name ||
            !std::ranges::equal(step.arguments, action.arguments, same))
            throw Violation{"action " + std::to_string(number + 1) + " of the document is not the plan's"};
    }

    void check_named_poses() const {
        for (std::size_t i = 0; i < completed_.values.size(); ++i) {
            const auto named = scene_.poses.find(name(ObjectId(i)));
            const Pose* pose = completed_.values[i].get_if<Pose>();
            if (named == scene_.poses.end() || pose == nullptr) continue;
            if (distance(named->second, *pose) > tolerance_)
                throw Violation{"'" + named->first + "' is another pose in the scene"};
        }
    }

    void check_regions() const {
        for (const auto& [predicate, arguments] : completed_.certified) {
            if (arguments.size() != 3 || body(arguments[0]) < 0) continue;
            const Pose* pose = value(arguments[1]).get_if<Pose>();
            const auto area = areas_.find(name(arguments[2]));
            if (pose == nullptr || area == areas_.end()) continue;
            const BodyModel& model = *(*scene_.world)[body(arguments[0])].model;
            if (!stands_in(model, *pose, *scene_.world, area->second))
                throw Violation{"'" + name(arguments[0]) + "' does not stand in '" + name(arguments[2]) +
                                "' at '" + name(arguments[1]) + "'"};
        }
    }

    void compare(validation::Executor& executor, double time, const std::string& when) const {
        const Moment moment{.when = when,
                            .links = replay_.links_at(time),
                            .bodies = replay_.bodies_at(time),
                            .held = replay_.held_at(time)};
        for (std::size_t p = 0; p < completed_.task.predicates.size(); ++p) {
            const Predicate& predicate = completed_.task.predicates[p];
            if (!predicate.fluent || predicate.parameters.size() < 2) continue;
            const validation::FactTable& table = executor.tables()[p];
            for (std::uint32_t row = 0; row < table.row_count(); ++row) {
                if (!table.alive(row)) continue;
                compare(ObjectId(table.row(row)[0]), ObjectId(table.row(row)[1]), moment);
            }
        }
    }

    void compare(ObjectId moved, ObjectId where, const Moment& moment) const {
        const int number = body(moved);
        if (number < 0) return;
        const Pose* pose = value(where).get_if<Pose>();
        const Grasp* grasp = value(where).get_if<Grasp>();
        if (pose == nullptr && grasp == nullptr) return;
        const std::string& body_name = (*scene_.world)[number].model->name;
        const int index = document_.find_body(body_name);
        if (index < 0) throw Violation{"the document has no body '" + body_name + "'"};
        const Pose& actual = moment.bodies[static_cast<std::size_t>(index)];
        const bool is_held = std::ranges::find(moment.held, body_name) != moment.held.end();
        if (pose != nullptr) {
            if (is_held)
                throw Violation{"'" + name(moved) + "' is held " + moment.when + ", but should stand"};
            if (distance(actual, *pose) > tolerance_)
                throw Violation{"'" + name(moved) + "' is not at '" + name(where) + "' " + moment.when};
        } else {
            if (!is_held) throw Violation{"'" + name(moved) + "' is not held " + moment.when};
            if (!is_in_a_hand(actual, grasp->body_in_tool, moment))
                throw Violation{"'" + name(moved) + "' is not held by '" + name(where) + "' " + moment.when};
        }
    }

    bool is_in_a_hand(const Pose& pose, const Pose& body_in_tool, const Moment& moment) const {
        return std::ranges::any_of(scene_.robot->end_effectors, [&](const EndEffector& effector) {
            const int link =
                document_.find_link(scene_.robot->links[static_cast<std::size_t>(effector.link)].name);
            return link >= 0 &&
                   distance(moment.links[static_cast<std::size_t>(link)] * effector.tool * body_in_tool,
                            pose) <= tolerance_;
        });
    }

    const CompletedTask& completed_;
    const Scene& scene_;
    const TrajectoryDocument& document_;
    Replay replay_;
    std::map<std::string, Area, std::less<>> areas_;
    double tolerance_;
};

RefinementVerdict check_steps(const CompletedTask& completed) {
    const Verdict verdict = validate(completed.task, completed.plan);
    return {verdict.valid, verdict.reason};
}

}  // namespace

RefinementVerdict validate_symbolically(const StreamTask& task, const RefinedPlan& plan) {
    try {
        return check_steps(complete(task, plan));
    } catch (const IncompletePlan& fault) {
        return {false, fault.what()};
    }
}

RefinementVerdict validate_refinement(const StreamTask& task, const RefinedPlan& plan, const Scene& scene,
                                      const TrajectoryDocument& document, double tolerance) {
    try {
        const CompletedTask completed = complete(task, plan);
        if (RefinementVerdict verdict = check_steps(completed); !verdict.valid) return verdict;
        Agreement(completed, scene, document, tolerance).check();
        return {};
    } catch (const IncompletePlan& fault) {
        return {false, fault.what()};
    } catch (const Violation& violation) {
        return {false, violation.reason};
    }
}

}  // namespace praxis::tamp
