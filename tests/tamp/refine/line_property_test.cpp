// Small worlds of blocks on a line, against a search through all their states.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <deque>
#include <set>

#include "parser/files.hpp"
#include "search/engines/random.hpp"
#include "tests/tamp/support/line_world.hpp"

namespace praxis::tamp {
namespace {

using test::Interval;
using test::LineWorld;

struct SmallLine {
    LineWorld world;
    std::vector<Interval> regions;
    std::vector<double> start;                 ///< by block
    std::vector<std::vector<bool>> stackable;  ///< by block and region
    std::vector<int> goal;                     ///< by block: region; -1: anywhere

    std::string problem() const {
        std::string objects = "(:objects home - configuration";
        std::string init = "(:init (configuration home) (at-configuration home) (hand-empty) (can-move)";
        std::string wanted = "(:goal (and (hand-empty) (at-configuration home)";
        for (std::size_t r = 0; r < regions.size(); ++r) objects += " r" + std::to_string(r) + " - region";
        for (std::size_t b = 0; b < start.size(); ++b) {
            const std::string n = std::to_string(b);
            objects += " b" + n + " - block p" + n + " - pose";
            init += " (pose b" + n + " p" + n + ") (at-pose b" + n + " p" + n + ")";
            for (std::size_t r = 0; r < regions.size(); ++r)
                if (stackable[b][r]) init += " (stackable b" + n + " r" + std::to_string(r) + ")";
            if (goal[b] >= 0) wanted += " (in b" + n + " r" + std::to_string(goal[b]) + ")";
        }
        return "(define (problem small) (:domain line) " + objects + ") " + init + ") " + wanted + ")))";
    }

    std::map<std::string, Value, std::less<>> values() const {
        std::map<std::string, Value, std::less<>> result{{"home", Value::of(0.0)}};
        for (std::size_t r = 0; r < regions.size(); ++r)
            result["r" + std::to_string(r)] = Value::of(regions[r]);
        for (std::size_t b = 0; b < start.size(); ++b) result["p" + std::to_string(b)] = Value::of(start[b]);
        return result;
    }

    /// Poses of a region, as the stream makes them.
    std::vector<double> poses(std::size_t region) const {
        const double room = regions[region].high - regions[region].low - world.block_width;
        std::vector<double> result;
        for (std::uint32_t k = 0; room >= 0 && k < world.poses; ++k)
            result.push_back(regions[region].low + world.block_width / 2 +
                             (world.poses == 1 ? 0.5 : static_cast<double>(k) / (world.poses - 1)) * room);
        return result;
    }

    bool solvable() const {
        using State =
            std::vector<std::pair<int, double>>;  // by block: region (-1: where it started), position
        State first;
        for (const double position : start) first.emplace_back(-1, position);
        std::set<State> seen{first};
        std::deque<State> open{first};
        const auto in_reach = [&](double x) { return x >= world.reach.low && x <= world.reach.high; };
        while (!open.empty()) {
            const State state = open.front();
            open.pop_front();
            bool reached = true;
            for (std::size_t b = 0; b < state.size(); ++b)
                reached = reached && (goal[b] < 0 || state[b].first == goal[b]);
            if (reached) return true;
            for (std::size_t b = 0; b < state.size(); ++b) {
                if (!in_reach(state[b].second)) continue;
                for (std::size_t r = 0; r < regions.size(); ++r) {
                    if (!stackable[b][r]) continue;
                    for (const double pose : poses(r)) {
                        bool free = in_reach(pose);
                        for (std::size_t other = 0; other < state.size(); ++other)
                            free = free &&
                                   (other == b || std::abs(state[other].second - pose) >= world.block_width);
                        State next = state;
                        next[b] = {static_cast<int>(r), pose};
                        if (free && seen.insert(next).second) open.push_back(next);
                    }
                }
            }
        }
        return false;
    }
};

SmallLine random_line(std::uint64_t seed) {
    Random random(seed);
    const auto number = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random.below(9)) / 8;
    };
    SmallLine line;
    line.world.poses = 1 + static_cast<std::uint32_t>(random.below(3));
    line.world.reach = {number(-6, -1), number(1, 6)};
    const std::size_t regions = 1 + random.below(2);
    for (std::size_t r = 0; r < regions; ++r) {
        const double low = number(-5, 4);
        line.regions.push_back({low, low + number(0.5, 3.5)});
    }
    const std::size_t blocks = 1 + random.below(3);
    for (std::size_t b = 0; b < blocks; ++b) {
        line.start.push_back(number(-2, 2) + 3.0 * static_cast<double>(b) - 3);
        line.goal.push_back(static_cast<int>(random.below(regions + 1)) - 1);
        line.stackable.emplace_back();
        for (std::size_t r = 0; r < regions; ++r) line.stackable.back().push_back(random.below(4) != 0);
    }
    return line;
}

RC_GTEST_PROP(LineProperty, AgreesWithAllStatesOfSmallWorlds, ()) {
    const SmallLine line = random_line(*rc::gen::arbitrary<std::uint64_t>());
    const std::string folder = std::string(PRAXIS_SOURCE_DIR) + "/domains/tamp/line/";
    const StreamTask task = parse_streams(read_source(folder + "domain.pddl"), {"problem", line.problem()},
                                          read_source(folder + "streams.pddl"))
                                .task;
    const StreamLibrary library = line.world.library();
    const Refinement result = refine({&task, &library, line.values(), {}});
    RC_ASSERT(result.status == (line.solvable() ? RefineStatus::solved : RefineStatus::infeasible));
}

}  // namespace
}  // namespace praxis::tamp
