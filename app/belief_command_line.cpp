#include <cstdlib>
#include <map>
#include <utility>

#include "app/command_line.hpp"
#include "app/command_line_parts.hpp"
#include "belief/policies/policy.hpp"

namespace praxis::app {
namespace {

constexpr const char* kUsage =
    "\nUsage:\n"
    "  plan belief DOMAIN PROBLEM [options]             act in simulated worlds\n"
    "  plan belief DOMAIN PROBLEM --offline [options]   decide everything beforehand: a conditional plan\n"
    "  plan belief PROBLEM [options]                    the domain file is found beside the problem";
constexpr const char* kFooter =
    "Acts in a simulated world: plans with what is known, executes, reads, and plans again where things are\n"
    "not as hoped, once for each hidden world. One run is told step by step, several as a table. With\n"
    "--offline nothing is executed: the plan says what to do after every answer. Readings are weighed by\n"
    "the policy plan only; the others believe them, but for those that contradict what is known.\n"
    "\nExit codes: 0 every run reached the goal (or there is a conditional plan); 11 it is proved that "
    "the\n"
    "  goal is out of reach in every world (that there is no conditional plan); 12 not every run reached it\n"
    "  (no conditional plan was found); 22 memory limit; 23 time limit; 31 wrong input; 34 unsupported "
    "input;\n"
    "  35 output could not be written\n"
    "\nExamples (from the folder of the sources):\n"
    "  plan belief domains/belief/doors/domain.pddl problems/belief/doors/two-walls.pddl --view run.html\n"
    "  plan belief domains/belief/doors/domain.pddl problems/belief/doors/two-walls.pddl --offline --html "
    "p.html\n"
    "  plan belief domains/belief/sort-weight/domain.pddl problems/belief/sort-weight/two-boxes.pddl \\\n"
    "      --seeds 200 --optimum --json report.json\n"
    "  plan belief domains/belief/sort-weight/domain.pddl problems/belief/sort-weight/two-boxes.pddl \\\n"
    "      --seeds 200 --noise 0.1 --accept 0.99";

std::string policy_names() {
    std::string names;
    for (const belief::PolicyKind& kind : belief::policy_kinds())
        names += (names.empty() ? "" : ", ") + std::string(kind.name);
    return names;
}

std::string policy_name(const std::string& text) {
    for (const belief::PolicyKind& kind : belief::policy_kinds())
        if (text == kind.name) return {};
    return "there is no policy '" + text + "'; there are: " + policy_names();
}

/// A probability from which on something can be believed.
std::string belief_threshold(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (end != text.c_str() && *end == '\0' && number > 0.5 && number < 1) return {};
    return "'" + text + "' is not a probability above 0.5 and below 1";
}

/// Options about acting; a conditional plan has no use for them.
std::vector<CLI::Option*> add_acting_options(CLI::App& app, BeliefOptions& options) {
    std::vector<CLI::Option*> all;
    const auto add = [&](CLI::Option* option) {
        all.push_back(option);
        return option;
    };
    add(app.add_option("-w,--world", options.worlds, "A file with hidden worlds; may be given several times")
            ->type_name("FILE"));
    auto* runs = add(app.add_option("--runs", options.runs, "Only N of the hidden worlds, evenly spread")
                         ->type_name("N")
                         ->check(non_negative_integer));
    add(app.add_option("--seeds", options.samples, "N worlds drawn from the initial uncertainty")
            ->type_name("N")
            ->check(non_negative_integer)
            ->excludes(runs));
    add(app.add_option("--noise", options.noise, "Probability that a reading is wrong (default: 0)")
            ->type_name("P")
            ->check(CLI::Range(0.0, 0.499).description("")));
    add(app.add_option("--failures", options.failures,
                       "Probability that an action fails; in half of these cases it happens all the same "
                       "(default: 0)")
            ->type_name("P")
            ->check(CLI::Range(0.0, 1.0).description("")));
    add(app.add_option("--observer", options.observer,
                       "Read with a vision-language model that looks at pictures of the world, as FILE "
                       "(JSON) says")
            ->type_name("FILE"));
    add(app.add_option("--max-steps", options.max_steps, "Most actions of one run (default: 1000)")
            ->type_name("N")
            ->check(non_negative_integer));
    add(app.add_option("--policy", options.policy,
                       "Who chooses the actions: " + policy_names() + " (default: plan)")
            ->type_name("NAME")
            ->check(policy_name));
    add(app.add_option("--plan-time", options.plan_time, "Most seconds for one plan (default: 10)")
            ->type_name("S")
            ->check(positive_number));
    add(app.add_option("--risk", options.risk,
                       "What unlikely outcomes cost in plans: this many actions times -log p (default: 0)")
            ->type_name("W")
            ->check(CLI::Range(0.0, 1000.0).description("")));
    add(app.add_flag(
        "--optimum", options.optimum,
        "Compare with the best policy for readings that are right (SPL), where it can be computed"));
    add(app.add_option("--trace", options.trace,
                       "Write every event as a line of JSON; '-': to standard output")
            ->type_name("FILE"));
    add(app.add_option("--view", options.view, "Write one run as a page: each step with what is known then")
            ->type_name("FILE"));
    return all;
}

}  // namespace

Request parse_belief_command(std::vector<std::string> arguments) {
    constexpr const char* kHint = "plan belief";
    BeliefOptions options;
    CLI::App app("plan belief: plans and acts when not everything is known");
    set_usage(app, kUsage, kFooter);
    std::vector<std::string> files;
    app.add_option("FILES", files)->group("");
    std::vector<CLI::Option*> acting = add_acting_options(app, options);
    const std::map<std::string, BeliefOptions::Mode> modes = {{"exact", BeliefOptions::Mode::exact},
                                                              {"sticky", BeliefOptions::Mode::sticky},
                                                              {"bayes", BeliefOptions::Mode::bayes}};
    std::string mode;
    acting.push_back(
        app.add_option("--belief", mode,
                       "exact: believe readings; sticky: but pass over contradicting ones; bayes: weigh them "
                       "(default: exact; with --noise bayes)")
            ->type_name("MODE")
            ->check([&](const std::string& text) -> std::string {
                if (modes.contains(text)) return {};
                return "there is no belief '" + text + "'; there are: exact, sticky, bayes";
            }));
    auto* accept = app.add_option("--accept", options.accept,
                                  "Believe what has at least this probability; implies --belief bayes "
                                  "(default: 0.995)")
                       ->type_name("P")
                       ->check(belief_threshold);
    acting.push_back(accept);
    auto* offline = app.add_flag("--offline", options.offline, "Make a conditional plan instead of acting");
    for (CLI::Option* option : acting) offline->excludes(option);
    app.add_option("--dot", options.dot, "Write the conditional plan for Graphviz; '-': to standard output")
        ->type_name("FILE")
        ->needs(offline);
    app.add_option("--html", options.html, "Write the conditional plan as a page; '-': to standard output")
        ->type_name("FILE")
        ->needs(offline);
    app.add_option("-s,--search", options.search, "The search for each plan; see 'plan list'")
        ->type_name("EXPR");
    app.add_option("--seed", options.seed, "Seed of whatever is random (default: 0)")
        ->type_name("N")
        ->check(non_negative_integer);
    add_common_options(app, options);
    if (auto done = parse(app, std::move(arguments), kHint)) return *done;

    if (files.empty() || files.size() > 2)
        return usage_error("two files are needed: plan belief DOMAIN PROBLEM", kHint);
    if (files.size() == 2) options.domain = files[0];
    options.problem = files.back();
    if (options.domain == "-" && options.problem == "-")
        return usage_error("only one file can be read from standard input", kHint);
    if (!mode.empty()) options.mode = modes.at(mode);
    if (accept->count() > 0) {
        if (options.mode == BeliefOptions::Mode::automatic) options.mode = BeliefOptions::Mode::bayes;
        if (options.mode != BeliefOptions::Mode::bayes)
            return usage_error("--accept is for --belief bayes, not for --belief " + mode, kHint);
    }
    if (options.runs == 0U || options.samples == 0U)
        return usage_error(std::string(options.runs ? "--runs" : "--seeds") + " needs at least 1", kHint);
    int outputs = 0;
    for (const std::string* file :
         {&options.json, &options.trace, &options.view, &options.dot, &options.html})
        outputs += *file == "-";
    if (outputs > 1) return usage_error("only one result can go to standard output ('-')", kHint);
    return options;
}

}  // namespace praxis::app
