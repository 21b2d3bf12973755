// Motion planning on the MotionBenchMaker problems (Chamzas et al. 2022): processor time of plans, of plans
// with shortcuts and of certified plans, and how many paths the exact checker refuses at 1/128 rad.
//
//     mbm_bench FOLDER [SEEDS] [EVERY] [MODE]
//     mbm_bench --benchmark_min_time=0.001
//
// FOLDER holds panda_spheres.urdf and folders of scene*.yaml and request*.yaml. SEEDS (10): runs of every
// problem; EVERY (1): only each EVERY-th problem. MODE: only this one, without checks by the exact checker:
// plan, shortcuts, certified or both (default: all these); or ompl: OMPL's RRT-Connect on the exact checker,
// for comparison. The second form is for a look whether all this works: it
// needs no folder and plans a few motions of an arm at a shelf.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "bench/smoke.hpp"
#include "parser/files.hpp"
#include "search/engines/random.hpp"
#include "tamp/collision/fast_checker.hpp"
#include "tamp/collision/fcl_checker.hpp"
#include "tamp/motion/ompl_planner.hpp"
#include "tamp/motion/planner.hpp"
#include "tamp/robots/urdf.hpp"
#include "tamp/scenes/moveit.hpp"
#include "tamp/scenes/scene_file.hpp"

namespace {

using namespace praxis::tamp;

constexpr double kFineStep = 1.0 / 128;

/// Of the robot's joints: published figures use them, not those of its safety controller.
const std::map<std::string, std::pair<double, double>> kHardLimits = {
    {"panda_joint1", {-2.9671, 2.9671}}, {"panda_joint2", {-1.8326, 1.8326}},
    {"panda_joint3", {-2.9671, 2.9671}}, {"panda_joint4", {-3.1416, 0.0873}},
    {"panda_joint5", {-2.9671, 2.9671}}, {"panda_joint6", {-0.0873, 3.8223}},
    {"panda_joint7", {-2.9671, 2.9671}}};

struct Problem {
    std::string set;
    std::unique_ptr<CollisionChecker> fast;
    std::unique_ptr<CollisionChecker> exact;
    Configuration start;
    std::vector<Configuration> goals;

    Problem(std::string name, const CollisionProblem& collision, std::vector<Configuration> ends)
        : set(std::move(name)),
          fast(make_fast_checker(collision)),
          exact(make_fcl_checker(collision)),
          start(collision.robot->extract(collision.robot->groups[static_cast<std::size_t>(collision.group)],
                                         collision.rest)),
          goals(std::move(ends)) {}
};

std::vector<Problem> read_problems(const std::filesystem::path& folder, std::size_t every) {
    RobotOptions robot_options;
    robot_options.limits.position = kHardLimits;
    const std::string urdf = (folder / "panda_spheres.urdf").string();
    const auto robot = std::make_shared<const Robot>(read_urdf(urdf, robot_options));
    std::vector<std::filesystem::path> scenes;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().filename().string().starts_with("scene")) scenes.push_back(entry.path());
    }
    std::ranges::sort(scenes);
    std::vector<Problem> problems;
    for (std::size_t i = 0; i < scenes.size(); i += every) {
        const std::string request = "request" + scenes[i].filename().string().substr(5);
        MoveItProblem moveit =
            read_moveit_problem(robot, praxis::read_source(scenes[i].string()),
                                praxis::read_source((scenes[i].parent_path() / request).string()));
        problems.emplace_back(scenes[i].parent_path().filename().string(),
                              CollisionProblem{moveit.robot, moveit.world, moveit.group, moveit.start},
                              std::move(moveit.goals));
    }
    return problems;
}

/// From where a scene starts to configurations drawn at random.
std::vector<Problem> shelf_problems(std::size_t count) {
    const Scene scene = read_scene(PRAXIS_SOURCE_DIR "/problems/tamp/blocked-shelf/3/scene.yaml");
    const int number = scene.robot->find_group("arm");
    const Group& group = scene.robot->groups[static_cast<std::size_t>(number)];
    praxis::Random random(1);
    std::vector<Problem> problems;
    while (problems.size() < count) {
        Configuration goal;
        for (const int variable : group.variables) {
            const Variable& limits = scene.robot->variables[static_cast<std::size_t>(variable)];
            goal.push_back(limits.lower + (limits.upper - limits.lower) * 0x1p-53 *
                                              static_cast<double>(random.next() >> 11));
        }
        Problem problem("shelf", {scene.robot, scene.world, number, scene.start}, {std::move(goal)});
        if (problem.exact->is_free(problem.goals.front())) problems.push_back(std::move(problem));
    }
    return problems;
}

