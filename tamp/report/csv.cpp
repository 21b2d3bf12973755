#include "tamp/report/csv.hpp"

#include <cmath>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string_view>

#include "tamp/report/replay.hpp"
#include "tamp/text/number_text.hpp"

namespace praxis::tamp {

namespace {

using Document = TrajectoryDocument;

constexpr double kMostRows = 1e7;

std::string quoted(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + '"';
}

void append(std::string& texts, const std::string& text) {
    texts += (texts.empty() ? "" : "; ") + text;
}

std::string action_text(const Document::Action& action) {
    std::string text = "(" + action.name;
    for (const std::string& argument : action.arguments) text += " " + argument;
    return text + ")";
}

/// What happens, by time.
std::map<double, std::string> events(const Document& document) {
    std::map<double, std::string> result;
    for (const Document::Segment& segment : document.segments) {
        if (segment.attach) append(result[segment.end], "attach " + segment.attach->body);
        if (segment.detach) append(result[segment.end], "detach " + segment.detach->body);
    }
    for (const Document::Action& action : document.plan) append(result[action.start], action_text(action));
    return result;
}

}  // namespace

void write_csv(const TrajectoryDocument& document, double rate, std::ostream& out) {
    if (!(rate > 0) || !std::isfinite(rate)) throw std::invalid_argument("the rate must be a number > 0");
    const Replay replay(document);
    const double duration = document.duration();
    if (!(duration * rate < kMostRows))
        throw std::invalid_argument("more than 10 million rows: the rate must be lower");
    std::map<double, std::string> rows = events(document);
    for (std::size_t k = 0; static_cast<double>(k) / rate <= duration; ++k)
        rows[static_cast<double>(k) / rate];
    rows[duration];
    out << "t";
    for (const std::string& name : document.robot.variables) out << ',' << quoted(name);
    out << ",gripper,event\n";
    for (const auto& [time, event] : rows) {
        out << shortest(time);
        for (const double position : replay.motion_at(time).positions) out << ',' << shortest(position);
        std::string held;
        for (const std::string& body : replay.held_at(time)) append(held, body);
        out << ',' << quoted(held) << ',' << quoted(event) << '\n';
    }
}

}  // namespace praxis::tamp
