// Inverse kinematics against Orocos KDL: targets solved and processor time, on poses of random configurations
// of a seven-joint arm (and of that arm on a mobile base). Then straight lines of the tool, and timing paths.
//
//     build/bin/ik_bench [TARGETS]
#include <time.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "bench/smoke.hpp"
#include "search/engines/random.hpp"
#include "tamp/motion/inverse_kinematics.hpp"
#include "tamp/motion/straight_line.hpp"
#include "tamp/motion/time_parametrisation.hpp"
#include "tests/tamp/support/panda.hpp"

namespace praxis::tamp {
namespace {

constexpr int kAttempts = 100;
constexpr double kTurn = 2 * std::numbers::pi;

double thread_microseconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

double uniform(Random& random, double lower, double upper) {
    return lower + (upper - lower) * 0x1p-53 * static_cast<double>(random.next() >> 11);
}

Configuration random_positions(const Robot& robot, int group, Random& random) {
    Configuration positions;
    for (int variable : robot.groups[static_cast<std::size_t>(group)].variables) {
        const Variable& limits = robot.variables[static_cast<std::size_t>(variable)];
        positions.push_back(limits.continuous ? uniform(random, -kTurn / 2, kTurn / 2)
                                              : uniform(random, limits.lower, limits.upper));
    }
    return positions;
}

/// Runs `solve` on every target and prints a row of the table.
void report(const std::string& name, const std::vector<Pose>& targets,
            const std::function<bool(const Pose&)>& solve) {
    std::vector<double> times;
    std::size_t solved = 0;
    double total = 0;
    for (const Pose& target : targets) {
        const double before = thread_microseconds();
        solved += solve(target) ? 1 : 0;
        times.push_back(thread_microseconds() - before);
        total += times.back();
    }
    std::ranges::sort(times);
    const auto quantile = [&](double q) {
        return times[static_cast<std::size_t>(q * static_cast<double>(times.size() - 1))];
    };
    std::printf("| %-44s | %6zu / %zu | %8.1f | %8.1f | %8.1f | %8.1f |\n", name.c_str(), solved,
                targets.size(), quantile(0.5), total / static_cast<double>(targets.size()), quantile(0.99),
                times.back());
    std::fflush(stdout);
}

KDL::Frame to_kdl(const Pose& pose) {
    KDL::Rotation rotation;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) rotation(i, j) = pose(i, j);
    }
    return {rotation, KDL::Vector(pose(0, 3), pose(1, 3), pose(2, 3))};
}

KDL::Chain kdl_chain(const Robot& robot) {
    KDL::Chain chain;
    for (const Joint& joint : robot.joints) {
        // A segment of KDL turns first and is fixed afterwards: the origin comes as a segment of its own.
        chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::Fixed), to_kdl(joint.origin)));
        if (joint.type != JointType::fixed) chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ)));
    }
    return chain;
}

/// Within tolerances and limits, by our forward kinematics.
bool right(const Robot& robot, const Pose& target, const KDL::JntArray& found) {
    Configuration positions(found.data.data(), found.data.data() + found.rows());
    if (!robot.within_limits(robot.groups[0], positions)) return false;
    const Pose reached = link_pose(robot, positions, robot.groups[0].tip);
    const double angle = Eigen::AngleAxisd(reached.linear().transpose() * target.linear()).angle();
    return (reached.translation() - target.translation()).norm() < 1e-4 && angle < 1e-3;
}

