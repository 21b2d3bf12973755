#include "tamp/motion/ompl_planner.hpp"

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/util/Console.h>

#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>

#include "tamp/motion/ompl_planners.hpp"
#include "tamp/motion/ompl_space.hpp"

namespace praxis::tamp {

namespace {

namespace ob = ompl::base;

void check(const CollisionChecker& checker, std::span<const double> start,
           std::span<const Configuration> goals, const OmplOptions& options) {
    check_ompl_planner_name(options.planner);
    const auto proper = [&](std::span<const double> positions) {
        return positions.size() == checker.dimension() &&
               std::ranges::all_of(positions, [](double q) { return std::isfinite(q); });
    };
    if (!proper(start)) throw std::invalid_argument("OMPL: the start is not a configuration of the group");
    if (goals.empty()) throw std::invalid_argument("OMPL: no goals");
    if (!std::ranges::all_of(goals, proper)) {
        throw std::invalid_argument("OMPL: a goal is not a configuration of the group");
    }
    if (!(options.step > 0) || !(options.range >= 0) || !(options.turning_weight > 0) ||
        !std::isfinite(options.range) || !std::isfinite(options.turning_weight)) {
        throw std::invalid_argument("OMPL: 'step', 'range' or 'turning_weight' is out of range");
    }
}

/// Planners may ask from a thread of their own: one at a time.
class Deadline {
  public:
    explicit Deadline(const Budget& budget) : budget_(budget) {}
    bool passed() {
        const std::lock_guard lock(mutex_);
        return budget_.exhausted() != Stop::none;
    }

  private:
    Budget budget_;
    std::mutex mutex_;
};

Path read_path(const OmplSpace& space, const ompl::geometric::PathGeometric& found,
               std::span<const double> start) {
    Path path = {Configuration(start.begin(), start.end())};
    for (std::size_t i = 1; i < found.getStateCount(); ++i) {
        Configuration next(start.size());
        space.read(found.getState(static_cast<unsigned>(i)), path.back(), next);
        path.push_back(std::move(next));
    }
    return path;
}

}  // namespace

bool seed_ompl(std::uint32_t seed) {
    if (seed == 0) throw std::invalid_argument("OMPL: the seed must be positive");
    static std::atomic<bool> seeded = false;
    if (seeded.exchange(true)) return false;
    ompl::msg::noOutputHandler();
    ompl::RNG::setSeed(seed);
    return true;
}

OmplResult plan_with_ompl(CollisionChecker& checker, std::span<const double> start,
                          std::span<const Configuration> goals, const OmplOptions& options) {
    check(checker, start, goals, options);
    static std::once_flag silenced;
    std::call_once(silenced, [] { ompl::msg::noOutputHandler(); });

    OmplResult result;
    const CollisionProblem& problem = checker.problem();
    const Group& group = problem.robot->groups[static_cast<std::size_t>(problem.group)];
    const auto valid = [&](std::span<const double> positions) {
        return problem.robot->within_limits(group, positions) && checker.is_free(positions);
    };
    if (!valid(start)) {
        result.status = OmplStatus::start_invalid;
        return result;
    }
    OmplSpace space(checker, options.step, options.turning_weight);
    const ob::SpaceInformationPtr& information = space.information();
    const auto goal_states = std::make_shared<ob::GoalStates>(information);
    std::vector<int> goal_numbers;
    ob::ScopedState<> state(information);
    for (std::size_t i = 0; i < goals.size(); ++i) {
        if (!valid(goals[i])) continue;
        space.write(goals[i], state.get());
        goal_states->addState(state);
        goal_numbers.push_back(static_cast<int>(i));
    }
    if (goal_numbers.empty()) {
        result.status = OmplStatus::goals_invalid;
        return result;
    }
    const auto definition = std::make_shared<ob::ProblemDefinition>(information);
    space.write(start, state.get());
    definition->addStartState(state);
    definition->setGoal(goal_states);
    const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(information);
    if (!options.improve) objective->setCostThreshold(objective->infiniteCost());
    definition->setOptimizationObjective(objective);

    const ob::PlannerPtr planner = make_ompl_planner(options.planner, information, options.range);
    planner->setProblemDefinition(definition);
    planner->setup();
    Deadline deadline(options.budget);
    const ob::PlannerTerminationCondition condition([&] { return deadline.passed(); });
    planner->solve(condition);
    result.states = space.states();
    result.motions = space.motions();
    if (!definition->hasExactSolution()) {
        result.status = deadline.passed() ? OmplStatus::out_of_budget : OmplStatus::not_found;
        return result;
    }
    const auto* found = definition->getSolutionPath()->as<ompl::geometric::PathGeometric>();
    result.status = OmplStatus::solved;
    result.path = read_path(space, *found, start);
    double nearest = std::numeric_limits<double>::infinity();
    const ob::State* last = found->getState(static_cast<unsigned>(found->getStateCount() - 1));
    for (unsigned i = 0; i < goal_numbers.size(); ++i) {
        const double distance = information->distance(last, goal_states->getState(i));
        if (distance < nearest) {
            nearest = distance;
            result.goal = goal_numbers[i];
        }
    }
    return result;
}

}  // namespace praxis::tamp
