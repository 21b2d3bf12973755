// The streams of domains/tamp/line, for tests and benchmarks.
#pragma once

#include <cmath>
#include <string>
#include <utility>

#include "tamp/refine/refine.hpp"

namespace praxis::tamp::test {

struct Interval {
    double low = 0;
    double high = 0;
};

struct LineWorld {
    double block_width = 1;
    Interval reach = {-100, 100};
    /// Poses per block and region: so many, evenly spaced; 0: at random, without end.
    std::uint32_t poses = 0;

    /// The callbacks copy this world.
    StreamLibrary library() const {
        const LineWorld world = *this;
        StreamLibrary library;
        StreamInfo once;
        once.max_samples = 1;
        StreamInfo poses_info;
        if (poses > 0) poses_info.max_samples = poses;
        library.bind(
            "sample-pose", [world](StreamCall& call) { return world.sample_pose(call); }, poses_info);
        library.bind(
            "sample-grasp", [](StreamCall&) { return StreamResult::sample({Value::of(0.0)}); }, once);
        library.bind(
            "inverse-kinematics", [world](StreamCall& call) { return world.solve(call); }, once);
        library.bind(
            "plan-motion",
            [](StreamCall& call) {
                return StreamResult::sample(
                    {Value::of(std::pair(call.inputs[0].get<double>(), call.inputs[1].get<double>()))});
            },
            once);
        library.bind("test-apart", [world](StreamCall& call) { return world.test_apart(call); });
        library.bind_function("distance", [](std::span<const Value> inputs) {
            return std::abs(inputs[0].get<double>() - inputs[1].get<double>());
        });
        return library;
    }

    StreamResult sample_pose(StreamCall& call) const {
        const Interval& region = call.inputs[1].get<Interval>();
        const double room = region.high - region.low - block_width;
        if (room < 0) return StreamResult::exhausted({.message = "the region is too narrow"});
        double part = 0;
        if (poses == 0) {
            part = static_cast<double>(call.random.next() >> 11) * 0x1p-53;
        } else {
            if (call.attempt >= poses) return StreamResult::exhausted();
            part = poses == 1 ? 0.5 : static_cast<double>(call.attempt) / (poses - 1);
        }
        return StreamResult::sample({Value::of(region.low + block_width / 2 + part * room)});
    }

    StreamResult solve(StreamCall& call) const {
        const double position = call.inputs[1].get<double>() + call.inputs[2].get<double>();
        if (position < reach.low || position > reach.high)
            return StreamResult::reject({.reason = Reason::kinematics, .message = "out of reach"});
        return StreamResult::sample({Value::of(position)});
    }

    StreamResult test_apart(StreamCall& call) const {
        const double distance = std::abs(call.inputs[1].get<double>() - call.inputs[3].get<double>());
        if (distance >= block_width) return StreamResult::pass();
        return StreamResult::reject({.reason = Reason::collision, .message = "the blocks would overlap"});
    }
};

inline StreamTask load_line(const std::string& root, const std::string& problem) {
    const std::string domain = root + "/domains/tamp/line/";
    return load_streams(domain + "domain.pddl", root + "/problems/tamp/line/" + problem + ".pddl",
                        domain + "streams.pddl");
}

/// Values of `tight` and `blocked`.
inline std::map<std::string, Value, std::less<>> tight_values() {
    return {{"ground", Value::of(Interval{-10, 0})},
            {"red", Value::of(Interval{5, 7.5})},
            {"pa", Value::of(-2.0)},
            {"pb", Value::of(-4.0)},
            {"home", Value::of(0.0)}};
}
inline std::map<std::string, Value, std::less<>> blocked_values() {
    return {{"ground", Value::of(Interval{-10, 0})},
            {"red", Value::of(Interval{5, 6.5})},
            {"pa", Value::of(-2.0)},
            {"pb", Value::of(5.75)},
            {"home", Value::of(0.0)}};
}

}  // namespace praxis::tamp::test
