#include "tamp/solve/solve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <numbers>
#include <stop_token>
#include <thread>

#include "tamp/report/document_json.hpp"
#include "tamp/sampling/area.hpp"
#include "tests/tamp/support/solved_problem.hpp"

namespace praxis::tamp {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A folder for the files of a problem, gone at the end.
struct Folder {
    std::string path;
    explicit Folder(const std::string& name) : path(testing::TempDir() + "praxis-solve-" + name) {}
    ~Folder() { std::filesystem::remove_all(path); }
};

std::string without_figures(TrajectoryDocument document) {
    document.statistics.clear();
    return to_json(document);
}

class SmallestOf : public testing::TestWithParam<ProblemFamily> {};

TEST_P(SmallestOf, EachFamilyIsSolved) {
    const ProblemFamily& family = GetParam();
#ifdef PRAXIS_SANITIZED
    if (family.name == "namo") GTEST_SKIP() << "takes long with sanitizers";
#endif
    const Folder folder(family.name);
    const GeneratedProblem generated = generate_problem(family.name, family.smallest, 1);
    write_problem(generated, folder.path);
    const SceneProblem problem = scene_problem(generated, folder.path);
    const Solution solution = solve(problem, {}, Budget().limit_wall_time(60));
    ASSERT_EQ(solution.refinement.status, RefineStatus::solved);
    const TrajectoryDocument& document = solution.document;
    EXPECT_EQ(document.plan.size(), solution.refinement.plan->steps.size());
    EXPECT_GT(document.duration(), 1);
    EXPECT_GT(solution.checked, 100U);
    EXPECT_EQ(document.statistics.at("checked configurations"), static_cast<double>(solution.checked));
    for (const RefinedStep& step : solution.refinement.plan->steps) {
        for (const Value& argument : step.arguments) {
            if (!argument.is<Pose>()) continue;
            EXPECT_EQ(document.values.at(argument.name()).kind, "pose");
        }
    }
    const std::string text = to_json(document);
    const TrajectoryDocument again = read_document({"document.json", text});
    EXPECT_EQ(to_json(again), text);
    TrajectoryCheck check;
    for (const auto& [name, area] : areas_of(problem.scene))
        if (area.body < 0) check.floors.push_back(area);
    const TrajectoryVerdict verdict =
        validate_trajectory(again, *problem.scene.robot, *problem.scene.world, problem.scene.start, check);
    EXPECT_EQ(verdict.reason, "");
    EXPECT_EQ(verdict.checked, solution.checked);
}

INSTANTIATE_TEST_SUITE_P(All, SmallestOf, testing::ValuesIn(problem_families()), [](const auto& family) {
    std::string name = family.param.name;
    std::ranges::replace(name, '-', '_');
    return name;
});

class Solve : public testing::Test {
  protected:
    const SceneProblem& problem = sorted_sticks().problem;
    SolveOptions options;
    SolveCallbacks callbacks;
};

TEST_F(Solve, EqualSeedsGiveEqualDocuments) {
    EXPECT_EQ(without_figures(solve(problem).document), without_figures(sorted_sticks().solution.document));
}

TEST_F(Solve, PhasesAreNamedInOrder) {
    std::vector<std::string> names;
    callbacks.on_phase = [&](const char* name) { names.emplace_back(name); };
    const Solution solution = solve(problem, options, {}, callbacks);
    EXPECT_EQ(names, (std::vector<std::string>{"bind", "refine", "join", "schedule", "validate"}));
    ASSERT_EQ(solution.phases.size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(solution.phases[i].name, names[i]);
        EXPECT_GE(solution.phases[i].seconds, 0);
        EXPECT_EQ(solution.document.statistics.at(names[i] + " seconds"), solution.phases[i].seconds);
    }
}

TEST_F(Solve, WithoutTheCheckNothingIsChecked) {
    options.validate = false;
    const Solution solution = solve(problem, options);
    EXPECT_EQ(solution.checked, 0U);
    EXPECT_EQ(solution.phases.back().name, "schedule");
    EXPECT_EQ(without_figures(solution.document), without_figures(sorted_sticks().solution.document));
}

TEST_F(Solve, ByHomeIsValidToo) {
    options.join = false;
    const Solution solution = solve(problem, options);
    ASSERT_TRUE(solution.refinement.plan);
    EXPECT_GT(solution.document.segments.size(), sorted_sticks().solution.document.segments.size());
}

TEST_F(Solve, StreamsOfOnesOwnTakeThePlaceOfOthers) {
    std::vector<Pose> given;
    callbacks.bind = [&](StreamLibrary& library, const Scene& scene) {
        EXPECT_EQ(&scene, &problem.scene);
        const StreamLibrary::BoundStream placement = *library.find("sample-placement");
        library.bind(
            "sample-placement",
            [&given, placement](StreamCall& call) {
                StreamResult result = placement.callback(call);
                // The other way round.
                for (Value& output : result.outputs) {
                    Pose pose = output.get<Pose>();
                    pose.rotate(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitZ()));
                    output = Value::of(pose);
                    given.push_back(pose);
                }
                return result;
            },
            placement.info);
    };
    const Solution solution = solve(problem, options, {}, callbacks);
    ASSERT_TRUE(solution.refinement.plan);
    const Pose& mine = solution.refinement.plan->steps[1].arguments[1].get<Pose>();
    EXPECT_TRUE(std::ranges::any_of(given, [&](const Pose& pose) { return pose.matrix() == mine.matrix(); }));
}