void run(std::size_t count) {
    std::printf("| %-44s | solved | median us | mean us | p99 us | most us |\n", "solver");
    std::printf("| --- | --- | --- | --- | --- | --- |\n");
    const std::shared_ptr<const Robot> arm = panda_arm();
    Random random(1);
    std::vector<Pose> targets;
    const InverseKinematics ik(arm, 0, arm->groups[0].tip);
    for (std::size_t i = 0; i < count; ++i) {
        targets.push_back(ik.forward(random_positions(*arm, 0, random)));
    }
    report("ours, 7 joints", targets,
           [&](const Pose& target) { return bool(ik.solve(target, {.attempts = kAttempts})); });
    report("ours, 7 joints, another seed", targets,
           [&](const Pose& target) { return bool(ik.solve(target, {.attempts = kAttempts, .seed = 7})); });
    const Configuration middle = {0, 0, 0, -1.5, 0, 1.9, 0};
    report("ours, 7 joints, near a posture", targets, [&](const Pose& target) {
        return bool(ik.solve(target, {.posture = middle, .attempts = kAttempts}));
    });
    report("ours, 7 joints, eight solutions", targets,
           [&](const Pose& target) { return ik.solve_all(target, 8, {.attempts = kAttempts}).size() == 8; });

    const KDL::Chain chain = kdl_chain(*arm);
    KDL::JntArray lower(7);
    KDL::JntArray upper(7);
    for (unsigned j = 0; j < 7; ++j) {
        lower(j) = arm->variables[j].lower;
        upper(j) = arm->variables[j].upper;
    }
    KDL::ChainFkSolverPos_recursive forward(chain);
    KDL::ChainIkSolverVel_pinv velocity(chain);
    KDL::ChainIkSolverPos_NR_JL newton(chain, lower, upper, forward, velocity, 100, 1e-5);
    KDL::ChainIkSolverPos_LMA marquardt(chain, 1e-5, 100);
    const auto with_restarts = [&](KDL::ChainIkSolverPos& solver) {
        return [&](const Pose& target) {
            const KDL::Frame frame = to_kdl(target);
            KDL::JntArray start(7);
            KDL::JntArray found(7);
            for (int attempt = 0; attempt < kAttempts; ++attempt) {
                for (unsigned j = 0; j < 7; ++j) start(j) = uniform(random, lower(j), upper(j));
                if (solver.CartToJnt(start, frame, found) < 0) continue;
                if (right(*arm, target, found)) return true;
            }
            return false;
        };
    };
    const std::vector<Pose> fewer(targets.begin(),
                                  targets.begin() + static_cast<long>(std::min<std::size_t>(count, 1000)));
    report("KDL NR_JL, random restarts, 7 joints", fewer, with_restarts(newton));
    report("KDL LMA, random restarts until within limits", fewer, with_restarts(marquardt));

    const std::shared_ptr<const Robot> mobile = panda_arm(true);
    const InverseKinematics whole(mobile, 1, mobile->groups[1].tip);
    targets.clear();
    for (std::size_t i = 0; i < count; ++i) {
        targets.push_back(whole.forward(random_positions(*mobile, 1, random)));
    }
    report("ours, 10 variables: base and arm", targets,
           [&](const Pose& target) { return bool(whole.solve(target, {.attempts = kAttempts})); });
}

/// The median of the times of `run`, on `count` problems.
template <class Run>
void report_median(const char* name, std::size_t count, Run&& solve) {
    std::vector<double> times;
    for (std::size_t i = 0; i < count; ++i) {
        const double before = thread_microseconds();
        solve(i);
        times.push_back(thread_microseconds() - before);
    }
    std::ranges::sort(times);
    std::printf("| %-44s | %8.1f |\n", name, times[times.size() / 2]);
}

void run_others(std::size_t count) {
    const std::shared_ptr<const Robot> arm = panda_arm();
    const Group& group = arm->groups[0];
    const MotionLimits limits = motion_limits(*arm, group);
    Random random(2);
    std::printf("\n| %-44s | median us |\n| --- | --- |\n", "what");
    for (const std::size_t waypoints : {5UL, 20UL, 100UL}) {
        std::vector<Path> paths(count);
        for (Path& path : paths) {
            for (std::size_t i = 0; i < waypoints; ++i) path.push_back(random_positions(*arm, 0, random));
        }
        report_median(("timing a path of " + std::to_string(waypoints) + " waypoints").c_str(), count,
                      [&](std::size_t i) { time_parametrise(paths[i], limits); });
    }
    const InverseKinematics ik(arm, 0, group.tip);
    const Configuration ready = {0, -0.6, 0, -2.2, 0, 1.6, 0.8};
    Pose target = ik.forward(ready);
    target.translation() += Vector3(0, 0, -0.2);
    report_median("straight line of 20 cm, 10 steps", count,
                  [&](std::size_t) { straight_line(ik, ready, target); });
    report_median("making a solver", std::min<std::size_t>(count, 200),
                  [&](std::size_t) { InverseKinematics(arm, 0, group.tip); });
}

}  // namespace
}  // namespace praxis::tamp

int main(int argc, char** argv) {
    const bool smoke = praxis::is_smoke_run(argc, argv);
    const long count = smoke ? 20 : argc > 1 ? std::strtol(argv[1], nullptr, 10) : 10000;
    if (count < 1) {
        std::fprintf(stderr, "usage: ik_bench [TARGETS]\n");
        return 2;
    }
    praxis::tamp::run(static_cast<std::size_t>(count));
    praxis::tamp::run_others(smoke ? 20 : 2000);
}
