// Tasks written as PDDL.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "parser/write.hpp"
#include "tests/parser/contingent_texts.hpp"

namespace praxis {
namespace {

using test::contains;
using test::domain;
using test::dump;
using test::parse_belief;
using test::problem;

void expect_round_trip(const LiftedTask& task, const std::string& name) {
    const LoadResult again = test::parse(write_domain(task), write_problem(task));
    EXPECT_EQ(dump(task), dump(*again.task)) << name;
}

TEST(Write, OurDomainsReadBackAsTheSame) {
    const std::filesystem::path root = PRAXIS_SOURCE_DIR;
    std::size_t count = 0;
    for (const auto& folder : std::filesystem::directory_iterator(root / "problems")) {
        const std::filesystem::path domain_file = root / "domains" / folder.path().filename() / "domain.pddl";
        if (!std::filesystem::exists(domain_file)) continue;
        for (const auto& file : std::filesystem::directory_iterator(folder)) {
            if (file.path().extension() != ".pddl") continue;
            const auto task = load_contingent(domain_file.string(), file.path().string()).task;
            const auto again =
                parse_belief(write_contingent_domain(*task), write_contingent_problem(*task)).task;
            EXPECT_EQ(dump(*task), dump(*again)) << file.path();
            if (!task->contingent()) expect_round_trip(*task->task, file.path().string());
            ++count;
        }
    }
    EXPECT_GT(count, 3U);
}

TEST(Write, TasksOfTheIpcReadBackAsTheSame) {
    const std::string bench = PRAXIS_SOURCE_DIR "/../shared/bench/";
    std::ifstream list(bench + "smoke.txt");
    if (!list) GTEST_SKIP() << "no IPC tasks at " << bench;
    std::string name;
    std::string domain_file;
    std::string problem_file;
    while (list >> name >> domain_file >> problem_file) {
        expect_round_trip(*load(bench + domain_file, bench + problem_file), name);
    }
}

TEST(Write, KeepsCostsAxiomsAndEitherTypes) {
    const LoadResult result = test::parse(
        domain("(:types a b - place c - (either a b)) (:constants k - c)"
               "(:predicates (p ?x - (either a b)) (d ?x - a ?y)) (:functions (f ?x - a) - number "
               "(total-cost) - number)"
               "(:derived (d ?x ?y) (and (p ?x) (not (= ?x ?y))))"
               "(:action go :parameters (?x - a) :precondition (or (p ?x) (imply (d ?x k) (or)))"
               " :effect (and (p ?x) (increase (total-cost) (* 2.5 (+ (f ?x) (- (f k)) (/ 1 3)))) "
               " (increase (total-cost) (- 3 1))))"),
        problem(
            "(:objects l - (either a b) m - a) (:init (p l) (= (f m) -2.5)) (:goal (forall (?x - a) (p ?x)))"
            "(:metric minimize (total-cost))"));
    expect_round_trip(*result.task, "");
    const std::string text = write_domain(*result.task);
    EXPECT_TRUE(contains(text, "c - (either a b)")) << text;
    EXPECT_TRUE(contains(text, "(increase (total-cost) (+ (* 2.5 (+ (f ?x) (- (f k)) (/ 1 3))) (- 3 1)))"))
        << text;
}

TEST(Write, GivesVariablesThatHideOthersNewNames) {
    const LoadResult result = test::parse(
        domain("(:predicates (p ?x) (q ?x ?y))"
               "(:action go :parameters (?x) :precondition (exists (?x) (and (p ?x) (forall (?x) (p ?x))))"
               " :effect (when (p ?x) (forall (?x) (forall (?y) (q ?x ?y)))))"),
        problem("(:objects a) (:goal (and))"));
    const std::string text = write_domain(*result.task);
    EXPECT_TRUE(contains(text, "(exists (?x_2 - object) (and (p ?x_2) (forall (?x_3 - object) (p ?x_3))))"))
        << text;
    EXPECT_TRUE(contains(text, "(forall (?x_2 - object ?y - object) (when (p ?x) (q ?x_2 ?y)))")) << text;
    expect_round_trip(*result.task, "");
}

TEST(Write, ContingentTextsAreReadable) {
    const auto task =
        parse_belief(
            domain("(:types t) (:predicates (p ?x - t) (q ?x - t)) (:open-world p) (:decay p 2)"
                   "(:obs-variable (v ?x - t) (q ?x))"
                   "(:action look :parameters (?x - t) :observe (probabilistic 0.8 (p ?x))"
                   " :sensing-model (when (p ?x) (q ?x)) :effect (unknown (p ?x)))"
                   "(:sensor eye :parameters (?x - t) :condition (q ?x) :sense (p ?x))"),
            problem("(:objects a b - t) (:hidden-objects c - t) (:init (oneof (p a) (p b)) (not (q a)))"
                    "(:hidden (p a)) (:goal (q a))"))
            .task;
    EXPECT_EQ(write_contingent_domain(*task), R"((define (domain d)
  (:requirements :adl :contingent)
  (:types t - object)
  (:predicates
    (p ?x1 - t)
    (q ?x1 - t))
  (:open-world p)
  (:decay p 2)
  (:action look
    :parameters (?x - t)
    :effect (and
      (unknown (p ?x)))
    :observe
      (probabilistic 0.8 (p ?x))
    :sensing-model (and
      (when (p ?x) (q ?x))))
  (:sensor eye
    :parameters (?x - t)
    :condition (q ?x)
    :sense (p ?x))
)
)");
    EXPECT_EQ(write_contingent_problem(*task), R"((define (problem p)
  (:domain d)
  (:objects
    a b - t)
  (:hidden-objects
    c - t)
  (:obs-variable (v a) (q a))
  (:obs-variable (v b) (q b))
  (:obs-variable (v c) (q c))
  (:init
    (not (q a))
    (oneof (p a) (p b))
  )
  (:goal (q a))
  (:hidden (p a))
)
)");
}

}  // namespace
}  // namespace praxis
