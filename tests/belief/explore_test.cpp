#include "belief/explore.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "belief/grow.hpp"
#include "belief/simulated_robot.hpp"
#include "search/validate.hpp"

namespace praxis::belief {
namespace {

/// Drawers with things that are not known to exist before a drawer is opened.
constexpr const char* kDomain = R"(
(define (domain tidy)
  (:requirements :adl :typing)
  (:types thing place - object drawer box - place)
  (:predicates (at ?t - thing ?p - place) (held ?t - thing) (free) (open ?d - drawer) (searched ?d - drawer))
  (:action open :parameters (?d - drawer)
    :precondition (and (free) (not (open ?d)))
    :effect (and (open ?d) (searched ?d))
    :observe (forall (?t - thing) (at ?t ?d)))
  (:action take :parameters (?t - thing ?d - drawer)
    :precondition (and (free) (open ?d) (at ?t ?d))
    :effect (and (held ?t) (not (free)) (not (at ?t ?d))))
  (:action put :parameters (?t - thing ?b - box)
    :precondition (held ?t)
    :effect (and (free) (not (held ?t)) (at ?t ?b))))
)";

std::string problem(const std::string& hidden) {
    return R"((define (problem p) (:domain tidy)
  (:objects d1 d2 - drawer b - box cup - thing)
  (:hidden-objects pen key - thing)
  (:init (free)
    (oneof (at cup d1) (at cup d2))
    (oneof (at pen d1) (at pen d2)) (oneof (at key d1) (at key d2)))
  (:hidden )" +
           hidden + R"()
  (:goal (and (searched d1) (searched d2) (forall (?t - thing) (at ?t b))))))";
}

struct Case {
    std::shared_ptr<const ContingentTask> full;
    std::shared_ptr<const BeliefTask> world_task;
};

Case make(const std::string& hidden) {
    Case result;
    result.full = parse_contingent({"d", kDomain}, {"p", problem(hidden)}).task;
    result.world_task = ground_belief(result.full).task;
    return result;
}

TEST(Grow, HiddenObjectsAreNotInTheVisiblePart) {
    const Case c = make("(at cup d1) (at pen d1) (at key d2)");
    const auto visible = visible_part(*c.full);
    const auto ground = ground_belief(visible).task;
    for (std::size_t o = 0; o < ground->operator_count(); ++o)
        EXPECT_EQ(ground->physical->operator_names.words(o).find(" pen"), std::string::npos);
    EXPECT_EQ(ground->clauses.size(), 1u);
    EXPECT_EQ(c.world_task->clauses.size(), 3u);
}

class Explore : public testing::TestWithParam<const char*> {};

TEST_P(Explore, PutsAwayWhatItFinds) {
    const Case c = make(GetParam());
    SimulatedWorld world(c.world_task, hidden_world(*c.world_task, 0));
    SimulatedRobot robot(c.world_task, world);
    const Exploration exploration = explore(c.full, robot, robot);
    EXPECT_EQ(exploration.status, RunStatus::reached) << exploration.message;
    EXPECT_TRUE(world.goal_holds());  // over all things, also those that were hidden
    std::vector<std::string> found = exploration.found;
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, (std::vector<std::string>{"key", "pen"}));
    EXPECT_EQ(exploration.actions.size(), 8u);  // two drawers, three things
    EXPECT_TRUE(exploration.task->hidden_objects.empty());
}

INSTANTIATE_TEST_SUITE_P(Worlds, Explore,
                         testing::Values("(at cup d1) (at pen d1) (at key d2)",
                                         "(at cup d2) (at pen d1) (at key d1)",
                                         "(at cup d2) (at pen d2) (at key d2)"));

/// An observer that also sees a thing that no file speaks of.
class SeesMore : public Observer {
  public:
    SeesMore(Observer& observer, Detection detection)
        : observer_(observer), detection_(std::move(detection)) {}
    Percept observe(const ObservationRequest& request, std::stop_token stop) override {
        Percept percept = observer_.observe(request, stop);
        if (request.action != nullptr) percept.detections.push_back(detection_);
        return percept;
    }

  private:
    Observer& observer_;
    Detection detection_;
};

TEST(Explore, AThingOfNoFileBecomesPartOfTheGoal) {
    const Case c = make("(at cup d1) (at pen d1) (at key d2)");
    SimulatedWorld world(c.world_task, hidden_world(*c.world_task, 0));
    SimulatedRobot robot(c.world_task, world);
    SeesMore observer(robot, {"mouse", "thing", Position{1, 2, 3}, 1});
    const Exploration exploration = explore(c.full, robot, observer);
    // The world is closed: the mouse is in no drawer, so it can never come into the box.
    EXPECT_EQ(exploration.status, RunStatus::infeasible);
    EXPECT_EQ(std::count(exploration.found.begin(), exploration.found.end(), "mouse"), 1);
    EXPECT_EQ(exploration.task->task->objects.back().name, "mouse");
}

TEST(Explore, AThingOfAnUnknownTypeIsRefused) {
    const Case c = make("(at cup d1) (at pen d1) (at key d2)");
    SimulatedWorld world(c.world_task, hidden_world(*c.world_task, 0));
    SimulatedRobot robot(c.world_task, world);
    SeesMore observer(robot, {"mouse", "animal", std::nullopt, 1});
    const Exploration exploration = explore(c.full, robot, observer);
    EXPECT_EQ(exploration.status, RunStatus::found_objects);
    EXPECT_NE(exploration.message.find("'animal'"), std::string::npos);
}

}  // namespace
}  // namespace praxis::belief
