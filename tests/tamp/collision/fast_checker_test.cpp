#include "tamp/collision/fast_checker.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "tamp/collision/kernel_model.hpp"
#include "tamp/robots/builtin.hpp"
#include "tamp/scenes/occupancy_map.hpp"
#include "tests/tamp/support/ball_arm.hpp"

namespace praxis::tamp {
namespace {

/// States of each scene that the two checkers are compared at; PRAXIS_STATES=1000000 for a thorough run.
int states() {
    if (const char* wanted = std::getenv("PRAXIS_STATES")) return std::max(1, std::atoi(wanted));
#ifdef PRAXIS_SANITIZED
    return 500;
#else
    return 20000;
#endif
}

struct Comparison {
    int free = 0;          ///< for the exact checker
    int missed = 0;        ///< contacts that the fast checker did not see
    int false_alarms = 0;  ///< contacts that only the fast checker sees
};

Comparison compare(const CollisionProblem& problem, std::uint64_t seed) {
    const auto fast = make_fast_checker(problem);
    const auto exact = make_fcl_checker(problem);
    const Group& group = problem.robot->groups[static_cast<std::size_t>(problem.group)];
    Random random(seed);
    Comparison result;
    for (int i = 0; i < states(); ++i) {
        const Configuration positions = random_positions(*problem.robot, group, random);
        const bool free = exact->is_free(positions);
        const bool says_free = fast->is_free(positions);
        result.free += free ? 1 : 0;
        result.missed += !free && says_free ? 1 : 0;
        result.false_alarms += free && !says_free ? 1 : 0;
    }
    return result;
}

CollisionProblem problem_of(std::shared_ptr<const Robot> robot, World world, int group) {
    Configuration rest = robot->zero();
    return {std::move(robot), std::make_shared<const World>(std::move(world)), group, std::move(rest)};
}

void expect_agreement(const CollisionProblem& problem, std::uint64_t seed) {
    const Comparison comparison = compare(problem, seed);
    EXPECT_EQ(comparison.missed, 0);
    EXPECT_GT(comparison.free, states() / 50);
    EXPECT_LT(comparison.free, states());
    EXPECT_LE(comparison.false_alarms, states() / 500);
}

TEST(FastChecker, AnArmOfBallsAmongAllShapesIsFreeOnlyWhereItIsExactly) {
    Random random(1);
    expect_agreement(problem_of(ball_arm(), random_world(random, 12), 0), 2);
}

TEST(FastChecker, AnArmOfBallsOnAMovingBaseIsFreeOnlyWhereItIsExactly) {
    const auto robot = ball_arm(true);
    Random random(3);
    const World world = random_world(random, 12);
    expect_agreement(problem_of(robot, world, robot->find_group("all")), 4);
}

/// Joints that are not at right angles, and at the end of the arm one that slides.
std::shared_ptr<const Robot> crooked_arm() {
    Robot robot = *ball_arm();
    Random random(21);
    for (Joint& joint : robot.joints) {
        joint.origin = joint.origin *
                       pose_from_rpy(Vector3::Zero(), {uniform(random, -1, 1), uniform(random, -1, 1), 0});
    }
    const auto last = std::ranges::find(robot.joints, 6, &Joint::variable);
    last->type = JointType::prismatic;
    robot.variables[6].lower = -0.3;
    robot.variables[6].upper = 0.3;
    return std::make_shared<const Robot>(std::move(robot));
}

TEST(FastChecker, ACrookedArmIsFreeOnlyWhereItIsExactly) {
    Random random(23);
    expect_agreement(problem_of(crooked_arm(), random_world(random, 12), 0), 24);
}

TEST(FastChecker, WhatCoversCannotTellTheExactCheckerDoes) {
    const auto robot = std::make_shared<const Robot>(builtin_robot("arm7"));
    Random random(5);
    const World world = random_world(random, 8);
    expect_agreement(problem_of(robot, world, robot->find_group("arm")), 6);
}

TEST(FastChecker, HeldBodiesAreLookedAtAndMayTouchTheHand) {
    const auto robot = std::make_shared<const Robot>(builtin_robot("arm7"));
    const EndEffector& hand = robot->end_effectors.front();
    Random random(7);
    World world = random_world(random, 8);
    BodyModel model;
    model.name = "held";
    model.shapes.push_back({Pose::Identity(), Box{{0.04, 0.04, 0.1}}});
    model.balls = cover(model.shapes);
    world = world.with_body(std::make_shared<const BodyModel>(std::move(model)), Pose::Identity());
    const int held = world.find("held");
    const World carrying = world.with_attached(held, {hand.link, hand.tool, hand.links});
    expect_agreement(problem_of(robot, carrying, robot->find_group("arm")), 8);
}

/// The skin of a ball, in triangles.
std::shared_ptr<const Mesh> dome(double radius) {
    constexpr std::uint32_t kSides = 12;
    Mesh mesh = {.name = "dome"};
    for (std::uint32_t i = 0; i <= kSides; ++i) {
        for (std::uint32_t j = 0; j < kSides; ++j) {
            const double polar = std::numbers::pi * i / kSides;
            const double around = 2 * std::numbers::pi * j / kSides;
            mesh.vertices.push_back(radius * Vector3(std::sin(polar) * std::cos(around),
                                                     std::sin(polar) * std::sin(around), std::cos(polar)));
            if (i == 0) continue;
            const std::uint32_t next = (j + 1) % kSides;
            const std::uint32_t above = (i - 1) * kSides;
            const std::uint32_t below = i * kSides;
            mesh.triangles.push_back({above + j, below + j, below + next});
            mesh.triangles.push_back({above + j, below + next, above + next});
        }
    }
    return std::make_shared<const Mesh>(std::move(mesh));
}

TEST(FastChecker, MeshesAreAskedAboutByDistances) {
    Random random(17);
    BodyModel model;
    model.name = "dome";
    model.shapes.push_back({Pose::Identity(), dome(0.3)});
    World world = random_world(random, 4);
    world = world.with_body(std::make_shared<const BodyModel>(std::move(model)),
                            pose_from_rpy({0.5, 0.3, 0.4}, {0.4, 0.2, 0.1}));
    expect_agreement(problem_of(ball_arm(), world, 0), 18);
}

TEST(FastChecker, MapsAreAskedAboutByDistances) {
    Random random(19);
    VoxelGrid grid = {{-1, -1, -0.2}, 0.04, {50, 50, 40}};
    std::vector<Occupancy> cells(grid.size(), Occupancy::free);
    for (int i = 0; i < 150; ++i) {
        const std::array<int, 3> corner = {static_cast<int>(random.below(48)),
                                           static_cast<int>(random.below(48)),
                                           static_cast<int>(random.below(38))};
        if (std::abs(corner[0] - 24) < 10 && std::abs(corner[1] - 24) < 10) continue;
        const Occupancy occupancy = i % 2 == 0 ? Occupancy::occupied : Occupancy::unknown;
        for (int k = 0; k < 8; ++k) {
            cells[grid.index(corner[0] + (k & 1), corner[1] + (k >> 1 & 1), corner[2] + (k >> 2))] =
                occupancy;
        }
    }
    BodyModel model;
    model.name = "map";
    model.shapes.push_back({Pose::Identity(), std::make_shared<const OccupancyMap>(grid, std::move(cells))});
    const auto shared = std::make_shared<const BodyModel>(std::move(model));
    expect_agreement(problem_of(ball_arm(), World().with_body(shared, Pose::Identity()), 0), 20);
    const Pose turned = pose_from_rpy({0.1, 0, 0.1}, {0.2, -0.1, 0.5});
    expect_agreement(problem_of(ball_arm(), World().with_body(shared, turned), 0), 20);
}

TEST(FastChecker, FixedContactsLeaveNothingFree) {
    const auto robot = ball_arm();
    BodyModel model;
    model.name = "stone";
    model.shapes.push_back({Pose::Identity(), Sphere{0.05}});
    const World world =
        World().with_body(std::make_shared<const BodyModel>(std::move(model)), Pose::Identity());
    const auto checker = make_fast_checker(problem_of(robot, world, 0));
    EXPECT_EQ(checker->fixed_contacts(),
              (std::vector<Contact>{{{Participant::Kind::link, 0}, {Participant::Kind::body, 0}}}));
    EXPECT_FALSE(checker->is_free(robot->zero()));
    EXPECT_FALSE(checker->is_motion_free(robot->zero(), robot->zero(), kCheckStep));
    EXPECT_FALSE(checker->is_motion_certified(robot->zero(), robot->zero()));
}

TEST(FastChecker, WholeTurnsChangeNothing) {
    const auto robot = ball_arm(true);
    Random random(9);
    const int group = robot->find_group("all");
    const auto checker = make_fast_checker(problem_of(robot, random_world(random, 20), group));
    int free = 0;
    for (int i = 0; i < 300; ++i) {
        Configuration positions =
            random_positions(*robot, robot->groups[static_cast<std::size_t>(group)], random);
        const bool before = checker->is_free(positions);
        positions[2] += 14 * std::numbers::pi;
        EXPECT_EQ(checker->is_free(positions), before);
        free += before ? 1 : 0;
    }
    EXPECT_GT(free, 0);
    EXPECT_LT(free, 300);
}

TEST(FastChecker, WrongPositionsAreRefused) {
    const auto robot = ball_arm();
    const auto checker = make_fast_checker(problem_of(robot, World(), 0));
    EXPECT_THROW(checker->is_free(Configuration(6, 0.0)), std::invalid_argument);
    EXPECT_THROW(checker->is_free(Configuration(7, std::nan(""))), std::invalid_argument);
    EXPECT_THROW(checker->is_free(Configuration(7, 1e9)), std::invalid_argument);
    EXPECT_THROW(checker->is_motion_free(robot->zero(), robot->zero(), 0), std::invalid_argument);
    EXPECT_THROW(make_fast_checker({robot, std::make_shared<const World>(), 7, robot->zero()}),
                 std::invalid_argument);
    EXPECT_THROW(make_fast_checker({robot, nullptr, 0, robot->zero()}), std::invalid_argument);
}

/// Motions between random states that are free, at most `longest` long.
struct Motions {
    CollisionProblem problem;
    std::unique_ptr<CollisionChecker> fast;
    std::unique_ptr<CollisionChecker> exact;
    Random random;

