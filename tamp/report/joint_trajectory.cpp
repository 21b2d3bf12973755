#include "tamp/report/joint_trajectory.hpp"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>

#include "tamp/report/replay.hpp"
#include "tamp/text/number_text.hpp"

namespace praxis::tamp {

namespace {

using Document = TrajectoryDocument;

/// A text of JSON in double quotes is one of YAML, too.
std::string quoted(const std::string& text) {
    return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

void write_numbers(const char* name, const Configuration& numbers, std::ostream& out) {
    out << name << ": [";
    for (std::size_t i = 0; i < numbers.size(); ++i) out << (i == 0 ? "" : ", ") << yaml_float(numbers[i]);
    out << "]\n";
}

std::int64_t nanoseconds(double time) {
    return std::llround(time * 1e9);
}

void write_point(const Trajectory::Knot& knot, std::ostream& out) {
    constexpr std::int64_t kSecond = 1'000'000'000;
    const std::int64_t time = nanoseconds(knot.time);
    write_numbers("  - positions", knot.positions, out);
    write_numbers("    velocities", knot.velocities, out);
    write_numbers("    accelerations", knot.accelerations, out);
    out << "    time_from_start: {sec: " << time / kSecond << ", nanosec: " << time % kSecond << "}\n";
}

/// `knots` have times from the start.
void write_document(const std::vector<std::string>& names, const std::vector<Trajectory::Knot>& knots,
                    std::ostream& out) {
    out << "---\nheader: {stamp: {sec: 0, nanosec: 0}, frame_id: world}\njoint_names: [";
    for (std::size_t i = 0; i < names.size(); ++i) out << (i == 0 ? "" : ", ") << quoted(names[i]);
    out << (knots.empty() ? "]\npoints: []\n" : "]\npoints:\n");
    for (std::size_t i = 0; i < knots.size(); ++i) {
        const bool last = i + 1 == knots.size();
        if (last || nanoseconds(knots[i].time) != nanoseconds(knots[i + 1].time)) write_point(knots[i], out);
    }
}

void write_segments(const Document& document, std::ostream& out) {
    for (const Document::Segment& segment : document.segments) {
        if (segment.knots.empty() || segment.variables.empty()) continue;
        std::vector<std::string> names;
        for (const int variable : segment.variables)
            names.push_back(document.robot.variables[static_cast<std::size_t>(variable)]);
        std::vector<Trajectory::Knot> knots = segment.knots;
        for (Trajectory::Knot& knot : knots) knot.time -= segment.start;
        write_document(names, knots, out);
    }
}

void write_whole(const Document& document, std::ostream& out) {
    const Replay replay(document);
    std::set<double> times = {0, document.duration()};
    for (const Document::Segment& segment : document.segments)
        for (const Trajectory::Knot& knot : segment.knots) times.insert(knot.time);
    std::vector<Trajectory::Knot> knots;
    for (const double time : times) {
        RobotMotion motion = replay.motion_at(time);
        knots.push_back({time, std::move(motion.positions), std::move(motion.velocities),
                         std::move(motion.accelerations)});
    }
    write_document(document.robot.variables, knots, out);
}

}  // namespace

void write_joint_trajectory(const TrajectoryDocument& document, JointTrajectoryForm form, std::ostream& out) {
    check_document(document);
    if (form == JointTrajectoryForm::segments) {
        write_segments(document, out);
    } else {
        write_whole(document, out);
    }
}

}  // namespace praxis::tamp
