#include "practice/experiment/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "practice/experiment/curves.hpp"
#include "practice/experiment/groups.hpp"

namespace praxis::practice {
namespace {

class Comparison {
  public:
    Comparison(std::span<const RunResult> runs, const ComparisonOptions& options)
        : runs_(runs), options_(options) {
        check_curves(curves_of(runs));
        if (options.evaluation_tasks < 0)
            throw std::invalid_argument("an evaluation has no negative number of tasks");
    }

    EnvironmentResult environment(const EnvironmentGroup& group) const {
        EnvironmentResult result;
        result.environment = group.environment;
        const MethodGroup* reference = reference_of(group);
        if (reference) result.reference = reference->method;
        for (const MethodGroup& method : group.methods) {
            result.methods.push_back(summary(method));
            if (reference && reference != &method)
                result.methods.back().against = against(method, *reference);
        }
        return result;
    }

  private:
    const MethodGroup* reference_of(const EnvironmentGroup& group) const {
        if (options_.reference.empty()) return group.methods.data();
        const auto found =
            std::find_if(group.methods.begin(), group.methods.end(),
                         [&](const MethodGroup& method) { return method.method == options_.reference; });
        return found == group.methods.end() ? nullptr : &*found;
    }

    template <class Figure>
    std::vector<double> figures(const MethodGroup& method, Figure figure) const {
        std::vector<double> result;
        for (const std::size_t run : method.runs) result.push_back(figure(runs_[run]));
        return result;
    }

    std::vector<Reached> reached(const MethodGroup& method) const {
        std::vector<Reached> result;
        for (const std::size_t run : method.runs)
            result.push_back(transitions_to(runs_[run].curve, options_.threshold));
        return result;
    }

    MethodResult summary(const MethodGroup& method) const {
        MethodResult result;
        result.method = method.method;
        const std::vector<double> solved =
            figures(method, [](const RunResult& run) { return run.curve.back().solved; });
        result.solved = fraction_estimate(solved, options_.confidence);
        if (const std::int64_t tasks = options_.evaluation_tasks; tasks > 0) {
            std::int64_t successes = 0;
            for (const double fraction : solved)
                successes += std::llround(fraction * static_cast<double>(tasks));
            result.pooled = proportion_estimate(successes, tasks * static_cast<std::int64_t>(solved.size()),
                                                options_.confidence);
        }
        result.reached = summarise_reached(reached(method), options_.confidence);
        result.processor_seconds = mean_estimate(
            figures(method, [](const RunResult& run) { return run.processor_seconds; }), options_.confidence);
        result.evaluation_seconds =
            mean_estimate(figures(method, [](const RunResult& run) { return run.evaluation_seconds; }),
                          options_.confidence);
        return result;
    }

    AgainstReference against(const MethodGroup& method, const MethodGroup& reference) const {
        std::map<std::uint64_t, double> of_reference;  // by seed
        for (const std::size_t run : reference.runs)
            of_reference[runs_[run].seed] = runs_[run].curve.back().solved;
        std::vector<double> here, there;
        for (const std::size_t run : method.runs) {
            const auto partner = of_reference.find(runs_[run].seed);
            if (partner == of_reference.end()) continue;
            here.push_back(runs_[run].curve.back().solved);
            there.push_back(partner->second);
        }
        AgainstReference result;
        if (!here.empty()) result.solved = compare_paired(here, there, options_.confidence);
        BootstrapOptions bootstrap;
        bootstrap.confidence = options_.confidence;
        result.practice = practice_ratio(reached(method), reached(reference), bootstrap);
        return result;
    }

    std::span<const RunResult> runs_;
    const ComparisonOptions& options_;
};

}  // namespace

std::vector<EnvironmentResult> compare_methods(std::span<const RunResult> runs,
                                               const ComparisonOptions& options) {
    const Comparison comparison(runs, options);
    std::vector<EnvironmentResult> result;
    for (const EnvironmentGroup& group : group_runs(runs)) result.push_back(comparison.environment(group));
    return result;
}

}  // namespace praxis::practice
