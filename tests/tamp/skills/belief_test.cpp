// A belief agent that acts by refined skills: it does not know where the cup is, and its hand slips.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "belief/agent.hpp"
#include "belief/robot_environment.hpp"
#include "tamp/skills/refined_skills.hpp"
#include "tests/tamp/skills/recording_driver.hpp"
#include "tests/tamp/support/gantry.hpp"

namespace praxis::tamp {
namespace {

using test::at;
using test::cups;
using test::GantryPlan;
using test::RecordingDriver;

constexpr const char* kDomain = R"(
(define (domain kitchen)
  (:requirements :adl :typing :contingent)
  (:types cup place)
  (:predicates (at ?c - cup ?p - place) (held ?c - cup) (free))
  (:action look :parameters (?p - place) :precondition (free)
    :observe (forall (?c - cup) (at ?c ?p)))
  (:action pick :parameters (?c - cup ?p - place) :precondition (and (free) (at ?c ?p))
    :effect (and (held ?c) (not (free)) (not (at ?c ?p))))
  (:action place :parameters (?c - cup ?p - place) :precondition (held ?c)
    :effect (and (at ?c ?p) (free) (not (held ?c))))))";
constexpr const char* kProblem = R"(
(define (problem p) (:domain kitchen)
  (:objects cup - cup shelf drawer tray - place)
  (:init (free) (oneof (at cup shelf) (at cup drawer)))
  (:goal (at cup tray))))";

const std::map<std::string, Pose>& places() {
    static const std::map<std::string, Pose> all = {
        {"shelf", at(0.4, 0.2, 0.1)}, {"drawer", at(0.4, -0.3)}, {"tray", at(-0.3, 0.1)}};
    return all;
}

/// Motion for a call: to where the place is.
std::vector<RefinedSkill> refine(const ActionName& action, std::span<const double>, const Situation&) {
    const std::vector<std::string>& words = action.words;
    const std::vector<std::string> arguments(words.begin() + 1, words.end());
    const Pose& place = places().at(words.back());
    if (words[0] == "look") {
        GantryPlan plan(cups({}));
        plan.look(place, arguments);
        return plan.skills();
    }
    const bool picks = words[0] == "pick";
    GantryPlan plan(cups({{"cup", place}}), picks ? "" : "cup");
    picks ? plan.pick("cup", place, arguments) : plan.place("cup", place, arguments);
    return plan.skills();
}

/// Sees where the robot looks, and what is in its hand.
class Camera : public belief::Observer {
  public:
    explicit Camera(RecordingDriver& driver) : driver_(&driver) {}

    belief::Percept observe(const belief::ObservationRequest& request, std::stop_token) override {
        belief::Percept percept;
        for (const belief::AtomName& atom : request.questions) {
            const std::vector<std::string>& words = atom.words;
            const auto read = [&](bool holds) {
                percept.readings.push_back(
                    {atom, holds ? belief::Truth::known_true : belief::Truth::known_false});
            };
            if (words[0] == "at") {
                const Vector3 cup = driver_->bodies().at("cup").translation();
                read(!driver_->holds("cup") && (cup - places().at(words[2]).translation()).norm() < 0.05);
            } else {
                read(driver_->holds("cup") == (words[0] == "held"));
            }
        }
        return percept;
    }

  private:
    RecordingDriver* driver_;
};

/// The kitchen with the cup at a pose, and a robot in it.
struct Kitchen {
    explicit Kitchen(const Pose& cup, const SimulationOptions& simulation = {})
        : driver(GantryPlan(cups({{"cup", cup}})).document(), simulation) {}

    belief::RunResult run() {
        const auto source = parse_contingent({"domain.pddl", kDomain}, {"problem.pddl", kProblem}).task;
        const auto task = belief::ground_belief(source).task;
        const auto compilation = std::make_shared<const belief::Compilation>(task);
        RefinedSkills skills(refine, test::gantry(), driver, {.period = 0.02});
        Camera camera(driver);
        belief::RobotEnvironment environment(task, skills, camera);
        belief::Belief belief(compilation);
        const belief::Agent agent(std::make_shared<const belief::KnowledgePlanner>(compilation));
        return agent.run(belief, environment, {}, [&](const belief::Event& event, const belief::Belief&) {
            failures += event.kind == belief::Event::Kind::failed;
        });
    }

    RecordingDriver driver;
    std::size_t failures = 0;
};

TEST(BeliefWithRefinedSkills, FindsTheCupAndCarriesItToTheTray) {
    std::size_t failures = 0;
    for (const char* hidden : {"shelf", "drawer"}) {
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            Kitchen kitchen(places().at(hidden), {.slip = 0.4, .seed = seed});
            const belief::RunResult run = kitchen.run();
            EXPECT_EQ(run.status, belief::RunStatus::reached) << hidden << ": " << run.message;
            EXPECT_TRUE(kitchen.driver.bodies().at("cup").isApprox(places().at("tray"), 1e-9));
            EXPECT_EQ(kitchen.driver.positions(), test::gantry_home());
            failures += kitchen.failures;
        }
    }
    EXPECT_GT(failures, 0u);
}

TEST(BeliefWithRefinedSkills, ACupThatIsNotWhereItShouldBeEndsTheRun) {
    Kitchen kitchen(at(0.4, 0.24, 0.1));  // four centimetres from the shelf's middle
    const belief::RunResult run = kitchen.run();
    EXPECT_EQ(run.status, belief::RunStatus::illegal);
    EXPECT_EQ(run.message, "cup is 0.04 m from where (pick cup shelf) has it");
}

}  // namespace
}  // namespace praxis::tamp
