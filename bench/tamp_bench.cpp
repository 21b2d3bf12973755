// Task and motion planning over generated problems: families x sizes x seeds, one line a family and size.
//
//     tamp_bench [--seeds N] [--limit SECONDS] [--no-nogoods] [--twins] [--plan] [--solve] [--first SEED]
//                [FAMILY[:SIZE,SIZE...]]...
//
// Without names all families at their smallest and middle size. `--twins` takes the infeasible ones, `--plan`
// shows plans and what was tried in vain. `--solve` goes on to motion in time and has the independent
// validators check it: "refused" counts the plans that they refused, so that others were looked for; where
// none is found that they accept, it is said on standard error, and the exit code is 1. `--first` is the
// first seed (1).
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <numeric>
#include <optional>
#include <sstream>

#include "bench/smoke.hpp"
#include "tests/tamp/support/bound_problem.hpp"

namespace {

using namespace praxis;
using namespace praxis::tamp;

struct Selection {
    std::string family;
    std::vector<int> sizes;
};

struct Settings {
    std::vector<Selection> selections;
    int seeds = 10;
    int first = 1;
    double limit = 10;
    RefineOptions options;
    bool feasible = true;
    bool show = false;
    bool solve = false;
};

struct Tally {
    int runs = 0, solved = 0, infeasible = 0, refused = 0, invalid = 0;
    std::vector<double> wall, processor, actions, motions;
    double search = 0, sample = 0;
};

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

void show(const Refinement& found) {
    if (found.plan) {
        for (std::size_t i = 0; i < found.plan->steps.size(); ++i)
            std::printf("    %s\n", found.plan->action(i).c_str());
    }
    for (const Attempt& attempt : found.attempts) {
        if (attempt.count * 60 < found.statistics.stream_calls) continue;
        std::printf("    %llu times %s: %s\n", static_cast<unsigned long long>(attempt.count),
                    attempt.stream.c_str(), attempt.message.c_str());
    }
    for (const std::string& reason : found.reasons) std::printf("    because %s\n", reason.c_str());
}

/// Counts the calls of the streams that plan motions.
void count_motions(StreamLibrary& library, std::uint64_t& count) {
    for (const char* name : {"plan-pick", "plan-place"}) {
        const StreamLibrary::BoundStream bound = *library.find(name);
        library.bind(
            name,
            [callback = bound.callback, &count](StreamCall& call) {
                ++count;
                return callback(call);
            },
            bound.info);
    }
}

/// All phases, with the validators at the end. Empty: these refuse whatever was found.
std::optional<Refinement> solve_wholly(const SceneProblem& problem, const Settings& settings,
                                       const Budget& budget, std::uint64_t& motions, Tally& tally) {
    SolveOptions options;
    options.refine = settings.options;
    SolveCallbacks callbacks;
    callbacks.bind = [&](StreamLibrary& library, const Scene&) { count_motions(library, motions); };
    try {
        Solution solution = solve(problem, options, budget, callbacks);
        tally.refused += solution.refusals;
        return std::move(solution.refinement);
    } catch (const InvalidSolution& fault) {
        std::cerr << fault.what() << '\n';
        return std::nullopt;
    }
}

void run(const Settings& settings, const std::string& family, int size, std::uint64_t seed, Tally& tally) {
    const GeneratedProblem problem = generate_problem(family, size, seed, settings.feasible);
    const std::string folder = (std::filesystem::temp_directory_path() / "praxis-tamp-bench").string();
    write_problem(problem, folder);
    const SceneProblem loaded = scene_problem(problem, folder);
    BoundProblem bound(problem, folder);
    std::uint64_t motions = 0;
    count_motions(bound.streams.library, motions);
    Budget budget;
    budget.limit_wall_time(settings.limit);
    const auto begin = std::chrono::steady_clock::now();
    const double processor = processor_seconds();
    const std::optional<Refinement> ended = settings.solve
                                                ? solve_wholly(loaded, settings, budget, motions, tally)
                                                : bound.refine(budget, settings.options);
    ++tally.runs;
    if (!ended) {
        ++tally.invalid;
        std::cerr << "invalid: " << family << ' ' << size << " seed " << seed << '\n';
        return;
    }
    const Refinement& found = *ended;
    tally.wall.push_back(1e3 *
                         std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    tally.processor.push_back(1e3 * (processor_seconds() - processor));
    tally.motions.push_back(static_cast<double>(motions));
    tally.solved += found.status == RefineStatus::solved ? 1 : 0;
    tally.infeasible += found.status == RefineStatus::infeasible ? 1 : 0;
    if (found.plan) tally.actions.push_back(static_cast<double>(found.plan->steps.size()));
    tally.search += found.statistics.search_seconds;
    tally.sample += found.statistics.sample_seconds;
    if (settings.show) show(found);
}

Selection parse_selection(const std::string& text) {
    const std::size_t colon = text.find(':');
    Selection selection{text.substr(0, colon), {}};
    std::istringstream sizes(colon == std::string::npos ? "" : text.substr(colon + 1));
    for (std::string size; std::getline(sizes, size, ',');) selection.sizes.push_back(std::stoi(size));
    for (const ProblemFamily& family : problem_families()) {
        if (family.name == selection.family && selection.sizes.empty()) {
            selection.sizes = {family.smallest, std::midpoint(family.smallest, family.largest)};
        }
    }
    return selection;
}

Settings parse(int argc, char** argv) {
    Settings settings;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const auto value = [&] {
            if (i + 1 == argc) throw std::invalid_argument(word + " needs a number");
            return std::string(argv[++i]);
        };
        if (word == "--seeds") {
            settings.seeds = std::stoi(value());
        } else if (word == "--limit") {
            settings.limit = std::stod(value());
        } else if (word == "--no-nogoods") {
            settings.options.nogoods = false;
        } else if (word == "--twins") {
            settings.feasible = false;
        } else if (word == "--first") {
            settings.first = std::stoi(value());
        } else if (word == "--solve") {
            settings.solve = true;
        } else if (word == "--plan") {
            settings.show = true;
        } else if (word.starts_with("--")) {
            throw std::invalid_argument("there is no option " + word);
        } else {
            settings.selections.push_back(parse_selection(word));
        }
    }
    if (settings.selections.empty()) {
        for (const ProblemFamily& family : problem_families()) {
            if (settings.feasible || family.has_twin)
                settings.selections.push_back(parse_selection(family.name));
        }
    }
    return settings;
}

Settings smoke_run() {
    Settings settings;
    settings.selections = {{"hanoi", {2}}};
    settings.seeds = 1;
    settings.solve = true;
    return settings;
}

}  // namespace

