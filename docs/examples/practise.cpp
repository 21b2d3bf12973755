// practise JOURNAL: a robot learns to fill glasses. All that it goes through is in the journal: a run that
// was cut off goes on where it was.
#include <cmath>
#include <iostream>
#include <practice/loop/journal.hpp>
#include <practice/loop/practice_loop.hpp>
#include <practice/loop/settings_text.hpp>

using namespace praxis::practice;

namespace {

/// A state: whether the bottle is held, whether the glass is full, and how deep the glass is, in metres.
class Knowledge : public Environment {
  public:
    Knowledge() {
        description_.name = "pouring";
        description_.domain = R"((define (domain pouring)
  (:predicates (held) (full))
  (:action grasp :parameters () :precondition () :effect (held))
  (:action pour :parameters () :precondition (held) :effect (full))))";
        description_.problem = "(define (problem a-glass) (:domain pouring) (:init) (:goal (full)))";
        description_.predicates = {"held", "full"};
        description_.schemas = {{"grasp", {}, {}, {}}, {"pour", {"tilt"}, {"depth"}, {0}}};
        description_.horizon = 4;
        description_.cycle_steps = 20;
    }
    const Description& description() const override { return description_; }
    bool holds(const State& state, const GroundAtom& atom) const override {
        return state[static_cast<std::size_t>(atom.predicate)] != 0;
    }
    void propose(const State&, const GroundSkill&, praxis::Random& random,
                 std::span<double> parameters) const override {
        if (!parameters.empty()) parameters[0] = uniform(random, 0, 90);  // degrees
    }
    void features(const State& state, const GroundSkill&, std::span<double> features) const override {
        if (!features.empty()) features[0] = state[2];
    }

  private:
    Description description_;
};

/// Where a real robot would move and look.
class Robot : public World {
  public:
    std::vector<GroundAtom> next_task() override {
        state_ = {0, 0, uniform(random_, 0.1, 0.3)};  // another glass
        return {{1, {}}};
    }
    const State& observe() override { return state_; }
    void execute(const GroundSkill& skill, std::span<const double> parameters) override {
        if (skill.schema == 0)
            state_[0] = 1;
        else
            state_[1] = std::abs(parameters[0] - 200 * state_[2]) < 5;
    }
    void resume(const State& state, std::uint64_t skills, std::uint64_t /*tasks*/) override {
        state_ = state;
        random_ = praxis::Random(skills);
    }

  private:
    praxis::Random random_{0};
    State state_;
};

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) return 31;
    const Knowledge knowledge;
    PracticeOptions options;
    options.cycles = 15;
    Robot robot;
    Journal journal(argv[1], settings_text(knowledge, options));
    std::cout << journal.records().size() << " records in the journal\n";
    JournaledWorld world(robot, journal);
    PracticeLoop loop(knowledge, world, options);
    const Learner& learner = loop.learner();
    const SkillIndex pour = learner.skills().find("(pour)");
    for (int cycle = 1; cycle <= options.cycles && loop.run_cycle(); ++cycle) {
        journal.sync();
        std::cout << "cycle " << cycle << ": poured " << learner.competences().tries(pour)
                  << " times, competence " << learner.competences().competence(pour) << "\n";
    }
    return learner.competences().competence(pour) > 0.8 ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 31;
}
