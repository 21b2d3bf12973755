#include <algorithm>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/command_line.hpp"
#include "app/command_line_parts.hpp"
#include "practice/competence/competence_model.hpp"
#include "practice/environments/environments.hpp"
#include "practice/methods/method.hpp"
#include "practice/policies/classifier.hpp"
#include "search/engines/syntax.hpp"

namespace praxis::app {
namespace {

using namespace praxis::practice;

constexpr const char* kUsage =
    "\nUsage:\n"
    "  plan practice ENVIRONMENT... [options]   practise, test, and say how much practice it took\n"
    "  plan practice --list                     environments, methods and models to choose from";
constexpr const char* kFooter =
    "A robot practises its skills in a simulated environment; a method decides which skill when. A run is\n"
    "one method in one environment with one seed: cycles of a task, free time and learning, with tests in\n"
    "between. The table on standard output has means over the seeds with 95 % intervals. Environments may\n"
    "have options: 'ball-ring(features=relative)'. The first method is compared with the best of the "
    "others.\n"
    "\nCtrl-C and the time limit end it in order: finished runs are reported, and kept in the directory of\n"
    "the results, from which the same command goes on.\n"
    "\nExit codes: 0 all runs are finished; 22 memory limit; 23 time limit; 31 wrong input; 35 output could\n"
    "  not be written; 128 + N ended by signal N\n"
    "\nExamples:\n"
    "  plan practice ball-ring\n"
    "  plan practice 'ball-ring(features=relative)' light-switch --methods ees,fail-focus --seeds 30 \\\n"
    "      --results results --svg curves.svg --report report.html\n"
    "  plan practice kitchen --methods all --cycles 20 --csv curves.csv --time-limit 600\n"
    "  plan practice playroom --no-reset --competence optimistic --classifier ensemble";

using Check = std::function<std::string(const std::string&)>;

template <class Parts>
std::vector<std::string> names_of(const Parts& parts) {
    std::vector<std::string> names;
    for (const auto& part : parts) names.push_back(part.name);
    return names;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// Says what there is and what may have been meant.
std::string check_name(const std::string& kind, const std::vector<std::string>& names,
                       const std::string& text) {
    if (std::find(names.begin(), names.end(), text) != names.end()) return {};
    const std::string closest = closest_name(text, names);
    return "there is no " + kind + " '" + text + "'; there are: " + joined(names) +
           (closest.empty() ? "" : "; did you mean '" + closest + "'?");
}

Check one_of(std::string kind, std::vector<std::string> names) {
    return [kind = std::move(kind), names = std::move(names)](const std::string& text) {
        return check_name(kind, names, text);
    };
}

Check number_between(double low, double high) {
    return [low, high](const std::string& text) -> std::string {
        char* end = nullptr;
        const double number = std::strtod(text.c_str(), &end);
        if (end != text.c_str() && *end == '\0' && number >= low && number <= high) return {};
        std::ostringstream message;
        message << "'" << text << "' is not a number from " << low << " to " << high;
        return message.str();
    };
}

Check integer_between(int low, int high) {
    return [low, high](const std::string& text) -> std::string {
        if (non_negative_integer(text).empty() && text.size() < 10) {
            const int number = std::atoi(text.c_str());
            if (number >= low && number <= high) return {};
        }
        return "'" + text + "' is not an integer from " + std::to_string(low) + " to " + std::to_string(high);
    };
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == ',')
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

std::vector<std::string> method_list(const std::string& text) {
    return text == "all" ? names_of(methods()) : split(text);
}

std::string check_methods(const std::string& text) {
    for (const std::string& name : method_list(text))
        if (std::string wrong = check_name("method", names_of(methods()), name); !wrong.empty()) return wrong;
    return {};
}

std::string check_prior(const std::string& text) {
    const std::vector<std::string> parts = split(text);
    if (parts.size() == 2 && positive_number(parts[0]).empty() && positive_number(parts[1]).empty())
        return {};
    return "'" + text + "' is not a prior: two positive numbers with a comma between, such as 10,1";
}

/// A function that adds options of a group to the help page.
auto adder(CLI::App& app, const char* group) {
    return [&app, group](const char* name, auto& value, const char* type, const std::string& help,
                         const Check& check) {
        return app.add_option(name, value, help)->type_name(type)->check(check)->group(group);
    };
}

void add_experiment_options(CLI::App& app, ExperimentOptions& options) {
    constexpr int kMost = 1'000'000;
    PracticeOptions& practice = options.practice;
    const auto add = adder(app, "The experiment");
    add("--seeds", options.seeds, "N", "Runs of each method (default: 10)", integer_between(1, 100'000));
    add("--seed", options.first_seed, "N", "Seed of the first run; the next ones follow (default: 0)",
        non_negative_integer);
    add("--cycles", practice.cycles, "N", "Cycles of practice a run (default: 10)",
        integer_between(0, kMost));
    add("--cycle-steps", practice.cycle_steps, "N",
        "Skills a cycle, 0: what the environment says (default: 0)", integer_between(0, kMost));
    add("--learn-every", practice.learn_every, "N",
        "Learn after N skills, 0: at the end of a cycle (default: 25)", integer_between(0, kMost));
    add("--test-every", practice.test_every, "N",
        "Test after N skills, too; 0: at the end of a cycle only (default: 0)", integer_between(0, kMost));
    add("--test-tasks", practice.test_tasks, "N", "Tasks a test (default: 100)", integer_between(1, kMost));
    app.add_flag_callback(
           "--no-reset", [&practice] { practice.reset = false; },
           "Only the first task brings a state of its own")
        ->group("The experiment");
    add("--threads", options.threads, "N", "Runs at a time (default: the processor's cores)",
        integer_between(1, 1024));
    app.add_option("--results", options.results, "Keep finished runs in DIR, and go on from there")
        ->type_name("DIR")
        ->group("The experiment");
}

void add_learning_options(CLI::App& app, PracticeOptions& options) {
    const auto add = adder(app, "Practice and learning");
    add("--candidates", options.candidates, "KIND",
        "Skills to practise: those tried, or all (default: tried)",
        one_of("kind of candidates", {"tried", "all"}));
    add("--score-every", options.score_every, "N",
        "Attempts at a skill before scores are made anew (default: 5)", integer_between(1, 1'000'000));
    add("--bonus", options.bonus, "W", "Weight of the upper-confidence bonus (default: 0.1)",
        number_between(0, 1e6));
    add("--competence", options.competence.model, "NAME",
        "Model of competence: " + joined(names_of(competence_models())) + " (default: latent)",
        one_of("competence model", names_of(competence_models())));
    app.add_flag("--sharing", options.sharing, "Untried skills start from others of their schema")
        ->group("Practice and learning");
    add("--classifier", options.policy.classifier.kind, "NAME",
        "What scores parameters: " + joined(names_of(classifiers())) + " (default: mlp)",
        one_of("classifier", names_of(classifiers())));
    add("--features", options.policy.features, "KIND",
        "What it sees: all, relevant, selected (default: relevant)",
        one_of("kind of features", {"all", "relevant", "selected"}));
    add("--exploration", options.policy.exploration, "KIND",
        "Of parameters: epsilon-greedy, uncertain (default: epsilon-greedy)",
        one_of("exploration", {"epsilon-greedy", "uncertain"}));
    add("--epsilon", options.policy.epsilon, "P", "How often parameters are explored (default: 0.5)",
        number_between(0, 1));
}

void add_output_options(CLI::App& app, PracticeCommandOptions& options) {
    const auto add = [&](const char* name, std::string& file, const char* help) {
        app.add_option(name, file, help)->type_name("FILE")->group("What is written");
    };
    adder(app, "What is written")("--threshold", options.threshold, "P",
                                  "Count practice to this share of tasks (default: 0.8)",
                                  number_between(0, 1));
    add("--csv", options.csv, "Write every test of every run as comma-separated values");
    add("--summary", options.summary, "Write the mean curves with their intervals in the same way");
    add("--svg", options.svg, "Draw the curves; several environments: a file each, named after it");
    add("--report", options.report, "Write a page: curves, figures, and why each skill was chosen");
}

int outputs_to_standard_output(const PracticeCommandOptions& options) {
    int count = 0;
    for (const std::string* file :
         {&options.json, &options.csv, &options.summary, &options.svg, &options.report})
        count += *file == "-";
    return count;
}

}  // namespace

Request parse_practice_command(std::vector<std::string> arguments) {
    constexpr const char* kHint = "plan practice";
    PracticeCommandOptions options;
    ExperimentOptions& experiment = options.experiment;
    experiment.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    CLI::App app("plan practice: which skill should a robot practise, so that its plans succeed?");
    set_usage(app, kUsage, kFooter);
    std::string chosen = "ees", prior;
    app.add_option("ENVIRONMENTS", experiment.environments)->group("");
    app.add_flag("--list", options.list, "Say what there is to choose from");
    app.add_option("--methods", chosen, "Methods with commas between, or all (default: ees)")
        ->type_name("NAMES")
        ->check(check_methods);
    add_common_options(app, options);
    add_experiment_options(app, experiment);
    add_learning_options(app, experiment.practice);
    app.add_option("--prior", prior, "Beta distribution of competence beforehand (default: 10,1)")
        ->type_name("A,B")
        ->check(check_prior)
        ->group("Practice and learning");
    add_output_options(app, options);
    if (auto done = parse(app, std::move(arguments), kHint)) return *done;

    if (experiment.environments.empty() && !options.list)
        return usage_error("an environment is needed: plan practice ENVIRONMENT...; there are: " +
                               joined(environment_names()),
                           kHint);
    experiment.methods = method_list(chosen);
    if (!prior.empty()) {
        const std::vector<std::string> numbers = split(prior);
        experiment.practice.competence.prior = {std::strtod(numbers[0].c_str(), nullptr),
                                                std::strtod(numbers[1].c_str(), nullptr)};
    }
    if (options.svg == "-" && experiment.environments.size() > 1)
        return usage_error("several environments are drawn in several files; --svg needs a name", kHint);
    if (outputs_to_standard_output(options) > 1)
        return usage_error("only one result can go to standard output ('-')", kHint);
    return options;
}

}  // namespace praxis::app
