#include <cctype>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "app/exit_code.hpp"
#include "app/practice_json.hpp"
#include "app/practice_table.hpp"
#include "app/run.hpp"
#include "practice/competence/competence_model.hpp"
#include "practice/environments/environments.hpp"
#include "practice/experiment/chart.hpp"
#include "practice/experiment/curve_files.hpp"
#include "practice/experiment/experiment.hpp"
#include "practice/experiment/number_text.hpp"
#include "practice/experiment/report_page.hpp"
#include "practice/methods/method.hpp"
#include "practice/policies/classifier.hpp"
#include "search/text/output.hpp"

namespace praxis::app {
namespace {

using namespace praxis::practice;

template <class Part>
std::string parts_text(const char* title, const std::vector<Part>& parts) {
    std::string text = title;
    for (const Part& part : parts) text += "\n  " + part.name + "\n      " + part.description;
    return text + "\n";
}

std::string list_text() {
    return parts_text("Environments", environments()) + "\n" + parts_text("Methods", methods()) + "\n" +
           parts_text("Competence models", competence_models()) + "\n" +
           parts_text("Classifiers", classifiers());
}

/// "34 s", "12 min", "3.4 h".
std::string duration_text(double seconds) {
    if (seconds < 100) return fixed(std::ceil(seconds), 0) + " s";
    return seconds < 6000 ? fixed(seconds / 60, 0) + " min" : fixed(seconds / 3600, 1) + " h";
}

std::string share_text(const ExperimentProgress& progress) {
    std::string text = std::to_string(progress.finished) + " of " + std::to_string(progress.runs) + " runs";
    if (std::isfinite(progress.seconds_left))
        text += ", about " + duration_text(progress.seconds_left) + " left";
    return text;
}

std::string run_text(const RunResult& run) {
    return run.environment + ", " + run.method + ", seed " + std::to_string(run.seed) + ": " +
           fixed(100 * run.curve.back().solved, 1) + " % solved after " +
           grouped(static_cast<double>(run.curve.back().transitions)) + " transitions, " +
           seconds_text(run.processor_seconds) + " of practice";
}

/// The file of one of several environments: "curves.svg" becomes "curves-kitchen.svg".
std::string file_of(const std::string& file, const std::string& environment) {
    std::string part;
    for (const char c : environment) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            part += c;
        else if (!part.empty() && part.back() != '-')
            part += '-';
    }
    while (part.ends_with('-')) part.pop_back();
    const std::filesystem::path path = file;
    return (path.parent_path() / (path.stem().string() + "-" + part + path.extension().string())).string();
}

/// What is written of the runs that are finished.
class Conclusion {
  public:
    Conclusion(const Experiment& experiment, const PracticeCommandOptions& options)
        : experiment_(experiment), options_(options) {
        comparison_.threshold.solved = options.threshold;
        comparison_.evaluation_tasks = options.experiment.practice.test_tasks;
    }

    /// Writes the files, fills the report; the text for standard output.
    std::string operator()(Report& report) const {
        const std::vector<RunResult> runs = experiment_.results();
        const std::vector<EnvironmentResult> results = compare_methods(runs, comparison_);
        report.practice = practice_json(results, comparison_.threshold, experiment_.size());
        if (!runs.empty()) write_files(runs, results);
        for (const std::string* file : {&options_.csv, &options_.summary, &options_.svg, &options_.report})
            if (*file == "-") return {};
        return practice_table(results, comparison_.threshold, experiment_.size());
    }

  private:
    void write_files(const std::vector<RunResult>& runs,
                     const std::vector<EnvironmentResult>& results) const {
        const std::vector<Curve> curves = curves_of(runs);
        if (!options_.csv.empty()) write_file(options_.csv, curves_to_csv(curves));
        if (!options_.summary.empty()) write_file(options_.summary, summaries_to_csv(summarise(curves)));
        if (!options_.svg.empty()) write_charts(curves, results);
        if (!options_.report.empty()) write_file(options_.report, page(runs));
    }

    void write_charts(const std::vector<Curve>& curves, const std::vector<EnvironmentResult>& results) const {
        const std::vector<CurveSummary> summaries = summarise(curves);
        const bool several = options_.experiment.environments.size() > 1;
        for (const EnvironmentResult& result : results)
            write_file(several ? file_of(options_.svg, result.environment) : options_.svg,
                       learning_chart(result.environment, summaries, options_.threshold));
    }

    std::string page(const std::vector<RunResult>& runs) const {
        const PracticeOptions& practice = options_.experiment.practice;
        ReportOptions report;
        report.summary = std::to_string(runs.size()) + " of " + std::to_string(experiment_.size()) +
                         " runs; " + std::to_string(practice.cycles) + " cycles, " +
                         std::to_string(practice.test_tasks) + " tasks a test";
        report.comparison = comparison_;
        return report_page(runs, report);
    }

    const Experiment& experiment_;
    const PracticeCommandOptions& options_;
    ComparisonOptions comparison_;
};

Ending run_experiment(Run& run, Experiment& experiment) {
    run.set_phase("practising");
    const Stop stop = experiment.run(run.budget(), [&](const ExperimentProgress& progress) {
        run.set_share(progress.fraction, share_text(progress));
        if (progress.latest != nullptr && run.verbose()) run.say(run_text(*progress.latest));
    });
    return stop == Stop::none ? Ending{"practised", kSolved, ""} : run.stopped(stop);
}

}  // namespace

int run_practice_command(const PracticeCommandOptions& options) {
    Run run(options, "practice", "", "");
    std::unique_ptr<Experiment> experiment;
    return run.execute([&]() -> Ending {
        if (options.list) {
            run.set_result(list_text());
            return {"listed", kSolved, ""};
        }
        experiment = std::make_unique<Experiment>(options.experiment);
        run.at_end(Conclusion(*experiment, options));
        return run_experiment(run, *experiment);
    });
}

}  // namespace praxis::app