int main(int argc, char** argv) try {
    const bool smoke = is_smoke_run(argc, argv);
    const Settings settings = smoke ? smoke_run() : parse(argc, argv);
    bool valid = true;
    std::printf("%-18s %4s %8s %10s %7s %9s %9s %9s %8s %8s %8s %8s\n", "family", "size", "solved",
                "infeasible", "refused", "wall ms", "p99 ms", "cpu ms", "actions", "motions", "search%",
                "sample%");
    for (const Selection& selection : settings.selections) {
        for (const int size : selection.sizes) {
            Tally tally;
            for (int seed = settings.first; seed < settings.first + settings.seeds; ++seed) {
                run(settings, selection.family, size, static_cast<std::uint64_t>(seed), tally);
            }
            const double whole = 1e-3 * std::accumulate(tally.wall.begin(), tally.wall.end(), 0.0);
            std::printf("%-18s %4d %4d/%-3d %10d %7d %9.1f %9.1f %9.1f %8.0f %8.0f %8.0f %8.0f\n",
                        selection.family.c_str(), size, tally.solved, tally.runs, tally.infeasible,
                        tally.invalid, quantile(tally.wall, 0.5), quantile(tally.wall, 0.99),
                        quantile(tally.processor, 0.5), quantile(tally.actions, 0.5),
                        quantile(tally.motions, 0.5), 100 * tally.search / whole, 100 * tally.sample / whole);
            std::fflush(stdout);
            if (smoke && tally.solved < tally.runs) return 1;
            valid = valid && tally.invalid == 0;
        }
    }
    return valid ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