TEST_F(Solve, StreamsThatThrowAreNamed) {
    callbacks.bind = [](StreamLibrary& library, const Scene&) {
        library.bind("plan-pick",
                     [](StreamCall&) -> StreamResult { throw std::runtime_error("no arm today"); });
    };
    try {
        solve(problem, options, {}, callbacks);
        FAIL() << "solved";
    } catch (const StreamError& error) {
        EXPECT_NE(std::string(error.what()).find("plan-pick"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("no arm today"), std::string::npos) << error.what();
    }
}

/// What streams certify is not believed: the validators see what the motion does.
class LyingStreams : public Solve {
  protected:
    using Lie = std::function<void(ActionMotion&)>;

    void refused(const Lie& lie, const std::string& part) {
        options.join = false;
        callbacks.bind = [&](StreamLibrary& library, const Scene&) {
            const StreamLibrary::BoundStream pick = *library.find("plan-pick");
            library.bind(
                "plan-pick",
                [lie, pick](StreamCall& call) {
                    StreamResult result = pick.callback(call);
                    if (result.kind != StreamResult::Kind::sample) return result;
                    ActionMotion motion = result.outputs[0].get<ActionMotion>();
                    lie(motion);
                    return StreamResult::sample({Value::of(std::move(motion))});
                },
                pick.info);
        };
        try {
            solve(problem, options, {}, callbacks);
            ADD_FAILURE() << "solved, for '" << part << "'";
        } catch (const InvalidSolution& fault) {
            EXPECT_NE(std::string(fault.what()).find(part), std::string::npos)
                << fault.what() << " for '" << part << "'";
        }
    }
};

TEST_F(LyingStreams, ThatOnlyGoThere) {
    refused(
        [](ActionMotion& motion) {
            while (!motion.pieces.back().attach) motion.pieces.pop_back();
        },
        "jumps where the segment begins");
}

TEST_F(LyingStreams, ThatLeaveAPieceOut) {
    refused([](ActionMotion& motion) { motion.pieces.erase(motion.pieces.begin()); },
            "jumps where the segment begins");
}

TEST_F(LyingStreams, ThatGoThroughThings) {
    refused(
        [](ActionMotion& motion) {
            // Round by the shoulder, far down, and back.
            Path& path = motion.pieces.front().path;
            Configuration low = path.front();
            low[1] += 1.5;
            path.insert(path.begin() + 1, {low, path.front()});
        },
        "touches");
}

TEST_F(LyingStreams, ThatTakeByAnotherGrasp) {
    refused(
        [](ActionMotion& motion) {
            for (MotionPiece& piece : motion.pieces)
                if (piece.attach) piece.attach->second.in_link.translation().x() += 0.01;
        },
        "is not held by");
}

TEST_F(LyingStreams, OnceAreForgiven) {
    for (const bool join : {true, false}) {
        options.join = join;
        int calls = 0;
        callbacks.bind = [&](StreamLibrary& library, const Scene&) {
            const StreamLibrary::BoundStream pick = *library.find("plan-pick");
            library.bind(
                "plan-pick",
                [&calls, pick](StreamCall& call) {
                    StreamResult result = pick.callback(call);
                    if (++calls > 1) return result;
                    ActionMotion motion = result.outputs.at(0).get<ActionMotion>();
                    for (MotionPiece& piece : motion.pieces)
                        if (piece.attach) piece.attach->second.in_link.translation().x() += 0.01;
                    return StreamResult::sample({Value::of(std::move(motion))});
                },
                pick.info);
        };
        const Solution solution = solve(problem, options, {}, callbacks);
        ASSERT_TRUE(solution.refinement.plan);
        // By home it is the same lie; the next plan asks again.
        EXPECT_EQ(solution.refusals, join ? 2 : 1);
        EXPECT_EQ(solution.document.statistics.at("refused plans"), solution.refusals);
        EXPECT_EQ(solution.phases.size(), 5U);
        EXPECT_GT(solution.checked, 100U);
    }
}

TEST_F(Solve, ABudgetThatIsSpentEndsAtOnce) {
    const auto start = Clock::now();
    const Solution solution = solve(problem, options, Budget().limit_wall_time(0));
    EXPECT_LT(seconds_since(start), 2);
    EXPECT_EQ(solution.refinement.status, RefineStatus::out_of_budget);
    EXPECT_FALSE(solution.refinement.plan);
    EXPECT_EQ(solution.phases.size(), 2U);
    EXPECT_EQ(solution.document.bodies.size(), problem.scene.world->size());
    EXPECT_TRUE(solution.document.segments.empty());
    EXPECT_NO_THROW(to_json(solution.document));
}

TEST_F(Solve, AStopTokenEndsIt) {
    std::stop_source source;
    source.request_stop();
    EXPECT_EQ(solve(problem, options, Budget().stop_with(source.get_token())).refinement.status,
              RefineStatus::cancelled);
}

TEST_F(Solve, AStopTokenEndsItInTheMiddle) {
    const SceneProblem hard = scene_problem(generate_problem("packing", 6, 1, false));
    std::stop_source source;
    Clock::time_point asked;
    callbacks.on_progress = [&](const RefineStatistics& statistics) {
        if (statistics.skeletons >= 2 && source.request_stop()) asked = Clock::now();
    };
    // If it ends before, the test is pointless.
    const Solution solution =
        solve(hard, options, Budget().limit_wall_time(120).stop_with(source.get_token()), callbacks);
    ASSERT_TRUE(source.stop_requested());
    EXPECT_EQ(solution.refinement.status, RefineStatus::cancelled);
    EXPECT_LT(seconds_since(asked), 20);
    EXPECT_GE(solution.refinement.statistics.skeletons, 2U);
}

TEST_F(Solve, WhatWasTriedInVainIsShown) {
    const SceneProblem twin = scene_problem(generate_problem("blocked-shelf", 1, 1, false));
    const Solution solution = solve(twin, options, Budget().limit_wall_time(30));
    ASSERT_FALSE(solution.refinement.plan);
    EXPECT_FALSE(solution.refinement.reasons.empty());
    ASSERT_FALSE(solution.document.attempts.empty());
    EXPECT_LE(solution.document.attempts.size(), 100U);
    EXPECT_TRUE(
        std::ranges::any_of(solution.document.attempts, [](const TrajectoryDocument::Attempt& attempt) {
            return attempt.reason == TrajectoryDocument::Reason::collision && !attempt.contacts.empty() &&
                   !attempt.configuration.empty();
        }));
    const std::string text = to_json(solution.document);
    EXPECT_EQ(to_json(read_document({"document.json", text})), text);
}

constexpr const char* kFloorScene = R"(
robot: {builtin: arm7, start: {arm: ready, gripper: open}}
bodies:
  - {name: can, box: [0.04, 0.04, 0.2], movable: true, on: ground, at: [0.5, -0.2]}
surfaces:
  - {name: ground, pose: {xyz: [0, 0, 0.05]}, size: [2, 2]}
regions:
  - {name: there, surface: ground, center: [0.5, 0.2], size: [0.2, 0.2]}
)";

