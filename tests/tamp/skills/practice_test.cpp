// A robot that practises a refined skill: its camera is badly calibrated, so that the cup is never quite in
// the middle of the hand, and it has to learn how far beside the tray to let go.
#include <gtest/gtest.h>

#include <cstddef>
#include <span>
#include <vector>

#include "practice/loop/practice_loop.hpp"
#include "practice/loop/practised_skills.hpp"
#include "practice/loop/skill_world.hpp"
#include "tamp/skills/refined_skills.hpp"
#include "tamp/skills/simulated_driver.hpp"
#include "tests/tamp/support/gantry.hpp"

namespace praxis::tamp {
namespace {

using practice::uniform;
using test::at;
using test::cups;
using test::GantryPlan;

const Pose kTray = at(-0.3, 0.1);
constexpr double kRight = 0.01;  // metres from the middle of the tray

/// A state: whether the cup is held, its distance from the middle of the tray, how far it is beside the
/// middle of the hand.
enum Number : std::size_t { held, distance, beside };

class Serving : public practice::Environment {
  public:
    Serving() {
        description_.name = "serving";
        description_.domain = R"((define (domain serving) (:requirements :strips)
  (:predicates (free) (held) (served))
  (:action pick :parameters () :precondition (free) :effect (and (held) (not (free)) (not (served))))
  (:action place :parameters () :precondition (held) :effect (and (served) (free) (not (held))))))";
        description_.problem = "(define (problem p) (:domain serving) (:init (free)) (:goal (served)))";
        description_.predicates = {"free", "held", "served"};
        description_.schemas = {{"pick", {}, {}, {}}, {"place", {"offset"}, {"beside"}, {0}}};
        description_.horizon = 4;
        description_.cycle_steps = 20;
    }
    const practice::Description& description() const override { return description_; }
    bool holds(const practice::State& state, const practice::GroundAtom& atom) const override {
        if (atom.predicate == 2) return state[held] == 0 && state[distance] < kRight;
        return (state[held] != 0) == (atom.predicate == 1);
    }
    void propose(const practice::State&, const practice::GroundSkill&, Random& random,
                 std::span<double> parameters) const override {
        for (double& parameter : parameters) parameter = uniform(random, -0.05, 0.05);
    }
    void features(const practice::State& state, const practice::GroundSkill&,
                  std::span<double> features) const override {
        for (double& feature : features) feature = state[beside];
    }

  private:
    practice::Description description_;
};

TEST(PracticeWithRefinedSkills, LearnsWhereToLetGo) {
    Random random(5);
    double error = 0.02;  // of the camera, metres along x
    GantryPlan scene(cups({{"cup", at(0.4, 0.2)}}));
    SimulatedDriver driver(scene.document(), {.reach = 0.05});
    int placed = 0;
    const auto refine = [&](const ActionName& action, std::span<const double> parameters,
                            const Situation& now) {
        if (action.words[0] == "pick") {
            const Vector3 seen = now.bodies.at("cup").translation() - error * Vector3::UnitX();
            GantryPlan plan(cups({{"cup", at(seen.x(), seen.y(), seen.z())}}));
            plan.pick("cup", at(seen.x(), seen.y(), seen.z()), {});
            return plan.skills();
        }
        EXPECT_EQ(parameters.size(), 1u);
        ++placed;
        GantryPlan plan(cups({{"cup", kTray}}), "cup");
        plan.place("cup", kTray * at(parameters[0], 0), {});
        return plan.skills();
    };
    RefinedSkills skills(refine, test::gantry(), driver,
                         {.period = 0.02, .start = {.robot = 0.02, .body = 0.06}});
    const Serving serving;
    const auto see = [&] {
        const double off = (driver.bodies().at("cup").translation() - kTray.translation()).norm();
        return practice::State{driver.holds("cup") ? 1. : 0., off, error};
    };
    practice::SkillWorld world(serving.description(), skills, see, [&] {
        if (!driver.holds("cup")) {
            error = uniform(random, -0.04, 0.04);
            driver.put("cup", at(0.4, 0.2));
        }
        return std::vector<practice::GroundAtom>{{2, {}}};
    });
    practice::PracticeOptions options;
    options.competence.model = "beta";
    options.policy.classifier.kind = "knn";
    practice::PracticeLoop loop(serving, world, options);
    for (int cycle = 0; cycle < 25; ++cycle) {
        ASSERT_TRUE(loop.run_cycle());
        ASSERT_EQ(world.last().status, Execution::Status::done) << world.last().message;
    }
    EXPECT_GT(placed, 200);

    // Afterwards, by name alone, with other errors of the camera.
    practice::PractisedSkills practised(loop.learner(), skills, see);
    int hits = 0;
    for (int trial = 0; trial < 40; ++trial) {
        driver.put("cup", at(0.4, 0.2));
        driver.put_robot(test::gantry_home());
        error = uniform(random, -0.04, 0.04);
        for (const char* name : {"pick", "place"})
            ASSERT_EQ(practised.execute({{name}}, {}, {}).status, Execution::Status::done);
        hits += see()[distance] < kRight;
    }
    EXPECT_GT(hits, 28);  // a guess hits one in five
}

}  // namespace
}  // namespace praxis::tamp
