#include <string>
#include <vector>

#include "app/command_line_parts.hpp"
#include "app/refine/refine_options.hpp"

namespace praxis::app {
namespace {

constexpr const char* kHint = "plan refine";

constexpr const char* kUsage =
    "\nUsage:\n"
    "  plan refine DOMAIN PROBLEM SCENE [options]      plan, and find collision-free motion for the plan\n"
    "  plan refine --generate FAMILY FOLDER [options]  make a problem of a family: problem.pddl, scene.yaml\n"
    "  plan refine --list                              the families\n"
    "\nSCENE is a YAML file: robot, bodies, regions. The streams that make poses, grasps and motions are\n"
    "declared in streams.pddl beside the domain.";

constexpr const char* kFooter =
    "The plan goes to standard output, everything else to standard error. Every plan is checked before it "
    "is\n"
    "given out: its actions on the task as written, its motion for collisions and limits.\n"
    "\nExit codes:\n"
    "  0 plan found; 11 proved infeasible; 12 nothing left to try, without a proof; 22 memory limit;\n"
    "  23 time limit; 30 internal error; 31 wrong input; 34 unsupported input; 35 output could not be\n"
    "  written; 128 + N ended by signal N\n"
    "\nExamples:\n"
    "  plan refine domain.pddl problem.pddl scene.yaml\n"
    "  plan refine domain.pddl problem.pddl scene.yaml --view plan.html --trajectory plan.json\n"
    "  plan refine --generate blocked-shelf --size 5 --seed 2 shelf";

/// A share of limits.
std::string share(const std::string& text) {
    if (const std::string wrong = positive_number(text); !wrong.empty()) return wrong;
    return std::stod(text) <= 1 ? std::string() : "'" + text + "' is more than 1";
}

RefineRequest generate_request(GenerateOptions options, const std::vector<std::string>& files) {
    if (files.size() != 1)
        return usage_error("a folder is needed: plan refine --generate FAMILY FOLDER", kHint);
    options.folder = files.front();
    return options;
}

}  // namespace

RefineRequest parse_refine_command(std::vector<std::string> arguments) {
    RefineCommandOptions options;
    GenerateOptions generate;
    std::vector<std::string> files;
    bool list = false;
    CLI::App app("plan refine: plans for a robot, down to its motion");
    set_usage(app, kUsage, kFooter);
    app.add_option("FILES", files)->group("");
    app.add_option("--streams", options.streams, "Stream file (default: streams.pddl beside the domain)")
        ->type_name("FILE");
    app.add_option("-s,--search", options.search, "How skeletons are searched for; see 'plan list'")
        ->type_name("EXPR");
    auto* seed = app.add_option("--seed", options.seed, "Seed of whatever is random (default: 0)")
                     ->type_name("N")
                     ->check(non_negative_integer);
    add_common_options(app, options);
    app.add_option("--trajectory", options.trajectory,
                   "Write plan and motion as JSON; '-': to standard output")
        ->type_name("FILE")
        ->group("Motion");
    app.add_option("--csv", options.csv, "Write the motion as comma-separated values")
        ->type_name("FILE")
        ->group("Motion");
    app.add_option("--csv-rate", options.csv_rate, "Rows a second (default: 100)")
        ->type_name("HZ")
        ->check(positive_number)
        ->group("Motion");
    app.add_option("--yaml", options.yaml, "Write the motion in the shape of ROS's JointTrajectory")
        ->type_name("FILE")
        ->group("Motion");
    app.add_option("--view", options.view, "Write a page that shows plan, motion and failed attempts")
        ->type_name("FILE")
        ->group("Motion");
    app.add_option("--speed", options.speed, "Share of the robot's limits that motions use (default: 1)")
        ->type_name("X")
        ->check(share)
        ->group("Motion");
    app.add_flag("--by-home", options.by_home, "Return to the start configuration between actions")
        ->group("Motion");
    auto* family = app.add_option("--generate", generate.family, "Make a problem of this family")
                       ->type_name("FAMILY")
                       ->group("Problems");
    app.add_option("--size", generate.size, "Its size (default: the family's smallest)")
        ->type_name("N")
        ->check(CLI::Range(1, 1'000'000).description(""))
        ->needs(family)
        ->group("Problems");
    app.add_flag("--infeasible", generate.infeasible, "One that looks alike and has no solution")
        ->needs(family)
        ->group("Problems");
    app.add_flag("--list", list, "The families, and what their sizes count")->group("Problems");
    if (auto done = parse(app, std::move(arguments), kHint)) return *done;
    if (list) return FamilyListOptions{};
    if (family->count() > 0) {
        if (seed->count() > 0) generate.seed = options.seed;
        return generate_request(std::move(generate), files);
    }
    if (files.size() != 3)
        return usage_error("three files are needed: plan refine DOMAIN PROBLEM SCENE", kHint);
    options.domain = files[0];
    options.problem = files[1];
    options.scene = files[2];
    if ((files[0] == "-") + (files[1] == "-") + (files[2] == "-") + (options.streams == "-") > 1)
        return usage_error("only one file can be read from standard input", kHint);
    int outputs = 0;
    for (const std::string* file :
         {&options.json, &options.trajectory, &options.csv, &options.yaml, &options.view})
        outputs += *file == "-";
    if (outputs > 1) return usage_error("only one result can go to standard output ('-')", kHint);
    return options;
}

}  // namespace praxis::app
