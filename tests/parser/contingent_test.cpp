// Every construct of partially observable PDDL, and what it means.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/parser/contingent_texts.hpp"

namespace praxis {
namespace {

using test::contains;
using test::domain;
using test::parse_belief;
using test::problem;
using test::text_of;
using test::warnings_of;

const std::string kTypes =
    "(:types box lid) (:predicates (open ?l - lid) (in ?x - box ?l - lid) (full ?x - box) (ready))";
const std::string kObjects = "(:objects a b - box k l - lid)";

std::shared_ptr<const ContingentTask> from_domain(const std::string& sections) {
    return parse_belief(domain(kTypes + sections), problem(kObjects + "(:goal (ready))")).task;
}

std::shared_ptr<const ContingentTask> from_init(const std::string& facts, const std::string& sections = "") {
    return parse_belief(domain(kTypes),
                        problem(kObjects + "(:init " + facts + ") (:goal (ready)) " + sections))
        .task;
}

TEST(Contingent, AClassicalTaskIsOneWithoutUncertainty) {
    const auto task = from_init("(ready) (not (open k))");
    EXPECT_FALSE(task->contingent());
    EXPECT_EQ(text_of(*task, task->known_false), "(not (open k))");
    EXPECT_EQ(task->sensing.size(), task->task->schemas.size());
    EXPECT_TRUE(from_init("(unknown (ready))")->contingent());
    EXPECT_TRUE(from_init("(or (ready) (open k))")->contingent());
    EXPECT_TRUE(from_domain("(:action look :observe (ready))")->contingent());
    EXPECT_TRUE(from_domain("(:open-world open)")->contingent());
    EXPECT_TRUE(from_domain("(:action shake :effect (unknown (ready)))")->contingent());
}

TEST(Observe, TakesAtomsConjunctionsAndLists) {
    const auto task = from_domain(
        "(:action one :parameters (?l - lid) :precondition (ready) :observe (open ?l))"
        "(:action two :parameters (?l - lid) :observe (and (open ?l) (ready)) :effect (ready))"
        "(:action three :observe (open k) (full a) (ready))"
        "(:action none :effect (ready))");
    const LiftedTask& lifted = *task->task;
    ASSERT_EQ(task->sensing.size(), 4U);
    const Observation& first = task->sensing[0].observations.at(0);
    EXPECT_EQ(lifted.predicates[first.predicate.index()].name, "open");
    EXPECT_EQ(first.terms, std::vector<Term>{Term::variable(0)});
    EXPECT_EQ(first.condition.kind, Connective::truth);
    EXPECT_EQ(first.accuracy, 1);
    EXPECT_TRUE(lifted.schemas[0].effects.empty());
    EXPECT_EQ(task->sensing[1].observations.size(), 2U);
    EXPECT_EQ(lifted.schemas[1].effects.size(), 1U);
    EXPECT_EQ(task->sensing[2].observations.size(), 3U);
    EXPECT_TRUE(task->sensing[3].observations.empty());
    EXPECT_FALSE(task->sensing[0].own_model);
}

TEST(Observe, TakesProbabilitiesQuantifiersAndConditions) {
    const auto task = from_domain(
        "(:action look :observe (probabilistic 0.8 (ready))"
        "  (forall (?x - box) (when (full ?x) (and (in ?x k) (probabilistic 0.9 (in ?x l))))))");
    const std::vector<Observation>& observations = task->sensing[0].observations;
    ASSERT_EQ(observations.size(), 3U);
    EXPECT_EQ(observations[0].accuracy, 0.8);
    EXPECT_TRUE(observations[0].variables.empty());
    EXPECT_EQ(observations[1].variables, std::vector<std::uint32_t>{0});
    EXPECT_EQ(observations[1].condition.kind, Connective::atom);
    EXPECT_EQ(observations[1].accuracy, 1);
    EXPECT_EQ(observations[2].accuracy, 0.9);
}

TEST(Observe, MayReadDerivedPredicates) {
    const auto task =
        parse_belief(domain("(:predicates (p) (d)) (:derived (d) (p)) (:action a :observe (d))"),
                     problem("(:goal (d))"))
            .task;
    EXPECT_EQ(task->sensing[0].observations.size(), 1U);
}

TEST(InitialUncertainty, HasUnknownAtomsAndClauses) {
    const auto task = from_init(
        "(unknown (open k)) (unknown (not (open l))) (oneof (in a k) (in a l)) (or (full a) (not (full b)))"
        "(ready)");
    EXPECT_EQ(text_of(*task, task->unknown), "(open k) (open l)");
    ASSERT_EQ(task->clauses.size(), 2U);
    EXPECT_EQ(task->clauses[0].kind, ClauseKind::exactly_one);
    EXPECT_FALSE(task->clauses[0].invariant);
    EXPECT_EQ(text_of(*task, task->clauses[0].literals), "(in a k) (in a l)");
    EXPECT_EQ(task->clauses[1].kind, ClauseKind::at_least_one);
    EXPECT_FALSE(task->clauses[1].invariant);
    EXPECT_EQ(text_of(*task, task->clauses[1].literals), "(full a) (not (full b))");
    std::size_t certain = 0;
    for (const Relation& relation : task->task->initial_atoms) certain += relation.count;
    EXPECT_EQ(certain, 1U);
}

TEST(InitialUncertainty, HasInvariants) {
    const auto task = from_init(
        "(invariant (open k) (not (open k))) (at-least-one (full a) (full b)) (at-most-one (in a k) (in b k))"
        "(exactly-one (in a k) (in a l))");
    ASSERT_EQ(task->clauses.size(), 4U);
    const ClauseKind kinds[] = {ClauseKind::at_least_one, ClauseKind::at_least_one, ClauseKind::at_most_one,
                                ClauseKind::exactly_one};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_TRUE(task->clauses[i].invariant);
        EXPECT_EQ(task->clauses[i].kind, kinds[i]);
        EXPECT_EQ(task->clauses[i].literals.size(), 2U);
    }
    EXPECT_TRUE(task->clauses[0].literals[1].negated);
}

TEST(InitialUncertainty, MayBeWrappedRepeatedAndStatedTwice) {
    const auto task = from_init(
        "(and (ready) (unknown (open k)) (and (unknown (open k)) (ready)) (open k) (not (full a))"
        " (or (full a) (full b)))");
    EXPECT_EQ(text_of(*task, task->unknown), "(open k) (open k)");
    EXPECT_EQ(text_of(*task, task->known_false), "(not (full a))");
    EXPECT_EQ(task->clauses.size(), 1U);
    EXPECT_EQ(task->task->initial_atoms[0].count, 1U);  // stated, therefore certain
}

TEST(InitialUncertainty, PredicatesMayHaveItsWordsAsNames) {
    const auto task =
        parse_belief(domain("(:predicates (unknown ?x) (invariant) (p))"),
                     problem("(:objects a) (:init (unknown a) (invariant) (oneof (p) (unknown a)))"
                             "(:goal (p))"))
            .task;
    EXPECT_TRUE(task->unknown.empty());
    EXPECT_EQ(task->clauses.size(), 1U);
    EXPECT_EQ(task->task->initial_atoms[0].count, 1U);
    EXPECT_EQ(task->task->initial_atoms[1].count, 1U);
}

TEST(Sensor, FiresUnderItsCondition) {
    const auto task = from_domain(
        "(:sensor eye :parameters (?x - box ?l - lid) :condition (and (in ?x ?l) (open ?l)) :sense (full ?x))"
        "(:sensor ear :sense (and (ready) (open k)))"
        "(:sensor nose :sense (ready) (probabilistic 0.7 (open l)))");
    ASSERT_EQ(task->sensors.size(), 3U);
    EXPECT_EQ(task->sensors[0].name, "eye");
    EXPECT_EQ(task->sensors[0].scope.parameter_count, 2U);
    EXPECT_EQ(task->sensors[0].condition.children.size(), 2U);
    EXPECT_EQ(task->sensors[0].observations.size(), 1U);
    EXPECT_EQ(task->sensors[1].condition.kind, Connective::truth);
    EXPECT_EQ(task->sensors[1].observations.size(), 2U);
    EXPECT_EQ(task->sensors[2].observations.at(1).accuracy, 0.7);
}

TEST(HiddenWorlds, StandInTheProblemAndInFiles) {
    const auto task =
        parse_belief(
            domain(kTypes),
            problem(kObjects + "(:init (unknown (open k))) (:hidden (open k)) (:goal (ready)) (:hidden)"),
            {"(define (problem other) (:hidden (open k) (not (full a))))",
             "(define (problem p) (:domain d) (:hidden (and (open k))) (:hidden (full b)))"})
            .task;
    ASSERT_EQ(task->hidden.size(), 5U);
    EXPECT_EQ(text_of(*task, task->hidden[0].literals), "(open k)");
    EXPECT_TRUE(task->hidden[1].literals.empty());
    EXPECT_EQ(text_of(*task, task->hidden[2].literals), "(open k) (not (full a))");
    EXPECT_EQ(task->hidden[2].where.file, 2U);
    EXPECT_EQ(text_of(*task, task->hidden[4].literals), "(full b)");
    EXPECT_EQ(task->hidden[4].where.file, 3U);
}

TEST(Variables, AreMadeGround) {
    const auto task = from_init("(in a k) (in b k) (in b l)");
    const auto with = parse_belief(
        domain(kTypes + "(:variable where (ready) (forall (?x - box) (full ?x)))"
                        "(:variable (lids ?x - box) (forall (?l - lid) (when (in ?x ?l) (open ?l))))"
                        "(:obs-variable (seen ?l - lid) (open ?l))"),
        problem(kObjects + "(:init (in a k) (in b k) (in b l)) (:goal (ready))"));
    const std::vector<MultiValuedVariable>& variables = with.task->variables;
    ASSERT_EQ(variables.size(), 5U);
    EXPECT_EQ(variables[0].name, "where");
    EXPECT_EQ(text_of(*with.task, variables[0].values), "(ready) (full a) (full b)");
    EXPECT_FALSE(variables[0].observable);
    EXPECT_EQ(variables[1].name, "lids(a)");
    EXPECT_EQ(text_of(*with.task, variables[1].values), "(open k)");
    EXPECT_EQ(text_of(*with.task, variables[2].values), "(open k) (open l)");
    EXPECT_EQ(variables[3].name, "seen(k)");
    EXPECT_TRUE(variables[4].observable);
    EXPECT_TRUE(task->variables.empty());
}

TEST(Variables, MayHaveConditionsOfEveryKind) {
    const auto values = [](const std::string& condition) {
        const auto task = parse_belief(domain(kTypes + "(:variable v (forall (?x - box ?l - lid) (when " +
                                              condition + " (in ?x ?l))))"),
                                       problem(kObjects + "(:init (open k) (full a)) (:goal (ready))"))
                              .task;
        return task->variables.empty() ? "" : text_of(*task, task->variables[0].values);
    };
    EXPECT_EQ(values("(and (open ?l) (full ?x))"), "(in a k)");
    EXPECT_EQ(values("(or (not (open ?l)) (= ?x b))"), "(in a l) (in b k) (in b l)");
    EXPECT_EQ(values("(imply (full ?x) (open ?l))"), "(in a k) (in b k) (in b l)");
    EXPECT_EQ(values("(exists (?m - lid) (and (not (= ?m ?l)) (open ?m)))"), "(in a l) (in b l)");
    EXPECT_EQ(values("(forall (?y - box) (imply (full ?y) (= ?x ?y)))"), "(in a k) (in a l)");
    EXPECT_EQ(values("(or)"), "");
}

TEST(Variables, MayBeGroundInTheProblem) {
    const auto task =
        parse_belief(
            domain(kTypes +
                   "(:action look :sensing-model (and (full a) (open k))) (:constants a - box k - lid)"),
            problem(
                "(:objects l - lid) (:obs-variable (seen k a) (open k) (open l)) (:variable lonely (ready))"
                "(:goal (ready))"))
            .task;
    ASSERT_EQ(task->variables.size(), 2U);
    EXPECT_EQ(task->variables[0].name, "seen(k a)");
    EXPECT_EQ(text_of(*task, task->variables[0].values), "(open k) (open l)");
    EXPECT_EQ(task->variables[1].name, "lonely");
    EXPECT_EQ(task->sensing[0].model.size(), 1U);
    EXPECT_EQ(task->sensing[0].observations.size(), 1U);
}

TEST(SensingModel, HasRulesForObservablesAndReadsTheRest) {
    const auto task = from_domain(
        "(:obs-variable (seen ?l - lid) (open ?l))"
        "(:action look :parameters (?x - box) :sensing-model"
        "  (and (forall (?l - lid) (when (in ?x ?l) (open ?l))) (when (not (full ?x)) (not (open k))) (full "
        "?x)))"
        "(:action stay :effect (ready))"
        "(:default-sensing-model (and (when (ready) (open k)) (in a l)))");
    const SchemaSensing& look = task->sensing[0];
    EXPECT_TRUE(look.own_model);
    ASSERT_EQ(look.model.size(), 2U);
    EXPECT_EQ(look.model[0].variables.size(), 1U);
    EXPECT_TRUE(look.model[0].value);
    EXPECT_EQ(look.model[0].condition.kind, Connective::atom);
    EXPECT_FALSE(look.model[1].value);
    ASSERT_EQ(look.observations.size(), 1U);
    EXPECT_EQ(task->task->predicates[look.observations[0].predicate.index()].name, "full");
    EXPECT_FALSE(task->sensing[1].own_model);
    EXPECT_EQ(task->default_model.size(), 1U);
    EXPECT_EQ(task->default_observations.size(), 1U);
    EXPECT_EQ(task->default_scope.parameter_count, 0U);
}

TEST(Predicates, CanBeMarked) {
    const auto task = from_domain(
        "(:open-world open in) (:observable (full ?x) (forall (?l - lid) (open ?l))) (:sticky ready)"
        "(:decay full 3 open 10) (:decay ready 1)");
    EXPECT_EQ(task->open_world, (std::vector<bool>{true, true, false, false}));
    EXPECT_EQ(task->declared_observable, (std::vector<bool>{true, false, true, false}));
    EXPECT_EQ(task->sticky, (std::vector<bool>{false, false, false, true}));
    ASSERT_EQ(task->decays.size(), 3U);
    EXPECT_EQ(task->decays[1].steps, 10);
    EXPECT_EQ(task->task->predicates[task->decays[1].predicate.index()].name, "open");
}

TEST(Effects, CanLoseKnowledge) {
    const auto task = from_domain(
        "(:action shake :parameters (?x - box)"
        " :effect (and (ready) (forall (?l - lid) (when (full ?x) (unknown (in ?x ?l)))) (unknown (full a) "
        "(full b))))");
    const SchemaSensing& sensing = task->sensing[0];
    ASSERT_EQ(sensing.forgotten.size(), 3U);
    EXPECT_EQ(sensing.forgotten[0].variables.size(), 1U);
    EXPECT_EQ(sensing.forgotten[0].condition.kind, Connective::atom);
    EXPECT_EQ(task->task->schemas[0].effects.size(), 1U);
    EXPECT_TRUE(task->task->predicates[1].fluent);
    EXPECT_TRUE(task->task->predicates[2].fluent);
    EXPECT_FALSE(task->task->predicates[0].fluent);
}

TEST(Objects, CanBeHidden) {
    const auto task = parse_belief(domain(kTypes), problem("(:hidden-objects c - box m - lid)" + kObjects +
                                                           "(:init (full c)) (:goal (ready))"))
                          .task;
    ASSERT_EQ(task->hidden_objects.size(), 2U);
    EXPECT_EQ(task->task->objects[task->hidden_objects[0].index()].name, "c");
    EXPECT_EQ(task->task->objects.size(), 6U);
    EXPECT_EQ(task->task->objects[4].name, "c");
    EXPECT_EQ(task->task->initial_atoms[2].count, 1U);
}

TEST(Quirks, AreAccepted) {
    const std::string untyped =
        "(define (domain d) (:types ILLNESS) (:predicates (ill ?i) (dry) (at ?i - illness))"
        "(:objects i0 i1 - ILLNESS) (:action go :precondition (at i0) :effect (when (at i0) (ill i0)))"
        "(:action come :parameters (?x) :precondition (at ?x) :observe (ill ?x)))";
    const auto result = parse_belief(untyped,
                                     "(define (problem x) (:domain other) (:constants i2 - illness)"
                                     "(:init (and (at i2) (oneof (ill i0) (ill i1))))"
                                     "(:goal (forall (?i - illness) (not (ill ?i)))))");
    EXPECT_EQ(result.task->task->objects.size(), 3U);
    EXPECT_TRUE(contains(warnings_of(result), "':objects' belongs into the problem"));
    EXPECT_TRUE(contains(warnings_of(result), "':constants' belongs into the domain"));
    const auto by_use =
        parse_belief("(define (domain d) (:constants a - t) (:predicates (p ?x - u) (q ?x - t)))",
                     "(define (problem p) (:domain d) (:init (unknown (q a))) (:goal (q a)))");
    EXPECT_TRUE(contains(warnings_of(by_use), "type 'u' is used but not declared"));
    EXPECT_EQ(by_use.task->task->types.size(), 3U);
    const std::string trucks =
        "(define (domain d) (:types truck) (:predicates (p)) (:action a :parameters (?x - ";
    const std::string goal = "(define (problem p) (:domain d) (:objects k - depot) (:goal (p)))";
    EXPECT_EQ(parse_belief(trucks + "depot)))", goal).task->task->types.size(), 3U);
    EXPECT_TRUE(contains(test::belief_error(trucks + "trukc)))", goal), "unknown type 'trukc'"));
}

TEST(Quirks, ASecondDefineIsTakenAsOneWithTheFirst) {
    const std::string text = "(:predicates (p)) (:action a :observe (p))";
    const std::string goal = "(define (problem p) (:domain d) (:goal (p)))";
    for (const std::string closing : {")", "))"}) {
        const auto result = parse_belief("(define (domain d) (define (domain d) " + text + closing, goal);
        EXPECT_EQ(result.task->sensing.size(), 1U) << closing;
        EXPECT_TRUE(contains(warnings_of(result), "1:20: warning: a second 'define'"));
    }
    EXPECT_TRUE(
        contains(test::belief_error("(define (domain d) " + text, goal), "found the end of the file"));
    EXPECT_TRUE(contains(test::belief_error("(define (domain d) (define (domain d) " + text + ")))", goal),
                         "text after the end of the domain"));
}

TEST(Quirks, RequirementsOfContingentPlanningAreKnown) {
    const auto result = parse_belief(
        "(define (domain d) (:requirements :strips :contingent :partial-observability) (:predicates (p)))",
        "(define (problem p) (:domain d) (:goal (p)))");
    EXPECT_EQ(warnings_of(result), "");
}

TEST(LoadContingent, ReadsFiles) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "praxis_contingent";
    std::filesystem::create_directories(folder);
    const auto write = [&](const char* name, const std::string& text) {
        std::ofstream(folder / name) << text;
        return (folder / name).string();
    };
    const std::string domain_file = write("d.pddl", domain(kTypes));
    const std::string problem_file =
        write("p.pddl", problem(kObjects + "(:init (unknown (ready))) (:goal (ready))"));
    const std::string world_file = write("w.pddl", "(define (problem w) (:hidden (ready)))");
    const ContingentLoadResult result = load_contingent(domain_file, problem_file, {world_file, world_file});
    EXPECT_EQ(result.task->hidden.size(), 2U);
    EXPECT_EQ(result.task->task->sources->files.size(), 4U);
    EXPECT_THROW(load_contingent(domain_file, problem_file, {world_file + "x"}), InputError);
    EXPECT_THROW(load_contingent("-", problem_file, {"-"}), InputError);
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace praxis