double processor_microseconds() {
    std::timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) / 1e3;
}

struct Tally {
    std::vector<double> times = {};
    int runs = 0;
    int refused = 0;
    double length = 0;

    void print(const std::string& name) {
        std::ranges::sort(times);
        const auto at = [&](double part) {
            if (times.empty()) return 0.0;
            return times[std::min(times.size() - 1,
                                  static_cast<std::size_t>(part * static_cast<double>(times.size())))];
        };
        const double count = std::max(1.0, static_cast<double>(times.size()));
        const double sum = std::accumulate(times.begin(), times.end(), 0.0);
        std::printf("| %-22s | %4zu/%4d | %7.1f | %7.1f | %7.1f | %6.2f | %4d |\n", name.c_str(),
                    times.size(), runs, at(0.5), sum / count, at(0.95), length / count, refused);
        std::fflush(stdout);
    }
};

bool refused(CollisionChecker& exact, const Path& path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (!exact.is_motion_free(path[i], path[i + 1], kFineStep)) return true;
    }
    return false;
}

struct Mode {
    std::string name;
    std::string title;
    bool shorten;
    bool certified;
    bool check;
};

void measure_ompl(Problem& problem, Tally& tally) {
    OmplOptions options;
    options.range = 1;
    options.budget.limit_wall_time(30);
    const double begin = processor_microseconds();
    const OmplResult result = plan_with_ompl(*problem.exact, problem.start, problem.goals, options);
    const double time = processor_microseconds() - begin;
    ++tally.runs;
    if (result.status != OmplStatus::solved) return;
    tally.times.push_back(time);
    tally.length += path_length(result.path);
}

void measure(Problem& problem, const Mode& mode, std::uint64_t seed, Tally& tally) {
    MotionOptions options;
    options.seed = seed;
    options.shorten = mode.shorten;
    options.certified = mode.certified;
    const double begin = processor_microseconds();
    const MotionResult result = plan_motion(*problem.fast, problem.start, problem.goals, options);
    const double time = processor_microseconds() - begin;
    ++tally.runs;
    if (result.status != MotionStatus::solved) {
        if (seed == 0) std::cerr << problem.set << ": " << to_string(result.status) << '\n';
        return;
    }
    tally.times.push_back(time);
    tally.length += path_length(result.path);
    if (mode.check && refused(*problem.exact, result.path)) ++tally.refused;
}

/// Whether all was solved, and the exact checker refused no certified path.
bool run(std::vector<Problem>& problems, std::uint64_t seeds, const std::string& only) {
    std::cout << problems.size() << " problems with free start and goal, " << seeds << " seeds\n"
              << "| mode                   | solved    | median  | mean    | p95 us  | length | refused at "
                 "1/128 |\n";
    bool good = true;
    if (only == "ompl") {
        Tally all;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            for (Problem& problem : problems) measure_ompl(problem, all);
        }
        all.print("OMPL on FCL");
    }
    for (Mode mode :
         {Mode{"plan", "plan", false, false, false}, Mode{"shortcuts", "plan + shortcuts", true, false, true},
          Mode{"certified", "certified", false, true, true},
          Mode{"both", "certified + shortcuts", true, true, true}}) {
        if (!only.empty() && only != mode.name) continue;
        mode.check = mode.check && only.empty();
        Tally all;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            for (Problem& problem : problems) measure(problem, mode, seed, all);
        }
        all.print(mode.title);
        good = good && all.runs == static_cast<int>(all.times.size()) && !(mode.certified && all.refused > 0);
    }
    return good;
}

}  // namespace

int main(int argc, char** argv) try {
    if (praxis::is_smoke_run(argc, argv)) {
        std::vector<Problem> problems = shelf_problems(5);
        return run(problems, 1, "") ? 0 : 1;
    }
    if (argc < 2 || argv[1][0] == '-') {
        std::cerr << "usage: mbm_bench FOLDER [SEEDS] [EVERY] [MODE]\n";
        return 2;
    }
    const std::uint64_t seeds = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 10;
    const std::size_t every = argc > 3 ? std::max(1ULL, std::strtoull(argv[3], nullptr, 10)) : 1;
    std::vector<Problem> problems = read_problems(argv[1], every);
    std::erase_if(problems, [](Problem& problem) {
        return !problem.exact->is_free(problem.start) || !problem.exact->is_free(problem.goals.front());
    });
    run(problems, seeds, argc > 4 ? argv[4] : "");
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
