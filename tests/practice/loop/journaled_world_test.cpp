#include <gtest/gtest.h>

#include "parser/diagnostic.hpp"
#include "practice/loop/journal.hpp"
#include "tests/practice/support/runs.hpp"

namespace praxis::practice {
namespace {

using test::TestFile;

/// A world that nobody can put anywhere: each skill adds its parameter to the only number.
class RealWorld : public World {
  public:
    std::vector<GroundAtom> next_task() override {
        ++tasks;
        return {{tasks, {}}};
    }
    const State& observe() override { return state; }
    void execute(const GroundSkill&, std::span<const double> parameters) override {
        ++skills;
        state[0] += parameters[0];
    }
    State state = {0};
    std::int32_t tasks = 0, skills = 0;
};

const GroundSkill kSkill{0, {}};

TEST(JournaledWorld, AnswersFromTheJournalThenActs) {
    const TestFile file;
    {
        RealWorld real;
        Journal journal(file.path(), "");
        JournaledWorld world(real, journal);
        EXPECT_FALSE(world.replaying());
        EXPECT_EQ(world.next_task(), (std::vector<GroundAtom>{{1, {}}}));
        world.execute(kSkill, std::vector{2.0});
        world.execute(kSkill, std::vector{3.0});
        EXPECT_EQ(world.observe(), State{5});
    }
    {
        RealWorld real;
        real.state = {40};  // somebody has been there
        Journal journal(file.path(), "");
        JournaledWorld world(real, journal);
        EXPECT_TRUE(world.replaying());
        EXPECT_EQ(world.next_task(), (std::vector<GroundAtom>{{1, {}}}));
        EXPECT_EQ(world.observe(), State{0});
        world.execute(kSkill, std::vector{2.0});
        EXPECT_EQ(world.observe(), State{2});
        world.execute(kSkill, std::vector{3.0});
        EXPECT_FALSE(world.replaying());
        EXPECT_EQ(world.observe(), State{5});
        EXPECT_EQ(real.skills + real.tasks, 0);
        world.execute(kSkill, std::vector{1.0});
        EXPECT_EQ(world.observe(), State{41});
        EXPECT_EQ(world.next_task(), (std::vector<GroundAtom>{{1, {}}}));
    }
    EXPECT_EQ(Journal(file.path(), "").records().size(), 5u);
}

TEST(JournaledWorld, TakenUpTwiceTellsTheSameStory) {
    const TestFile file;
    const auto story = [&](double meanwhile, int skills) {
        RealWorld real;
        real.state = {meanwhile};
        Journal journal(file.path(), "");
        JournaledWorld world(real, journal);
        std::vector<State> seen;
        world.next_task();
        seen.push_back(world.observe());
        for (int i = 0; i < skills; ++i) {
            world.execute(kSkill, std::vector{1.0});
            seen.push_back(world.observe());
        }
        return seen;
    };
    const std::vector<State> first = story(0, 2), second = story(100, 4), third = story(200, 6);
    EXPECT_EQ(first, (std::vector<State>{{0}, {1}, {2}}));
    EXPECT_EQ(second, (std::vector<State>{{0}, {1}, {2}, {101}, {102}}));
    EXPECT_EQ(third, (std::vector<State>{{0}, {1}, {2}, {101}, {102}, {201}, {202}}));
}

TEST(JournaledWorld, RefusesARunThatDecidesOtherwise) {
    const TestFile file;
    {
        RealWorld real;
        Journal journal(file.path(), "");
        JournaledWorld world(real, journal);
        world.next_task();
        world.execute(kSkill, std::vector{2.0});
    }
    const auto opened = [&](const auto& deed) {
        RealWorld real;
        Journal journal(file.path(), "");
        JournaledWorld world(real, journal);
        deed(world);
    };
    EXPECT_THROW(opened([](World& world) { world.execute(kSkill, std::vector{2.0}); }), InputError);
    const auto second = [&](const GroundSkill& skill, double parameter) {
        opened([&](World& world) {
            world.next_task();
            world.execute(skill, std::vector{parameter});
        });
    };
    EXPECT_NO_THROW(second(kSkill, 2));
    EXPECT_THROW(second(kSkill, 2.5), InputError);
    EXPECT_THROW(second({1, {}}, 2), InputError);
    EXPECT_THROW(opened([](World& world) {
                     world.next_task();
                     world.next_task();
                 }),
                 InputError);
}

}  // namespace
}  // namespace praxis::practice
