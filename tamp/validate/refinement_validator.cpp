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
        const std::vector<Pose> poses = replay_.bodies_at(time);
        const std::vector<std::string> held = replay_.held_at(time);
        for (std::size_t p = 0; p < completed_.task.predicates.size(); ++p) {
            const Predicate& predicate = completed_.task.predicates[p];
            if (!predicate.fluent || predicate.parameters.size() < 2) continue;
            const validation::FactTable& table = executor.tables()[p];
            for (std::uint32_t row = 0; row < table.row_count(); ++row) {
                if (!table.alive(row)) continue;
                compare(ObjectId(table.row(row)[0]), ObjectId(table.row(row)[1]), poses, held, when);
            }
        }
    }

    void compare(ObjectId moved, ObjectId where, const std::vector<Pose>& poses,
                 const std::vector<std::string>& held, const std::string& when) const {
        const int number = body(moved);
        if (number < 0) return;
        const std::string& body_name = (*scene_.world)[number].model->name;
        const bool is_held = std::ranges::find(held, body_name) != held.end();
        if (const Pose* pose = value(where).get_if<Pose>()) {
            if (is_held) throw Violation{"'" + name(moved) + "' is held " + when + ", but should stand"};
            const int index = document_.find_body(body_name);
            if (index < 0) throw Violation{"the document has no body '" + body_name + "'"};
            if (distance(poses[static_cast<std::size_t>(index)], *pose) > tolerance_)
                throw Violation{"'" + name(moved) + "' is not at '" + name(where) + "' " + when};
        } else if (value(where).is<Grasp>() && !is_held) {
            throw Violation{"'" + name(moved) + "' is not held " + when};
        }
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