SceneProblem floor_problem(const std::string& region) {
    const std::string folder = PRAXIS_SOURCE_DIR "/domains/tamp/pick-place/";
    StreamLoadResult loaded = parse_streams(
        read_source(folder + "domain.pddl"),
        {"problem.pddl",
         "(define (problem floor) (:domain pick-place) (:objects can - body p - pose " + region +
             " - region) (:init (hand-empty) (graspable can) (pose-of can p) (at can p) (placeable "
             "can " +
             region + ")) (:goal (in can " + region + ")))"},
        read_source(folder + "streams.pddl"));
    return {std::move(loaded.task), parse_scene({"scene.yaml", kFloorScene}), {}};
}

TEST_F(Solve, ThingsMayStandOnAFloorWithoutABody) {
    const SceneProblem floor = floor_problem("there");
    const Solution solution = solve(floor, options, Budget().limit_wall_time(30));
    ASSERT_EQ(solution.refinement.status, RefineStatus::solved);
    EXPECT_EQ(solution.document.plan.size(), 2U);
}

TEST_F(Solve, RegionsThatTheSceneDoesNotHaveAreNamed) {
    try {
        solve(floor_problem("nowhere"));
        FAIL() << "solved";
    } catch (const StreamError& error) {
        EXPECT_NE(std::string(error.what()).find("the scene has no region 'nowhere'"), std::string::npos)
            << error.what();
    }
}

TEST(LoadSceneProblem, FindsTheStreamsBesideTheDomain) {
    const Folder folder("load");
    write_problem(generate_problem("clutter", 2, 1), folder.path);
    const std::string domain = PRAXIS_SOURCE_DIR "/domains/tamp/pick-place/domain.pddl";
    const SceneProblem loaded =
        load_scene_problem(domain, folder.path + "/problem.pddl", "", folder.path + "/scene.yaml");
    EXPECT_EQ(loaded.task.streams.size(), 4U);
    EXPECT_EQ(without_figures(solve(loaded).document), without_figures(sorted_sticks().solution.document));
    std::filesystem::copy_file(domain, folder.path + "/domain.pddl");
    try {
        load_scene_problem(folder.path + "/domain.pddl", folder.path + "/problem.pddl", "",
                           folder.path + "/scene.yaml");
        FAIL() << "loaded";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("--streams"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace praxis::tamp
