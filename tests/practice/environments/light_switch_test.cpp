#include <fstream>
#include <iterator>

#include "parser/parser.hpp"
#include "parser/write.hpp"
#include "practice/environments/light_switch.hpp"
#include "tests/practice/environments/abstract_task.hpp"

namespace praxis::practice::test {
namespace {

constexpr std::int32_t kLevel = 1;
constexpr std::int32_t kTarget = 2;

TEST(LightSwitch, TheJumpIsAShortCutOnlyInPddl) {
    const LightSwitch environment(100);
    const AbstractTask task(environment);
    Random random(1);
    const PracticeTask drawn = environment.sample_task(random);
    EXPECT_EQ(task.distance(drawn), 99);
    EXPECT_EQ(task.distance(drawn, {"jump-to-light"}), 100);
    EXPECT_EQ(environment.description().horizon, 102);
    EXPECT_EQ(environment.description().cycle_steps, 150);
    State state = drawn.initial;
    state[0] = 97;
    const State before = state;
    environment.execute(state, task.skills()[task.find("jump-to-light c97 c98 c99")],
                        std::vector<double>{0.3}, random);
    EXPECT_EQ(state, before);
}

TEST(LightSwitch, IsOnWithinATenthOfTheTarget) {
    const LightSwitch environment(4);
    const AbstractTask task(environment);
    const GroundSkill turn_on = task.skills()[task.find("turn-on c3")];
    const GroundSkill turn_off = task.skills()[task.find("turn-off c3")];
    const GroundAtom light_on{1, {}};
    Random random(1);
    State state = {3, 0, 0.75};
    environment.execute(state, turn_on, std::vector<double>{0.64}, random);
    EXPECT_FALSE(environment.holds(state, light_on));
    environment.execute(state, turn_on, std::vector<double>{0.02}, random);
    EXPECT_TRUE(environment.holds(state, light_on));
    environment.execute(state, turn_off, std::vector<double>{-5}, random);
    EXPECT_FALSE(environment.holds(state, light_on));
    EXPECT_EQ(state[kLevel], 0);
    environment.execute(state, turn_on, std::vector<double>{5}, random);
    EXPECT_EQ(state[kLevel], 1);
}

TEST(LightSwitch, AboutEveryTenthProposalSucceeds) {
    const LightSwitch environment(4);
    const AbstractTask task(environment);
    const GroundSkill turn_on = task.skills()[task.find("turn-on c3")];
    Random random(1);
    constexpr int kTries = 40000;
    int successes = 0;
    for (int i = 0; i < kTries; ++i) {
        State state = environment.sample_task(random).initial;
        EXPECT_GE(state[kTarget], 0.5);
        EXPECT_LT(state[kTarget], 1.0);
        state[0] = 3;
        double d = 0;
        environment.propose(state, turn_on, random, {&d, 1});
        environment.execute(state, turn_on, {&d, 1}, random);
        successes += environment.holds(state, {1, {}}) ? 1 : 0;
    }

    EXPECT_NEAR(static_cast<double>(successes) / kTries, 0.095, 0.006);
}

TEST(LightSwitch, PosesTheProblemThatIsPublished) {
    const std::string file = PRAXIS_SOURCE_DIR "/problems/practice/light-switch/ten-cells.pddl";
    const std::string domain = PRAXIS_SOURCE_DIR "/domains/practice/light-switch/domain.pddl";
    const Task published = load(domain, file);
    const LightSwitch environment(10);
    const Description& description = environment.description();
    const Task made = parse_task({"domain", description.domain}, {"problem", description.problem}).task;
    EXPECT_EQ(write_problem(*made), write_problem(*published));
    std::ifstream text(domain);
    EXPECT_EQ(description.domain, std::string(std::istreambuf_iterator<char>(text), {}));
}

}  // namespace
}  // namespace praxis::practice::test
