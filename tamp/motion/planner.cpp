#include "tamp/motion/planner.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tamp/motion/certify.hpp"
#include "tamp/motion/obstructions.hpp"
#include "tamp/motion/rrt_connect.hpp"
#include "tamp/motion/shortcut.hpp"

namespace praxis::tamp {

namespace {

void require_positions(const CollisionChecker& checker, std::span<const double> positions) {
    if (positions.size() != checker.dimension()) {
        throw std::invalid_argument("a motion's ends need " + std::to_string(checker.dimension()) +
                                    " positions, not " + std::to_string(positions.size()));
    }
    if (!std::ranges::all_of(positions, [](double q) { return std::isfinite(q); })) {
        throw std::invalid_argument("a position at an end of a motion is not finite");
    }
}

bool within_limits(const CollisionChecker& checker, std::span<const double> positions) {
    const CollisionProblem& problem = checker.problem();
    return problem.robot->within_limits(problem.robot->groups[static_cast<std::size_t>(problem.group)],
                                        positions);
}

/// Goals that can be planned to, and which they were.
struct Goals {
    std::vector<Configuration> positions = {};
    std::vector<int> numbers = {};
};

class MotionPlanner {
  public:
    MotionPlanner(CollisionChecker& checker, std::span<const double> start,
                  std::span<const Configuration> goals, const MotionOptions& options)
        : checker_(checker), start_(start), options_(options) {
        result_.status = check_ends(goals);
    }

    MotionResult run() {
        if (result_.status != MotionStatus::solved) return std::move(result_);
        RrtConnectResult found = rrt_connect(checker_, start_, goals_.positions, search());
        if (!take(found)) return fail(found);
        shorten(result_.path);
        if (options_.certified && !certify(checker_, result_.path, {options_.seed, options_.budget})) {
            found = certified_rrt_connect(checker_, start_, goals_.positions, search());
            if (!take(found)) return fail(found);
        }
        return std::move(result_);
    }

  private:
    MotionStatus check_ends(std::span<const Configuration> goals) {
        require_positions(checker_, start_);
        for (const Configuration& goal : goals) require_positions(checker_, goal);
        if (!within_limits(checker_, start_)) return MotionStatus::start_out_of_limits;
        if (!checker_.is_free(start_)) {
            checker_.find_contacts(start_, result_.contacts);
            return MotionStatus::start_in_collision;
        }
        bool out_of_limits = false;
        for (std::size_t i = 0; i < goals.size(); ++i) {
            if (!within_limits(checker_, goals[i])) {
                out_of_limits = true;
            } else if (checker_.is_free(goals[i])) {
                goals_.positions.push_back(goals[i]);
                goals_.numbers.push_back(static_cast<int>(i));
            } else if (result_.contacts.empty()) {
                checker_.find_contacts(goals[i], result_.contacts);
            }
        }
        if (goals.empty()) return MotionStatus::not_found;
        if (goals_.positions.empty()) {
            return out_of_limits ? MotionStatus::goal_out_of_limits : MotionStatus::goal_in_collision;
        }
        result_.contacts.clear();
        return MotionStatus::solved;
    }

    RrtConnectOptions search() const {
        return {.seed = options_.seed,
                .step = options_.step,
                .range = options_.range,
                .max_iterations = options_.max_iterations,
                .budget = options_.budget};
    }

    /// Whether there is a path.
    bool take(RrtConnectResult& found) {
        result_.path = std::move(found.path);
        if (found.goal >= 0) result_.goal = goals_.numbers[static_cast<std::size_t>(found.goal)];
        result_.iterations += found.iterations;
        result_.nodes += found.nodes;
        return !result_.path.empty();
    }

    void shorten(Path& path) {
        if (!options_.shorten) return;
        shortcut(checker_, path, {.seed = options_.seed, .step = options_.step, .budget = options_.budget});
    }

    MotionResult fail(const RrtConnectResult& found) {
        result_.status = MotionStatus::not_found;
        result_.goal = -1;
        result_.obstructions = find_obstructions(checker_, found.blocked, options_.step);
        return std::move(result_);
    }

    CollisionChecker& checker_;
    std::span<const double> start_;
    MotionOptions options_;
    Goals goals_ = {};
    MotionResult result_ = {};
};

}  // namespace

std::string_view to_string(MotionStatus status) {
    switch (status) {
        case MotionStatus::solved:
            return "solved";
        case MotionStatus::start_in_collision:
            return "start in collision";
        case MotionStatus::goal_in_collision:
            return "goal in collision";
        case MotionStatus::start_out_of_limits:
            return "start out of limits";
        case MotionStatus::goal_out_of_limits:
            return "goal out of limits";
        case MotionStatus::not_found:
            return "no path found";
    }
    return "";
}

MotionResult plan_motion(CollisionChecker& checker, std::span<const double> start,
                         std::span<const Configuration> goals, const MotionOptions& options) {
    return MotionPlanner(checker, start, goals, options).run();
}

}  // namespace praxis::tamp
