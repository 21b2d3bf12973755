#include "tamp/solve/solve.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "parser/files.hpp"
#include "search/thread_time.hpp"
#include "tamp/manipulation/join_motions.hpp"
#include "tamp/manipulation/manipulator_model.hpp"
#include "tamp/report/describe.hpp"
#include "tamp/report/document_names.hpp"
#include "tamp/scenes/scene_file.hpp"
#include "tamp/solve/describe_values.hpp"
#include "tamp/validate/refinement_validator.hpp"

namespace praxis::tamp {
namespace {

/// The rest of the attempts is counted only.
constexpr std::size_t kMostAttempts = 100;
/// Plans that the validators may refuse, before it counts as a fault.
constexpr int kTries = 4;

/// A failure of a skill is a picture; of other streams only words are known.
TrajectoryDocument::Attempt describe(const Attempt& attempt, const Robot& robot, const World& first) {
    TrajectoryDocument::Attempt result;
    const ActionFailure* failure = attempt.picture.get_if<ActionFailure>();
    if (failure != nullptr && failure->world != nullptr)
        result = describe_attempt(robot, first, *failure->world, failure->configuration, failure->contacts);
    result.action = attempt.action;
    result.stream = attempt.stream;
    result.reason = static_cast<TrajectoryDocument::Reason>(attempt.reason);
    result.message = attempt.message;
    result.count = static_cast<int>(std::min<std::uint64_t>(attempt.count, 1'000'000'000));
    return result;
}

class Solver {
  public:
    Solver(const SceneProblem& problem, const SolveOptions& options, const Budget& budget,
           const SolveCallbacks& callbacks)
        : problem_(problem), options_(options), budget_(budget), callbacks_(callbacks) {}

    Solution run() {
        const SceneOptions options = scene_options(problem_.scene);
        in_phase("bind", [&] { bound_ = bind_scene(problem_.task, problem_.scene, options); });
        if (callbacks_.bind) callbacks_.bind(bound_.library, problem_.scene);
        for (int number = 0; number < kTries && !find(number); ++number)
            if (number + 1 == kTries) throw InvalidSolution(refused_);
        add_attempts();
        add_statistics();
        return std::move(solution_);
    }

  private:
    /// False: a plan was found, but the validators refuse it.
    bool find(int number) {
        // The way between actions is what is looked at least closely; then only another plan helps.
        if (number == 1 && !options_.join) return false;
        const bool join_them = options_.join && number != 1;
        if (number != 1) in_phase("refine", [&] { refine(static_cast<std::uint64_t>(number)); });
        if (!solution_.refinement.plan) {
            solution_.document = begin_document(bound_.manipulator->robot(), *problem_.scene.world,
                                                bound_.manipulator->model().home);
            return true;
        }
        const RefinedPlan& plan = *solution_.refinement.plan;
        std::vector<ScheduledAction> actions;
        in_phase("join", [&] { actions = motions_of(plan, join_them); });
        in_phase("schedule", [&] {
            solution_.document =
                schedule(*bound_.manipulator, *problem_.scene.world, actions, options_.schedule);
            solution_.document.values = describe_values(plan, solution_.document.plan);
        });
        if (!options_.validate) return true;
        bool valid = false;
        in_phase("validate", [&] { valid = validate(plan); });
        return valid;
    }

    template <class Work>
    void in_phase(const char* name, Work&& work) {
        if (callbacks_.on_phase) callbacks_.on_phase(name);
        const double start = thread_seconds();
        work();
        auto phase = std::ranges::find(solution_.phases, name, &SolvePhase::name);
        if (phase == solution_.phases.end()) phase = solution_.phases.insert(phase, SolvePhase{name});
        phase->seconds += thread_seconds() - start;
    }

    void refine(std::uint64_t number) {
        RefineOptions options = options_.refine;
        options.seed += number << 32;
        solution_.refinement = tamp::refine(
            {.task = &problem_.task, .library = &bound_.library, .values = bound_.values, .options = options},
            budget_, {.on_progress = callbacks_.on_progress});
    }

    /// What every step does: its argument that is a motion; steps without one move nothing.
    std::vector<ScheduledAction> motions_of(const RefinedPlan& plan, bool join) const {
        std::vector<ActionMotion> motions;
        std::vector<ScheduledAction> actions;
        for (const RefinedStep& step : plan.steps) {
            ScheduledAction& action = actions.emplace_back();
            action.name = step.name;
            ActionMotion& motion = motions.emplace_back();
            for (const Value& argument : step.arguments) {
                action.arguments.push_back(argument.name());
                if (const ActionMotion* own = argument.get_if<ActionMotion>()) motion = *own;
            }
        }
        if (join)
            motions = join_motions(*bound_.manipulator, *problem_.scene.world, std::move(motions), budget_);
        for (std::size_t i = 0; i < actions.size(); ++i) actions[i].motion = std::move(motions[i]);
        return actions;
    }

    bool validate(const RefinedPlan& plan) {
        const RefinementVerdict symbolic =
            validate_refinement(problem_.task, plan, problem_.scene, solution_.document);
        if (!symbolic.valid) return refuse("the plan is not valid: " + symbolic.reason);
        TrajectoryCheck check = options_.check;
        for (auto& [name, area] : areas_of(problem_.scene))
            if (area.body < 0) check.floors.push_back(std::move(area));
        const TrajectoryVerdict motion = validate_trajectory(
            solution_.document, *problem_.scene.robot, *problem_.scene.world, problem_.scene.start, check);
        solution_.checked = motion.checked;
        if (motion.valid) return true;
        std::string where;
        if (motion.segment >= 0) {
            const TrajectoryDocument::Segment& segment =
                solution_.document.segments[static_cast<std::size_t>(motion.segment)];
            where = " (" + name_of(segment.kind) + " of " +
                    plan.action(static_cast<std::size_t>(segment.action)) + ")";
        }
        return refuse("the motion is not valid at " + std::to_string(motion.time) + " s" + where + ": " +
                      motion.reason);
    }

    bool refuse(std::string reason) {
        refused_ = std::move(reason);
        ++solution_.refusals;
        return false;
    }

    void add_attempts() {
        for (const Attempt& attempt : solution_.refinement.attempts) {
            if (solution_.document.attempts.size() == kMostAttempts) return;
            solution_.document.attempts.push_back(
                describe(attempt, bound_.manipulator->robot(), *problem_.scene.world));
        }
    }

    void add_statistics() {
        const RefineStatistics& statistics = solution_.refinement.statistics;
        std::map<std::string, double>& numbers = solution_.document.statistics;
        const auto add = [&](const char* name, auto value) { numbers[name] = static_cast<double>(value); };
        add("searches", statistics.searches);
        add("evaluated states", statistics.evaluated);
        add("skeletons", statistics.skeletons);
        add("stream calls", statistics.stream_calls);
        add("samples", statistics.samples);
        add("nogoods", statistics.nogoods);
        add("checked configurations", solution_.checked);
        add("refused plans", solution_.refusals);
        for (const SolvePhase& phase : solution_.phases) numbers[phase.name + " seconds"] = phase.seconds;
    }

    const SceneProblem& problem_;
    const SolveOptions& options_;
    const Budget& budget_;
    const SolveCallbacks& callbacks_;
    BoundScene bound_;
    Solution solution_;
    std::string refused_;  ///< why the last plan was refused
};

}  // namespace

SceneProblem load_scene_problem(const std::string& domain_file, const std::string& problem_file,
                                const std::string& stream_file, const std::string& scene_file) {
    std::string streams = stream_file;
    if (streams.empty()) {
        const std::filesystem::path domain = domain_file;
        const std::filesystem::path beside = domain.parent_path() / "streams.pddl";
        std::error_code error;
        // Of a domain that is not there itself, the reader tells.
        if (domain_file == "-" ||
            (std::filesystem::exists(domain, error) && !std::filesystem::exists(beside, error)))
            fail_unplaced("there is no " + beside.string() +
                          " beside the domain: name the stream file with --streams FILE");
        streams = beside.string();
    }
    StreamLoadResult loaded = load_streams_with_warnings(domain_file, problem_file, streams);
    return {std::move(loaded.task), read_scene(scene_file), std::move(loaded.warnings)};
}

Solution solve(const SceneProblem& problem, const SolveOptions& options, const Budget& budget,
               const SolveCallbacks& callbacks) {
    return Solver(problem, options, budget, callbacks).run();
}

}  // namespace praxis::tamp
