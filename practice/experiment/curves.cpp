#include "practice/experiment/curves.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "practice/experiment/groups.hpp"

namespace praxis::practice {
namespace {

[[noreturn]] void refuse(const Curve& curve, const std::string& what) {
    throw std::invalid_argument("the run of '" + curve.method + "' in '" + curve.environment +
                                "' with seed " + std::to_string(curve.seed) + " " + what);
}

void check_curve(const Curve& curve) {
    if (curve.points.empty()) refuse(curve, "has no evaluation");
    const CurvePoint* before = nullptr;
    for (const CurvePoint& point : curve.points) {
        if (point.cycle < 0 || (before && point.cycle < before->cycle)) refuse(curve, "has cycles that fall");
        if (point.transitions < 0 || (before && point.transitions < before->transitions))
            refuse(curve, "has transitions that fall");
        if (!(point.solved >= 0 && point.solved <= 1)) refuse(curve, "has fractions outside of 0 to 1");
        before = &point;
    }
}

void append_transitions(const Curve& curve, std::vector<std::int64_t>& all) {
    for (const CurvePoint& point : curve.points) all.push_back(point.transitions);
}

std::vector<std::int64_t> grid_of(std::vector<std::int64_t> all, std::size_t most) {
    if (most < 2) throw std::invalid_argument("a grid has at least two points");
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    if (all.size() <= most) return all;
    const std::int64_t first = all.front(), last = all.back();
    const auto steps = static_cast<std::int64_t>(most - 1);
    const std::int64_t whole = (last - first) / steps, rest = (last - first) % steps;
    all.clear();
    for (std::int64_t i = 0; i <= steps; ++i) all.push_back(first + whole * i + rest * i / steps);
    return all;
}

/// The points of a grid between the first and the last evaluation of a method, and these two.
std::vector<std::int64_t> part_of_grid(const std::vector<std::int64_t>& grid,
                                       const std::vector<std::int64_t>& of_method) {
    const auto [first, last] = std::minmax_element(of_method.begin(), of_method.end());
    std::vector<std::int64_t> result{*first};
    for (const std::int64_t transitions : grid)
        if (transitions > *first && transitions < *last) result.push_back(transitions);
    if (*last > *first) result.push_back(*last);
    return result;
}

}  // namespace

std::vector<Curve> curves_of(std::span<const RunResult> runs) {
    std::vector<Curve> result;
    result.reserve(runs.size());
    for (const RunResult& run : runs) result.push_back({run.environment, run.method, run.seed, run.curve});
    return result;
}

void check_curves(std::span<const Curve> curves) {
    std::set<std::tuple<std::string, std::string, std::uint64_t>> seen;
    for (const Curve& curve : curves) {
        check_curve(curve);
        if (!seen.emplace(curve.environment, curve.method, curve.seed).second)
            refuse(curve, "is there twice");
    }
}

double solved_at(std::span<const CurvePoint> points, std::int64_t transitions) {
    if (points.empty()) throw std::invalid_argument("a learning curve without points");
    const auto after = std::upper_bound(
        points.begin(), points.end(), transitions,
        [](std::int64_t value, const CurvePoint& point) { return value < point.transitions; });
    return after == points.begin() ? points.front().solved : std::prev(after)->solved;
}

std::vector<std::int64_t> common_grid(std::span<const Curve> curves, std::size_t most) {
    std::vector<std::int64_t> all;
    for (const Curve& curve : curves) append_transitions(curve, all);
    return grid_of(std::move(all), most);
}

std::vector<CurveSummary> summarise(std::span<const Curve> curves, double confidence, std::size_t most) {
    check_curves(curves);
    std::vector<CurveSummary> result;
    std::vector<std::int64_t> transitions;
    std::vector<double> fractions;
    for (const EnvironmentGroup& environment : group_runs(curves)) {
        transitions.clear();
        for (const MethodGroup& method : environment.methods)
            for (const std::size_t run : method.runs) append_transitions(curves[run], transitions);
        const std::vector<std::int64_t> grid = grid_of(transitions, most);
        for (const MethodGroup& method : environment.methods) {
            transitions.clear();
            for (const std::size_t run : method.runs) append_transitions(curves[run], transitions);
            CurveSummary& summary = result.emplace_back();
            summary.environment = environment.environment;
            summary.method = method.method;
            for (const std::int64_t at : part_of_grid(grid, transitions)) {
                fractions.clear();
                for (const std::size_t run : method.runs)
                    fractions.push_back(solved_at(curves[run].points, at));
                summary.points.push_back({at, fraction_estimate(fractions, confidence)});
            }
        }
    }
    return result;
}

}  // namespace praxis::practice
