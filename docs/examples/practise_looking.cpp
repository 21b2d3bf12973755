// practise_looking [FOLDER [SEED]]: a robot learns to read a scale, because its tasks depend on it. FOLDER is
// that of Praxis.
//
// Skills and readings have one cost, -log of the probability that they go right. The cheapest plan for a task
// tells which of them is the bottleneck; the robot practises that one, with boxes of known weight. How often
// it then reads right is what its readings are worth when it sorts boxes that it does not know.
#include <belief/agent.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <practice/loop/practice_loop.hpp>
#include <practice/loop/simulated_world.hpp>

#include "weighing.hpp"

namespace belief = praxis::belief;
namespace practice = praxis::practice;
using weighing::kBoxes, weighing::Look, weighing::Rehearsal;

namespace {

constexpr int kTasks = 200;
constexpr int kMostActions = 60;  // a task

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::uint64_t number_of(const std::string& text) {
    std::uint64_t number = 0;
    const char* end = text.data() + text.size();
    if (std::from_chars(text.data(), end, number).ptr != end || text.empty())
        throw std::runtime_error("the seed must be a whole number, not '" + text + "'");
    return number;
}

practice::SkillIndex reading_of(const practice::SkillTask& skills, std::size_t box) {
    return skills.find("(read-display box" + std::to_string(box + 1) + " balance)");
}

// Which skill would help?

/// Prints what a plan would cost if one of two equally bad skills were better; whether it is the look that
/// matters.
bool weigh_improvements(const Rehearsal& rehearsal, double bad, double good, std::uint64_t seed) {
    const practice::SkillTask skills(rehearsal);
    practice::CostPlanner planner(skills);
    std::vector<practice::Situation> tasks;
    praxis::Random random(seed);
    for (int i = 0; i < 10; ++i) {
        const practice::PracticeTask task = rehearsal.sample_task(random);
        tasks.push_back({{}, skills.goal(task.goal)});
        skills.read(task.initial, tasks.back().values);
    }
    std::vector<practice::Cost> costs;
    for (practice::SkillIndex skill = 0; skill < skills.size(); ++skill)
        costs.push_back(practice::success_cost(skills.name(skill).starts_with("(take-") ? 0.95 : 1));
    const std::vector<practice::SkillIndex> candidates = {reading_of(skills, 0), reading_of(skills, 1),
                                                          skills.find("(open-cupboard shelf)")};
    std::vector<practice::Improvement> improvements = {{0, costs[0]}};
    for (const practice::SkillIndex candidate : candidates) {
        costs[candidate] = practice::success_cost(bad);
        improvements.push_back({candidate, practice::success_cost(good)});
    }
    const std::vector<double> means = planner.expected_costs(tasks, costs, improvements);
    std::printf("Expected cost of a task's plan, -log of its chance to go right: %.2f. It would be\n",
                means[0]);
    for (std::size_t i = 0; i < candidates.size(); ++i)
        std::printf("  %.2f if %s went right with %.2f instead of %.2f\n", means[i + 1],
                    skills.name(candidates[i]).c_str(), good, bad);
    return means[1] < means[0] - 0.1 && means[2] < means[0] - 0.1 && std::abs(means[3] - means[0]) < 1e-6;
}

// Sorting boxes that are not known.

struct Score {
    int successes = 0;
    int false_successes = 0;  // the robot says that all is done, and it is not
    int broken_bins = 0;      // it dropped a heavy box
    double readings = 0;      // a task
    double accuracy = 0;      // true one of the readings
};

class Errand {
  public:
    Errand(const std::string& folder, std::uint64_t seed) : seed_(seed) {
        const std::string name = "belief/sort-weight-display/";
        task_ = belief::ground_belief(praxis::load_contingent(folder + "/domains/" + name + "domain.pddl",
                                                              folder + "/problems/" + name + "two-boxes.pddl")
                                          .task)
                    .task;
        compilation_ = std::make_shared<const belief::Compilation>(task_);
        planner_ = std::make_shared<const belief::KnowledgePlanner>(compilation_);
    }

    Score sort(const Look& look) const {
        belief::AgentOptions options = belief::default_agent_options();
        options.accept = 0.995;
        options.most_steps = kMostActions;
        const belief::Agent agent(planner_, options);
        Score score;
        int readings = 0, right = 0;
        praxis::Random random(seed_);
        for (int i = 0; i < kTasks; ++i) {
            weighing::Robot robot(task_, *belief::sample_world(*task_, random), look, random.next());
            belief::Belief known(compilation_);
            const belief::RunStatus status = agent.run(known, robot).status;
            const bool reached = status == belief::RunStatus::reached;
            score.successes += reached && robot.goal_holds();
            score.false_successes += reached && !robot.goal_holds();
            score.broken_bins += status == belief::RunStatus::illegal;
            readings += robot.readings();
            right += robot.right_readings();
        }
        score.readings = static_cast<double>(readings) / kTasks;
        score.accuracy = static_cast<double>(right) / readings;
        return score;
    }