    Motions(const CollisionProblem& given, std::uint64_t seed)
        : problem(given), fast(make_fast_checker(given)), exact(make_fcl_checker(given)), random(seed) {}

    std::pair<Configuration, Configuration> next(double longest) {
        const Group& group = problem.robot->groups[static_cast<std::size_t>(problem.group)];
        const Configuration from = random_positions(*problem.robot, group, random);
        Configuration to = random_positions(*problem.robot, group, random);
        double squares = 0;
        for (std::size_t v = 0; v < to.size(); ++v) squares += (to[v] - from[v]) * (to[v] - from[v]);
        const double part = std::min(1.0, longest / std::sqrt(squares));
        for (std::size_t v = 0; v < to.size(); ++v) to[v] = from[v] + part * (to[v] - from[v]);
        return {from, to};
    }
};

void expect_proofs_to_hold(const CollisionProblem& problem, std::uint64_t seed, int count) {
    Motions motions(problem, seed);
    int certified = 0;
    int slipped = 0;
    for (int i = 0; i < count; ++i) {
        const auto [from, to] = motions.next(1);
        const bool coarse = motions.fast->is_motion_free(from, to, kCheckStep);
        if (!motions.fast->is_motion_certified(from, to)) {
            slipped += coarse ? 1 : 0;
            continue;
        }
        ++certified;
        EXPECT_TRUE(motions.exact->is_motion_free(from, to, 1.0 / 500));
        EXPECT_TRUE(motions.fast->is_motion_free(from, to, kCheckStep));
    }
    EXPECT_GT(certified, count / 20);
    EXPECT_LT(certified, count);
    EXPECT_LT(slipped, count / 4);
}

TEST(FastChecker, CertifiedMotionsAreFreeAtEveryStep) {
    Random random(11);
    expect_proofs_to_hold(problem_of(ball_arm(), random_world(random, 10), 0), 12, states() / 40);
}

TEST(FastChecker, CertifiedMotionsOfABaseAreFreeAtEveryStep) {
    const auto robot = ball_arm(true);
    Random random(13);
    const World world = random_world(random, 10);
    expect_proofs_to_hold(problem_of(robot, world, robot->find_group("all")), 14, states() / 40);
}

TEST(FastChecker, CertifiedMotionsOfACrookedArmAreFreeAtEveryStep) {
    Random random(25);
    expect_proofs_to_hold(problem_of(crooked_arm(), random_world(random, 10), 0), 26, states() / 40);
}

TEST(FastChecker, MotionsAreFreeIfTheirConfigurationsAre) {
    Random random(15);
    Motions motions(problem_of(ball_arm(), random_world(random, 10), 0), 16);
    for (int i = 0; i < states() / 40; ++i) {
        const auto [from, to] = motions.next(3);
        const bool free = motions.fast->is_motion_free(from, to, kCheckStep);
        EXPECT_EQ(motions.fast->is_free(from) && motions.fast->is_extension_free(from, to), free);
        if (!free) continue;
        EXPECT_TRUE(motions.fast->is_free(from));
        EXPECT_TRUE(motions.fast->is_free(to));
    }
}

}  // namespace
}  // namespace praxis::tamp
