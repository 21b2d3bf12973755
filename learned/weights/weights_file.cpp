#include "learned/weights/weights_file.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "learned/maps/map_problem.hpp"
#include "learned/weights/planner_json.hpp"
#include "parser/diagnostic.hpp"

namespace praxis::learned {
namespace {

constexpr const char* kParameters = "parameters";
constexpr const char* kPolicy = "self-test";
constexpr double kTolerance = 1e-4;  // relative to the largest logit: instruction sets round differently

MapProblem built_in_map() {
    constexpr std::string_view kCells =
        "#######"
        "#...#.#"
        "#.#.#.#"
        "#.#...#"
        "#.###.#"
        "#.....#"
        "#######";
    MapProblem problem;
    problem.height = problem.width = 7;
    for (const char cell : kCells) problem.free.push_back(cell == '.');
    problem.goal = 12;
    return problem;
}

std::vector<float> policy_on_built_in_map(const Planner<float>& planner) {
    const MapProblem problem = built_in_map();
    const auto trace = planner.trace(problem.height, problem.width);
    draw(problem, *trace);
    planner.plan(*trace);
    std::vector<float> result;
    for (int move = 0; move < trace->policy.channels(); ++move)
        for (int row = 0; row < problem.height; ++row)
            for (int column = 0; column < problem.width; ++column)
                result.push_back(trace->policy.at(move, row, column));
    return result;
}

[[noreturn]] void fail(const std::string& file, const std::string& what) {
    throw InputError(file + ": error: " + what + "\n");
}

void test(const Planner<float>& planner, const std::vector<float>& expected, const std::string& file) {
    const std::vector<float> found = policy_on_built_in_map(planner);
    if (found.size() != expected.size()) fail(file, "the self-test of these weights has another size");
    float scale = 0, largest = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        scale = std::max(scale, std::abs(expected[i]));
        largest = std::max(largest, std::abs(found[i] - expected[i]));
        if (!std::isfinite(found[i]) || !std::isfinite(expected[i]))
            fail(file, "the self-test of these weights is not finite");
    }
    if (static_cast<double>(largest) > kTolerance * static_cast<double>(scale))
        fail(file,
             "the self-test of these weights fails: the policy on the built-in map is another than when they "
             "were written");
}

}  // namespace

ArrayFile planner_contents(const Planner<float>& planner, const nlohmann::json& origin) {
    ArrayFile contents;
    contents.header["planner"] = to_json(planner.options());
    contents.header["origin"] = origin;
    contents.header["blocks"] = nlohmann::json::array();
    for (const ParameterBlock& block : planner.layout().blocks())
        contents.header["blocks"].push_back(nlohmann::json::array({block.name, block.size}));
    contents.arrays.emplace_back(
        kParameters, std::vector<float>(planner.parameters().begin(), planner.parameters().end()));
    contents.arrays.emplace_back(kPolicy, policy_on_built_in_map(planner));
    return contents;
}

void write_planner(const std::string& file, const Planner<float>& planner, const nlohmann::json& origin) {
    write_array_file(file, planner_contents(planner, origin));
}

ReadPlanner parse_planner(const ArrayFile& contents, const std::string& file) {
    const std::vector<float>& parameters = contents.array(kParameters, file);
    const auto options = contents.header.find("planner");
    if (options == contents.header.end()) fail(file, "the header says nothing about a planner");
    ReadPlanner result;
    try {
        const PlannerOptions wanted = planner_options(*options);
        const std::size_t count = parameter_count(wanted);
        if (count != parameters.size())
            fail(file, "there are " + std::to_string(parameters.size()) +
                           " weights, but the planner that the header describes has " +
                           std::to_string(count));
        result.planner = make_planner<float>(wanted, 0);
    } catch (const std::invalid_argument& error) {
        fail(file, error.what());
    }
    if (!std::ranges::all_of(parameters, [](float weight) { return std::isfinite(weight); }))
        fail(file, "a weight is not finite");
    std::ranges::copy(parameters, result.planner->parameters().begin());
    result.planner->update();
    test(*result.planner, contents.array(kPolicy, file), file);
    result.origin = contents.header.value("origin", nlohmann::json());
    return result;
}

ReadPlanner read_planner(const std::string& file) {
    return parse_planner(read_array_file(file), file);
}

}  // namespace praxis::learned
