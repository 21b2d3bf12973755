// The fast checker against the exact one, on random configurations in generated scenes: contacts that the
// fast one misses (there must be none), contacts that only it sees, microseconds of a state and of making a
// checker.
//
//     checker_bench [STATES]
//
// STATES (1000000): configurations of each scene. Exit status 1: a contact was missed, or more than 0.2 % of
// the free states were refused.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>

#include "bench/smoke.hpp"
#include "tamp/collision/fast_checker.hpp"
#include "tamp/collision/fcl_checker.hpp"
#include "tamp/problems/generate.hpp"
#include "tamp/scenes/scene_file.hpp"
#include "tests/tamp/support/ball_arm.hpp"

namespace {

using namespace praxis::tamp;

double processor_microseconds() {
    std::timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) / 1e3;
}

template <class Run>
double time_of(Run&& run) {
    const double begin = processor_microseconds();
    run();
    return processor_microseconds() - begin;
}

Scene scene_of(const std::string& family, int size) {
    const auto folder = std::filesystem::temp_directory_path() / "praxis-checker-bench";
    write_problem(generate_problem(family, size, 1), folder.string());
    Scene scene = read_scene((folder / "scene.yaml").string());
    std::filesystem::remove_all(folder);
    return scene;
}

/// The group that moves most.
int largest_group(const Robot& robot) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < robot.groups.size(); ++i) {
        if (robot.groups[i].variables.size() > robot.groups[best].variables.size()) best = i;
    }
    return static_cast<int>(best);
}

struct Tally {
    long states = 0, free = 0, missed = 0, refused = 0;
    double fast = 0, exact = 0;
};

Tally compare(const CollisionProblem& problem, long states) {
    constexpr long kBatch = 1000;
    const auto fast = make_fast_checker(problem);
    const auto exact = make_fcl_checker(problem);
    const Group& group = problem.robot->groups[static_cast<std::size_t>(problem.group)];
    praxis::Random random(1);
    Tally tally;
    std::vector<Configuration> batch(kBatch);
    std::vector<bool> says(kBatch);
    std::vector<bool> is(kBatch);
    for (; tally.states < states; tally.states += kBatch) {
        for (Configuration& positions : batch) positions = random_positions(*problem.robot, group, random);
        tally.fast += time_of([&] {
            for (std::size_t i = 0; i < batch.size(); ++i) says[i] = fast->is_free(batch[i]);
        });
        tally.exact += time_of([&] {
            for (std::size_t i = 0; i < batch.size(); ++i) is[i] = exact->is_free(batch[i]);
        });
        for (std::size_t i = 0; i < batch.size(); ++i) {
            tally.free += is[i] ? 1 : 0;
            tally.missed += says[i] && !is[i] ? 1 : 0;
            tally.refused += is[i] && !says[i] ? 1 : 0;
        }
    }
    return tally;
}

/// Microseconds, with what depends on the robot and the bodies alone made before.
double making(const CollisionProblem& problem) {
    constexpr int kTimes = 200;
    const auto cache = make_solid_cache();
    make_fast_checker(problem, cache);
    return time_of([&] {
               for (int i = 0; i < kTimes; ++i) make_fast_checker(problem, cache);
           }) /
           kTimes;
}

/// Whether the fast checker kept its promises.
bool run(const std::string& family, int size, long states) {
    const Scene scene = scene_of(family, size);
    const CollisionProblem problem = {scene.robot, scene.world, largest_group(*scene.robot), scene.start};
    const Tally tally = compare(problem, states);
    const double count = static_cast<double>(tally.states);
    const double free = static_cast<double>(tally.free);
    const double refused = free > 0 ? 100 * static_cast<double>(tally.refused) / free : 0;
    std::printf("| %-20s | %9ld | %5.1f | %6ld | %7.4f | %7.2f | %7.2f | %7.1f |\n",
                (family + " " + std::to_string(size)).c_str(), tally.states, 100 * free / count, tally.missed,
                refused, tally.fast / count, tally.exact / count, making(problem));
    std::fflush(stdout);
    return tally.missed == 0 && refused <= 0.2;
}

}  // namespace

int main(int argc, char** argv) try {
    const bool smoke = praxis::is_smoke_run(argc, argv);
    const long states = smoke ? 1000 : argc > 1 ? std::strtol(argv[1], nullptr, 10) : 1000000;
    if (states < 1) {
        std::cerr << "usage: checker_bench [STATES]\n";
        return 2;
    }
    std::cout << "| scene                | states    | free % | missed | refused % | fast us | exact us | "
                 "making us |\n";
    bool good = true;
    for (const auto& [family, size] : {std::pair{"blocked-shelf", 8},
                                       {"clutter", 12},
                                       {"packing", 4},
                                       {"rooms", 6},
                                       {"rooms-octomap", 6},
                                       {"point-cloud-shelf", 3},
                                       {"namo", 20}}) {
        good = run(family, size, states) && good;
    }
    return good ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
