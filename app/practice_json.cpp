#include "app/practice_json.hpp"

#include <nlohmann/json.hpp>

namespace praxis::app {
namespace {

using namespace praxis::practice;
using Json = nlohmann::ordered_json;

Json to_value(const IntervalEstimate& estimate) {
    return {{"mean", estimate.value}, {"low", estimate.low}, {"high", estimate.high}};
}

Json to_value(const MethodResult& method) {
    Json reached = to_value(method.reached.mean);
    reached["median"] = method.reached.median;
    reached["censored"] = method.reached.censored;
    Json value{{"method", method.method},
               {"runs", method.solved.count},
               {"solved", to_value(method.solved)},
               {"transitions", std::move(reached)},
               {"processor_seconds", to_value(method.processor_seconds)},
               {"evaluation_seconds", to_value(method.evaluation_seconds)}};
    if (!method.against) return value;
    const PracticeRatio& ratio = method.against->practice;
    value["practice_ratio"] =
        Json{{"value", ratio.value}, {"low", ratio.low}, {"high", ratio.high}, {"bound", bound_of(ratio)}};
    return value;
}

}  // namespace

std::string practice_json(std::span<const EnvironmentResult> results, const ThresholdOptions& threshold,
                          std::size_t runs) {
    Json value{{"threshold", threshold.solved}, {"runs", runs}, {"finished", 0}};
    std::size_t finished = 0;
    Json environments = Json::array();
    for (const EnvironmentResult& result : results) {
        Json methods = Json::array();
        for (const MethodResult& method : result.methods) {
            methods.push_back(to_value(method));
            finished += method.solved.count;
        }
        environments.push_back(Json{{"environment", result.environment},
                                    {"reference", result.reference},
                                    {"methods", std::move(methods)}});
    }
    value["finished"] = finished;
    value["environments"] = std::move(environments);
    return value.dump();
}

}  // namespace praxis::app