  private:
    std::uint64_t seed_;
    std::shared_ptr<const belief::BeliefTask> task_;
    std::shared_ptr<const belief::Compilation> compilation_;
    std::shared_ptr<const belief::KnowledgePlanner> planner_;
};

void print(const char* what, const Look& look, const Score& score) {
    std::printf("%-38s %8.2f %6.2f %8d %6d %7d %9.1f\n", what, (look.accuracy[0] + look.accuracy[1]) / 2,
                score.accuracy, score.successes, score.false_successes, score.broken_bins, score.readings);
}

// The looks that are compared.

/// The unpractised robot waits for any time; its readings are thought to be this good.
Look unpractised(double accuracy) {
    return {[](std::size_t, double, praxis::Random& random) { return practice::uniform(random, 0, 10); },
            {accuracy, accuracy}};
}

/// How often unpractised readings of reference boxes are right.
double test_unpractised(std::uint64_t seed) {
    practice::Beta right{1, 1};
    praxis::Random random(seed);
    for (int i = 0; i < 200; ++i) {
        const double chance =
            weighing::chance_of_right_reading(practice::uniform(random, 0, 10), practice::uniform(random));
        ++(practice::uniform(random) < chance ? right.successes : right.failures);
    }
    return right.mean();
}

struct Practised {
    Score score;
    std::int64_t opened = 0;  // a cupboard, in vain
};

Practised practise(const Rehearsal& rehearsal, const Errand& errand, const std::string& method,
                   std::uint64_t seed) {
    practice::PracticeOptions options;
    options.method = method;
    options.seed = seed;
    options.cycles = 10;
    options.cycle_steps = 40;
    options.candidates = "all";
    practice::SimulatedWorld world(rehearsal, seed);
    practice::PracticeLoop loop(rehearsal, world, options);
    for (int cycle = 0; cycle < options.cycles; ++cycle) loop.run_cycle();

    const practice::Learner& learner = loop.learner();
    Practised result;
    Look look;
    std::int64_t weighed = 0;
    for (std::size_t box = 0; box < kBoxes; ++box) {
        const practice::SkillIndex reading = reading_of(learner.skills(), box);
        weighed += learner.competences().tries(reading);
        look.accuracy[box] = std::max(0.51, learner.competences().competence(reading));
    }
    for (const char* cupboard : {"shelf", "locker", "chest"})
        result.opened += learner.competences().tries(
            learner.skills().find(std::string("(open-cupboard ") + cupboard + ")"));
    look.wait = [&](std::size_t box, double height, praxis::Random& random) {
        return learner
            .decide(reading_of(learner.skills(), box), Rehearsal::with_box(box, height),
                    practice::Learner::Mode::greedy, random)
            .parameters[0];
    };
    result.score = errand.sort(look);
    print((method + ": " + std::to_string(weighed) + " readings, cupboards " + std::to_string(result.opened))
              .c_str(),
          look, result.score);
    return result;
}

}  // namespace

int main(int argc, char** argv) try {
    const std::string folder = argc > 1 ? argv[1] : ".";
    const std::uint64_t seed = argc > 2 ? number_of(argv[2]) : 1;
    const Rehearsal rehearsal(text_of(folder + "/domains/practice/weighing/domain.pddl"),
                              text_of(folder + "/problems/practice/weighing/two-boxes.pddl"));
    const Errand errand(folder, seed);

    const double tested = test_unpractised(seed);
    const bool bottleneck = weigh_improvements(rehearsal, tested, 0.95, seed);

    std::printf("\n%-38s %8s %6s %8s %6s %7s %9s\n", "readings", "believed", "right", "sorted", "wrong",
                "broken", "a task");
    const Look trusted = unpractised(practice::CompetenceOptions{}.prior.mean());
    const Look known = unpractised(tested);
    print("unpractised, trusted", trusted, errand.sort(trusted));
    const Score before = errand.sort(known);
    print("unpractised, tested", known, before);
    const Practised fails = practise(rehearsal, errand, "fail-focus", seed);
    const Practised ees = practise(rehearsal, errand, "ees", seed);

    const bool chosen = ees.opened == 0 && fails.opened > 0;
    const bool helped = ees.score.successes > before.successes && ees.score.readings < before.readings / 2;
    return bottleneck && chosen && helped ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 31;
}
