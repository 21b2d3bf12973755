#include "app/command_line.hpp"

#include <string_view>
#include <vector>

#include "app/command_line_parts.hpp"

namespace praxis::app {
namespace {

constexpr const char* kPlanUsage =
    "\nUsage:\n"
    "  plan DOMAIN PROBLEM [PLANFILE] [options]   find a plan\n"
    "  plan PROBLEM [options]                     the same, with the domain file found beside the problem\n"
    "  plan validate DOMAIN PROBLEM PLAN          check a plan, say which action fails and why\n"
    "  plan ground DOMAIN PROBLEM [--sas FILE]    show what the grounder makes of a task\n"
    "  plan belief DOMAIN PROBLEM                 plan and act when not everything is known\n"
    "  plan refine DOMAIN PROBLEM SCENE           plan for a robot, down to collision-free motion\n"
    "  plan practice ENVIRONMENT...               practise skills, and compare ways to choose which\n"
    "  plan list [evaluators|engines|aliases]     every component with its options\n"
    "\n'-' reads a file from standard input. 'plan COMMAND --help' tells more about a command.";

constexpr const char* kPlanFooter =
    "The plan goes to standard output, everything else to standard error.\n"
    "\nExit codes:\n"
    "  0 plan found; 10, 11 proved unsolvable (before, by search); 12 searched in vain, without a proof;\n"
    "  22 memory limit; 23 time limit; 30 internal error; 31 wrong input; 34 unsupported input;\n"
    "  35 output could not be written; 128 + N ended by signal N\n"
    "\nExamples:\n"
    "  plan domain.pddl problem.pddl\n"
    "  plan domain.pddl problem.pddl --search 'astar(lmcut())' --time-limit 60\n"
    "  plan problem.pddl --plan-file my.plan --json report.json --quiet\n"
    "  generate-problem | plan domain.pddl -";

constexpr const char* kValidateUsage = "\nUsage:\n  plan validate DOMAIN PROBLEM PLAN [options]";
constexpr const char* kValidateFooter =
    "Exit codes: 0 valid; 1 not valid; 31 a file is wrong; 34 unsupported input\n"
    "\nExamples:\n"
    "  plan validate domain.pddl problem.pddl my.plan\n"
    "  plan domain.pddl problem.pddl --quiet | plan validate domain.pddl problem.pddl -";

constexpr const char* kGroundUsage =
    "\nUsage:\n  plan ground DOMAIN PROBLEM [options]\n  plan ground PROBLEM [options]";
constexpr const char* kGroundFooter =
    "Examples:\n"
    "  plan ground domain.pddl problem.pddl\n"
    "  plan ground domain.pddl problem.pddl --sas output.sas";

constexpr const char* kListUsage = "\nUsage:\n  plan list [evaluators|engines|aliases]";
constexpr const char* kListFooter = "Examples:\n  plan list\n  plan list evaluators";

Request parse_plan_command(std::vector<std::string> arguments) {
    PlanOptions options;
    std::vector<std::string> files;
    CLI::App app("plan: finds plans for PDDL tasks");
    set_usage(app, kPlanUsage, kPlanFooter);
    app.set_version_flag("--version", "praxis " PRAXIS_VERSION, "Show the version");
    app.add_option("FILES", files)->group("");
    auto* search = app.add_option("-s,--search", options.search,
                                  "What to run, such as 'astar(lmcut())'; see 'plan list'")
                       ->type_name("EXPR");
    app.add_option("-a,--alias", options.alias, "A configuration by its name (default: agile)")
        ->type_name("NAME")
        ->excludes(search);
    app.add_option("-o,--plan-file", options.plan_file,
                   "Write the plan to FILE too; all plans of an anytime search to FILE.1, FILE.2, ...")
        ->type_name("FILE");
    add_common_options(app, options);
    app.add_option("--threads", options.threads, "Threads for searches that use several (default: 1)")
        ->type_name("N")
        ->check(CLI::Range(1, 1024).description(""));
    app.add_option("--seed", options.seed, "Seed of whatever is random (default: 0)")
        ->type_name("N")
        ->check(non_negative_integer);
    bool no_check = false;
    app.add_flag("--no-check", no_check, "Do not validate plans before they are given out");
    if (auto done = parse(app, std::move(arguments), "plan")) return *done;
    options.check = !no_check;
    if (files.empty()) return usage_error("no task given: plan DOMAIN PROBLEM", "plan");
    if (files.size() > 3) return usage_error("too many files: plan DOMAIN PROBLEM [PLANFILE]", "plan");
    if (files.size() > 1) options.domain = files[0];
    options.problem = files[files.size() > 1 ? 1 : 0];
    if (files.size() == 3) {
        if (!options.plan_file.empty()) return usage_error("two plan files given", "plan");
        options.plan_file = files[2];
    }
    if (options.domain == "-" && options.problem == "-")
        return usage_error("only one file can be read from standard input", "plan");
    return options;
}

Request parse_validate_command(std::vector<std::string> arguments) {
    ValidateOptions options;
    CLI::App app("plan validate: executes a plan on the task as it is written and says what fails");
    set_usage(app, kValidateUsage, kValidateFooter);
    std::vector<std::string> files;
    app.add_option("FILES", files)->group("");
    add_common_options(app, options);
    if (auto done = parse(app, std::move(arguments), "plan validate")) return *done;
    if (files.size() != 3)
        return usage_error("three files are needed: plan validate DOMAIN PROBLEM PLAN", "plan validate");
    options.domain = files[0];
    options.problem = files[1];
    options.plan = files[2];
    if ((files[0] == "-") + (files[1] == "-") + (files[2] == "-") > 1)
        return usage_error("only one file can be read from standard input", "plan validate");
    return options;
}

Request parse_ground_command(std::vector<std::string> arguments) {
    GroundCommandOptions options;
    CLI::App app("plan ground: counts, time and memory of every phase of grounding");
    set_usage(app, kGroundUsage, kGroundFooter);
    std::vector<std::string> files;
    app.add_option("FILES", files)->group("");
    app.add_option("--sas", options.sas, "Write the task as SAS+ (version 3); '-': to standard output")
        ->type_name("FILE");
    add_common_options(app, options);
    if (auto done = parse(app, std::move(arguments), "plan ground")) return *done;
    if (files.empty() || files.size() > 2)
        return usage_error("two files are needed: plan ground DOMAIN PROBLEM", "plan ground");
    if (files.size() == 2) options.domain = files[0];
    options.problem = files.back();
    if (options.domain == "-" && options.problem == "-")
        return usage_error("only one file can be read from standard input", "plan ground");
    return options;
}

Request parse_list_command(std::vector<std::string> arguments) {
    ListOptions options;
    CLI::App app("plan list: every component with its options and their defaults");
    set_usage(app, kListUsage, kListFooter);
    app.add_option("KIND", options.kind)
        ->group("")
        ->check(CLI::IsMember({"evaluators", "engines", "aliases"}));
    if (auto done = parse(app, std::move(arguments), "plan list")) return *done;
    return options;
}

}  // namespace

Request parse_command_line(int argc, const char* const* argv) {
    const std::string_view command = argc > 1 ? argv[1] : "";
    const bool named = command == "validate" || command == "ground" || command == "belief" ||
                       command == "practice" || command == "list";
    // CLI11 wants the arguments in reverse.
    std::vector<std::string> arguments;
    for (int i = argc - 1; i >= (named ? 2 : 1); --i) arguments.emplace_back(argv[i]);
    if (command == "validate") return parse_validate_command(std::move(arguments));
    if (command == "ground") return parse_ground_command(std::move(arguments));
    if (command == "belief") return parse_belief_command(std::move(arguments));
    if (command == "practice") return parse_practice_command(std::move(arguments));
    if (command == "list") return parse_list_command(std::move(arguments));
    return parse_plan_command(std::move(arguments));
}

}  // namespace praxis::app
