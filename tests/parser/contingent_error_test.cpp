// What is said about wrong contingent tasks, and how a classical task refuses what it cannot have.
#include <gtest/gtest.h>

#include "tests/parser/contingent_texts.hpp"

namespace praxis {
namespace {

using test::belief_error;
using test::contains;
using test::domain;
using test::empty_problem;
using test::error_of;
using test::is_unsupported;
using test::parse_belief;
using test::problem;
using test::warnings_of;

const std::string kPredicates = "(:types t) (:predicates (p ?x - t) (q) (d)) (:derived (d) (q))";

std::string in_domain(const std::string& sections) {
    return belief_error(domain(kPredicates + sections), empty_problem());
}

std::string in_problem(const std::string& sections) {
    return belief_error(domain(kPredicates), problem("(:objects a b - t c) " + sections + " (:goal (q))"));
}

TEST(ContingentErrors, AreShownWithTheirPlace) {
    EXPECT_EQ(belief_error("(define (domain d) (:predicates (light ?x))\n(:sensor eye :sense (lihgt k)))",
                           "(define (problem p) (:domain d) (:objects k)\n(:init (unknown (light j) (light "
                           "k))) (:goal (light k)))",
                           {"(define (problem p)\n  (:hidden (light k) (dark k)))"}),
              "domain.pddl:2:22: error: unknown predicate 'lihgt'\n"
              "  2 | (:sensor eye :sense (lihgt k)))\n"
              "    |                      ^~~~~ did you mean 'light'?\n"
              "problem.pddl:2:24: error: unknown object 'j'\n"
              "  2 | (:init (unknown (light j) (light k))) (:goal (light k)))\n"
              "    |                        ^\n"
              "world.pddl:2:23: error: unknown predicate 'dark'\n"
              "  2 |   (:hidden (light k) (dark k)))\n"
              "    |                       ^~~~\n");
}

TEST(ContingentErrors, OfObservations) {
    EXPECT_TRUE(contains(in_domain("(:action a :observe (p ?y))"), "unbound variable '?y'"));
    EXPECT_TRUE(contains(in_domain("(:action a :observe (q q))"), "'q' takes no arguments, not 1"));
    EXPECT_TRUE(contains(in_domain("(:action a :observe (or (q) (d)))"), "'or' cannot be sensed"));
    EXPECT_TRUE(contains(in_domain("(:action a :observe (not (and (q))))"), "only an atom can be sensed"));
    EXPECT_TRUE(contains(in_domain("(:action a :observe)"), "expected '(', found ')'"));
    EXPECT_TRUE(contains(in_domain("(:action a :observe (probabilistic 1.5 (q)))"),
                         "expected a probability in (0, 1], found '1.5'"));
    EXPECT_TRUE(contains(in_domain("(:action a :observe (probabilistic 0 (q)))"), "expected a probability"));
    EXPECT_TRUE(
        contains(in_domain("(:action a :observe (probabilistic nan (q)))"), "expected a probability"));
    EXPECT_TRUE(
        contains(in_domain("(:action a :observe (probabilistic x0.5 (q)))"), "expected a probability"));
    EXPECT_TRUE(contains(in_domain("(:action a :observe (probabilistic (q)))"),
                         "expected (probabilistic NUMBER LITERAL)"));
    EXPECT_TRUE(contains(in_domain("(:action a :observe (probabilistic 0.5 (q) (q)))"),
                         "expected (probabilistic NUMBER LITERAL)"));
    EXPECT_TRUE(contains(in_domain("(:action a :sensing-model (probabilistic 0.5 (q)))"),
                         "probabilities in sensing models are not supported"));
    EXPECT_TRUE(contains(in_domain("(:action a :effect (oneof (q) (not (q))))"),
                         "nondeterministic effects are not supported"));
    EXPECT_TRUE(contains(in_domain("(:action a :precondition (unknown (q)))"),
                         "conditions and effects on knowledge are not supported"));
    EXPECT_TRUE(
        contains(in_domain("(:action a :effect (unknown (and (q))))"), "only an atom can become unknown"));
    EXPECT_TRUE(
        contains(in_domain("(:action a :effect (unknown (d)))"), "an effect on the derived predicate 'd'"));
}

TEST(ContingentErrors, OfSensors) {
    EXPECT_TRUE(contains(in_domain("(:sensor s :condition (q))"), "a sensor without ':sense'"));
    EXPECT_TRUE(contains(in_domain("(:sensor s :sense (q)) (:sensor S :sense (q))"), "duplicate sensor 'S'"));
    EXPECT_TRUE(contains(in_domain("(:sensor s :condition (q) :condition (q) :sense (q))"),
                         "a sensor has one condition"));
    EXPECT_TRUE(contains(in_domain("(:sensor s :precondition (q))"),
                         "expected ':parameters', ':condition', ':sense' or ')', found ':precondition'"));
    EXPECT_TRUE(contains(in_domain("(:sensr s :sense (q))"), "did you mean ':sensor'?"));
}

TEST(ContingentErrors, OfTheInitialState) {
    EXPECT_TRUE(contains(in_problem("(:init (oneof (p a) b))"), "expected a literal, found 'b'"));
    EXPECT_TRUE(contains(in_problem("(:init (unknown (p a) b))"), "expected a literal, found 'b'"));
    EXPECT_TRUE(contains(in_problem("(:init (oneof (and (p a) (q)) (p b)))"), "expected a literal"));
    EXPECT_TRUE(contains(in_problem("(:init (or))"), "an empty 'or' cannot hold"));
    EXPECT_TRUE(contains(in_problem("(:init (oneof))"), "an empty 'oneof' cannot hold"));
    EXPECT_EQ(in_problem("(:init (at-most-one))"), "");
    EXPECT_TRUE(contains(in_problem("(:init (unknown (d)))"), "the derived predicate 'd' cannot stand in"));
    EXPECT_TRUE(
        contains(in_problem("(:init (unknown (p c)))"), "'c' is of type 'object'; 't' is wanted here"));
    EXPECT_TRUE(contains(in_problem("(:init (q) (not (q)))"), "contains this atom and its negation"));
    EXPECT_TRUE(contains(in_problem("(:init (forall (?x - t) (p ?x)))"), "'forall' cannot stand in"));
    EXPECT_TRUE(contains(in_problem("(:init (oneo (p a) (p b)))"), "unknown predicate 'oneo'"));
}

TEST(ContingentErrors, OfVariables) {
    EXPECT_TRUE(contains(in_domain("(:variable v (not (q)))"), "the values of a variable are atoms"));
    EXPECT_TRUE(contains(in_domain("(:variable v (d))"), "cannot be a value of a variable"));
    EXPECT_TRUE(contains(in_domain("(:variable v (when (q) (q))) (:action a :effect (q))"),
                         "the values of a variable cannot depend on what changes"));
    EXPECT_TRUE(contains(in_domain("(:variable (v ?x - t ?x - t) (q))"), "duplicate variable '?x'"));
    EXPECT_TRUE(contains(in_problem("(:variable (v nix) (q))"), "unknown object 'nix'"));
    std::string many = "(:objects";
    for (std::size_t i = 0; i < 300; ++i) many += " o" + std::to_string(i);
    EXPECT_TRUE(contains(
        belief_error(
            domain("(:predicates (p ?x ?y ?z)) (:variable v (forall (?x ?y ?z) (when (or) (p ?x ?y ?z))))"),
            problem(many + ") (:goal (and))")),
        "too many values of this variable"));
}

TEST(ContingentErrors, OfMarks) {
    EXPECT_TRUE(contains(in_domain("(:open-world r)"), "unknown predicate 'r'"));
    EXPECT_TRUE(contains(in_domain("(:open-world d)"), "the derived predicate 'd' cannot be open"));
    EXPECT_TRUE(contains(in_domain("(:sticky (not (q)))"), "expected a predicate"));
    EXPECT_TRUE(contains(in_domain("(:decay q 0)"), "expected a number of steps, at least 1, found '0'"));
    EXPECT_TRUE(contains(in_domain("(:decay q 2.5)"), "expected a number of steps"));
    EXPECT_TRUE(contains(in_domain("(:decay q 2 q 3)"), "a second ':decay' of 'q'"));
    EXPECT_TRUE(contains(in_domain("(:decay q)"), "expected"));
    EXPECT_TRUE(contains(in_problem("(:hidden-objects a - t)"), "duplicate object 'a'"));
    EXPECT_TRUE(contains(in_problem("(:open-world q)"), "a problem has no section ':open-world'"));
}

TEST(ContingentWarnings, OfWorldsThatDoNotFitTheInitialState) {
    const auto said = [](const std::string& init, const std::string& world) {
        const std::string sections =
            kPredicates + "(:predicates (r ?x - t)) (:open-world r) (:variable v (p c))";
        return warnings_of(parse_belief(domain("(:constants a b c - t)" + sections),
                                        problem("(:init " + init + ") (:hidden " + world + ") (:goal (q))")));
    };
    EXPECT_TRUE(contains(said("(not (p a))", "(p a)"), "the initial state says the opposite"));
    EXPECT_TRUE(contains(said("(p a)", "(not (p a))"), "the initial state says the opposite"));
    EXPECT_TRUE(contains(said("(p b)", "(p a)"), "nothing in ':init' says that this may be true"));
    EXPECT_EQ(said("(p a) (not (q)) (unknown (p b))", "(p a) (p b) (not (q)) (r a) (p c)"), "");
    EXPECT_EQ(said("(oneof (p a) (not (p b)))", "(p a) (p b)"), "");
}

TEST(ContingentErrors, OfWorldFiles) {
    const auto result = parse_belief(domain(kPredicates), problem("(:goal (q))"),
                                     {"(define (problem w) (:init (q)) (:hidden-objects a))"});
    EXPECT_TRUE(contains(warnings_of(result), "a world file has only ':hidden' sections"));
    EXPECT_TRUE(contains(warnings_of(result), "there is no ':hidden' section in this world file"));
    EXPECT_TRUE(
        contains(belief_error(domain(kPredicates), problem("(:goal (q))"), {" \n"}), "world.pddl: is empty"));
    EXPECT_TRUE(contains(belief_error(domain(kPredicates), problem("(:goal (q))"), {"(define (domain x))"}),
                         "world.pddl:1:10: error: expected 'problem', found 'domain'"));
}

TEST(ClassicalTask, RefusesWhatIsContingent) {
    const std::pair<const char*, const char*> kSections[] = {
        {"(:action a :observe (q))", "sensing actions are not supported"},
        {"(:action a :sensing-model (q))", "sensing actions are not supported"},
        {"(:default-sensing-model (q))", "sensing actions are not supported"},
        {"(:sensor s :sense (q))", "sensors are not supported"},
        {"(:variable v (q))", "multi-valued variables are not supported"},
        {"(:obs-variable v (q))", "multi-valued variables are not supported"},
        {"(:open-world q)", "partially observable predicates are not supported"},
        {"(:decay q 3)", "partially observable predicates are not supported"},
        {"(:action a :effect (unknown (q)))", "conditions and effects on knowledge are not supported"},
    };
    for (const auto& [section, message] : kSections) {
        const std::string text = domain(kPredicates + section);
        EXPECT_TRUE(is_unsupported(text, empty_problem())) << section;
        EXPECT_TRUE(contains(error_of(text, empty_problem()), message)) << section;
        EXPECT_TRUE(contains(error_of(text, empty_problem()), "'plan belief' plans such tasks")) << section;
    }
    const std::pair<const char*, const char*> kProblems[] = {
        {"(:init (unknown (q)))", "uncertain initial states are not supported"},
        {"(:init (oneof (q) (not (q))))", "uncertain initial states are not supported"},
        {"(:init (or (q)))", "uncertain initial states are not supported"},
        {"(:init (invariant))", "uncertain initial states are not supported"},
        {"(:hidden (q))", "hidden worlds are not supported"},
        {"(:hidden-objects o)", "hidden objects are not supported"},
    };
    for (const auto& [section, message] : kProblems) {
        const std::string text = problem(std::string(section) + "(:goal (q))");
        EXPECT_TRUE(is_unsupported(domain(kPredicates), text)) << section;
        EXPECT_TRUE(contains(error_of(domain(kPredicates), text), message)) << section;
    }
}

TEST(ClassicalTask, KeepsObjectsInTheProblemAndConstantsInTheDomain) {
    EXPECT_TRUE(
        contains(error_of(domain("(:objects a)"), empty_problem()), "a domain has no section ':objects'"));
    EXPECT_TRUE(
        contains(error_of(domain(""), problem("(:constants a) (:goal ())")), "it belongs into the domain"));
    EXPECT_TRUE(contains(error_of(domain("(:constants a - t)"), empty_problem()), "unknown type 't'"));
}

}  // namespace
}  // namespace praxis
