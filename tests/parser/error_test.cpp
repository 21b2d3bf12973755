// What is said about wrong input.
#include <gtest/gtest.h>

#include "tests/parser/texts.hpp"

namespace praxis {
namespace {

using test::contains;
using test::domain;
using test::empty_problem;
using test::error_of;
using test::is_unsupported;
using test::parse;
using test::problem;
using test::warnings_of;

/// The message of an error in a domain with these sections (the second line of the file on).
std::string in_domain(const std::string& sections) {
    return error_of(domain(sections), empty_problem());
}

std::string in_problem(const std::string& sections) {
    static const std::string kDomain = domain(
        "(:types truck depot - place) (:predicates (at ?t - truck ?d - depot) (d ?x) (s)) "
        "(:functions (f ?x) - number (g) - place)"
        "(:derived (d ?x) (s))");
    return error_of(kDomain, problem(sections));
}

TEST(Names, UnknownObjectsAreShownWithTheNearest) {
    EXPECT_EQ(
        in_problem(
            "(:objects truck0 truck1 - truck\n\tdepot0 - depot)\n(:init\n\t(at truck9 depot0)) (:goal ())"),
        "domain.pddl:2:23: warning: type 'place' is used but not declared\n"
        "  2 | (:types truck depot - place) (:predicates (at ?t - truck ?d - depot) (d ?x) (s)) (:functions "
        "(f ?x) "
        "...\n"
        "    |                       ^~~~~ taken as a subtype of 'object'\n"
        "problem.pddl:5:6: error: unknown object 'truck9'\n"
        "  5 |         (at truck9 depot0)) (:goal ()))\n"
        "    |             ^~~~~~ did you mean 'truck0'?\n");
}

TEST(Names, OfEveryKindMustBeKnown) {
    EXPECT_EQ(in_domain("(:predicates (light ?x)) (:action a :precondition (ligth k))"),
              "domain.pddl:2:52: error: unknown predicate 'ligth'\n"
              "  2 | (:predicates (light ?x)) (:action a :precondition (ligth k)))\n"
              "    |                                                    ^~~~~ did you mean 'light'?\n");
    EXPECT_TRUE(contains(in_domain("(:constants k - Trukc) (:types truck)"),
                         "error: unknown type 'Trukc'\n"
                         "  2 | (:constants k - Trukc) (:types truck))\n"
                         "    |                 ^~~~~ did you mean 'truck'?"));
    EXPECT_TRUE(contains(in_domain("(:predicates (p ?x - nix))"), "unknown type 'nix'"));
    EXPECT_TRUE(contains(
        in_domain("(:functions (fuel) (total-cost)) (:action a :effect (increase (total-cost) (fule)))"),
        "unknown function 'fule'"));
    EXPECT_TRUE(
        contains(in_domain("(:predicates (p ?x)) (:action a :parameters (?truck) :effect (p ?trukc))"),
                 "^~~~~~ did you mean '?truck'?"));
    EXPECT_TRUE(contains(in_domain("(:predicates (p ?x)) (:action a :parameters (?x) :effect (p x))"),
                         "unknown object 'x'"));
    EXPECT_TRUE(contains(in_domain("(:predicates (p ?x)) (:action a :parameters (?x) :effect (p x))"),
                         "did you mean '?x'?"));
    EXPECT_TRUE(contains(in_domain("(:functions (f)) (:action a :precondition (f))"),
                         "'f' is a function, not a predicate"));
}

TEST(Names, MustNotBeDeclaredTwice) {
    EXPECT_TRUE(contains(in_domain("(:predicates (p) (P ?x))"), "2:19: error: duplicate predicate 'P'"));
    EXPECT_TRUE(contains(in_domain("(:functions (f) (f))"), "duplicate function 'f'"));
    EXPECT_TRUE(contains(in_domain("(:action a) (:action A)"), "2:22: error: duplicate action 'A'"));
    EXPECT_TRUE(contains(in_domain("(:action a :parameters (?x ?y ?X))"), "duplicate variable '?X'"));
    EXPECT_TRUE(
        contains(in_domain("(:action a :precondition (exists (?x ?x) (and)))"), "duplicate variable '?x'"));
    EXPECT_TRUE(contains(in_problem("(:objects a b a) (:goal ())"),
                         "problem.pddl:2:15: error: duplicate object 'a'"));
    EXPECT_TRUE(
        contains(error_of(domain("(:types s t) (:constants k - s)"), problem("(:objects k - t) (:goal ())")),
                 "object 'k' is a constant of another type in the domain"));
    EXPECT_TRUE(contains(in_domain("(:predicates (and ?x))"), "a predicate cannot be called 'and'"));
}

TEST(Types, MustNotBeCyclic) {
    EXPECT_EQ(in_domain("(:types a - b b - c c - a d)"),
              "domain.pddl:2:9: error: cyclic types: 'a', 'b', 'c' are supertypes of each other\n"
              "  2 | (:types a - b b - c c - a d))\n"
              "    |         ^\n");
    EXPECT_TRUE(contains(in_domain("(:types a - a)"), "cyclic types: 'a' is its own supertype"));
}

TEST(Arguments, MustFitInNumber) {
    EXPECT_EQ(
        in_domain("(:types t) (:predicates (p ?a ?b - t)) (:action a :parameters (?x - t) :effect (p ?x))"),
        "domain.pddl:2:80: error: predicate 'p' takes 2 arguments, not 1\n"
        "  2 | (:types t) (:predicates (p ?a ?b - t)) (:action a :parameters (?x - t) :effect (p ?x)))\n"
        "    |                                                                                ^~~~~~ of "
        "types t t\n");
    EXPECT_TRUE(contains(in_problem("(:init (s s)) (:goal ())"), "predicate 's' takes no arguments, not 1"));
    EXPECT_TRUE(
        contains(in_domain("(:predicates (p ?x)) (:derived (p) (and))"), "has 1 parameters, its axiom 0"));
    EXPECT_TRUE(contains(in_problem("(:init (= (f) 1)) (:goal ())"), "function 'f' takes 1 argument, not 0"));
}

TEST(Arguments, MustFitInType) {
    EXPECT_TRUE(contains(in_problem("(:objects t - truck d - depot) (:init (at d t)) (:goal ())"),
                         "'d' is of type 'depot'; 'truck' is wanted here"));
    EXPECT_TRUE(contains(error_of(domain("(:types t u) (:predicates (p ?x - t))"
                                         "(:action a :parameters (?x - u) :effect (p ?x))"),
                                  problem("(:objects x - t y - u) (:goal ())")),
                         "'?x' is of type 'u'; 't' is wanted here"));
}

TEST(Arguments, OfAWiderTypeAreOnlyWarnedOf) {
    const LoadResult result =
        parse(domain("(:types t) (:predicates (p ?x - t)) (:action a :parameters (?x) :effect (p ?x))"),
              empty_problem());
    EXPECT_TRUE(contains(warnings_of(result), "'?x' is of type 'object'; 't' is wanted here"));
}

TEST(Effects, AreRestricted) {
    EXPECT_TRUE(contains(in_domain("(:predicates (p)) (:derived (p) (and)) (:action a :effect (p))"),
                         "an effect on the derived predicate 'p'"));
    EXPECT_TRUE(contains(in_domain("(:predicates (p)) (:action a :effect (or (p) (p)))"),
                         "'or' cannot stand in an effect"));
    EXPECT_TRUE(contains(in_domain("(:predicates (p)) (:action a :effect (not (and (p))))"),
                         "only an atom can be deleted"));
    EXPECT_TRUE(contains(in_domain("(:predicates (p)) (:action a :precondition (when (p) (p)))"),
                         "'when' cannot stand in a condition"));
}

TEST(Effects, ThatWouldFillTheMemoryAreRefused) {
    std::string atoms;
    for (int i = 0; i < 4000; ++i) atoms += "(p)";
    EXPECT_TRUE(contains(
        in_domain("(:predicates (p)) (:action a :effect (when (and " + atoms + ") (and " + atoms + ")))"),
        "conditional effects too large"));
}

TEST(InitialState, IsChecked) {
    EXPECT_TRUE(
        contains(in_problem("(:init (not (s)) (s)) (:goal ())"), "contains this atom and its negation"));
    EXPECT_TRUE(contains(in_problem("(:objects x) (:init (d x)) (:goal ())"),
                         "the derived predicate 'd' cannot stand in the initial state"));
    EXPECT_TRUE(contains(in_problem("(:objects x) (:init (= (f x) 1.0) (= (f x) 1) (= (f x) 2)) (:goal ())"),
                         "2:56: error: a second value for the same function"));
    EXPECT_TRUE(contains(in_problem("(:objects x) (:init (= (f x) x)) (:goal ())"), "expected a number"));
    EXPECT_TRUE(
        contains(in_problem("(:init (or (s))) (:goal ())"), "uncertain initial states are not supported"));
}

TEST(Goal, MustBeThereOnce) {
    EXPECT_TRUE(contains(in_problem(""), "problem.pddl:1:18: error: the problem has no ':goal'"));
    EXPECT_TRUE(contains(in_problem("(:goal ()) (:goal ())"), "a second goal"));
}

TEST(Goal, ThatIsStaticAndFalseIsWarnedOf) {
    const LoadResult result =
        parse(domain("(:predicates (p ?x) (q))"),
              problem("(:objects a b) (:init (p a) (q)) (:goal (and (p a) (p b) (not (q))))"));
    EXPECT_EQ(
        warnings_of(result),
        "problem.pddl:2:52: warning: the goal cannot be reached: (p b) is false and no action changes it\n"
        "  2 | (:objects a b) (:init (p a) (q)) (:goal (and (p a) (p b) (not (q)))))\n"
        "    |                                                    ^~~~~\n"
        "problem.pddl:2:63: warning: the goal cannot be reached: (q) is true and no action changes it\n"
        "  2 | (:objects a b) (:init (p a) (q)) (:goal (and (p a) (p b) (not (q)))))\n"
        "    |                                                               ^~~\n");
}

TEST(Requirements, AreWarnedOfOnceEach) {
    const LoadResult result = parse(
        "(define (domain d) (:requirements :strisp)\n (:types t) (:predicates (p ?x - t))\n"
        " (:action a :parameters (?x - t) :precondition (not (p ?x)) :effect (p ?x))\n"
        " (:action b :parameters (?x - t) :precondition (not (p ?x)) :effect (p ?x)))",
        empty_problem());
    EXPECT_EQ(
        warnings_of(result),
        "domain.pddl:1:35: warning: unknown requirement ':strisp'\n"
        "  1 | (define (domain d) (:requirements :strisp)\n"
        "    |                                   ^~~~~~~ did you mean ':strips'?\n"
        "domain.pddl:2:10: warning: this needs ':typing', which is missing in :requirements\n"
        "  2 |  (:types t) (:predicates (p ?x - t))\n"
        "    |          ^\n"
        "domain.pddl:3:49: warning: this needs ':negative-preconditions', which is missing in :requirements\n"
        "  3 |  (:action a :parameters (?x - t) :precondition (not (p ?x)) :effect (p ?x))\n"
        "    |                                                 ^~~\n");
}

TEST(Problem, ForAnotherDomainIsWarnedOf) {
    const LoadResult result = parse(domain(""), "(define (problem p) (:domain other) (:goal ()))");
    EXPECT_TRUE(contains(warnings_of(result), "the problem is for the domain 'other', not for 'd'"));
}

TEST(Syntax, SaysWhatWasExpected) {
    EXPECT_EQ(in_domain("(:action a :precondition (and (p) q))"),
              "domain.pddl:2:35: error: expected '(' or ')', found 'q'\n"
              "  2 | (:action a :precondition (and (p) q)))\n"
              "    |                                   ^\n");
    EXPECT_TRUE(contains(in_domain("(:action a :parameters (x))"), "expected a variable or ')', found 'x'"));
    EXPECT_TRUE(contains(in_domain("(:action a :paramters ())"),
                         "expected ':parameters', ':precondition', ':effect' or ')', found ':paramters'"));
    EXPECT_TRUE(contains(in_domain("(:types a - )"), "expected a type, found ')'"));
    EXPECT_TRUE(contains(in_domain("(:action a :precondition (p) :precondition (p))"),
                         "an action has one precondition and one effect"));
    EXPECT_TRUE(contains(in_domain("(:action)"), "expected a name, found ')'"));
    EXPECT_TRUE(contains(in_domain("(:action a :precondition (imply (p)))"), "expected '(', found ')'"));
    EXPECT_TRUE(contains(in_domain("(:action a :precondition (= 1))"),
                         "expected a name, a variable, a number or '(', found ')'"));
    EXPECT_TRUE(contains(in_domain("(:action a :precondition (5 ?x"), "found the end of the file"));
}

TEST(Syntax, UnknownSectionsAreNamed) {
    EXPECT_EQ(in_domain("(:predicate (p))"),
              "domain.pddl:2:2: error: a domain has no section ':predicate'\n"
              "  2 | (:predicate (p)))\n"
              "    |  ^~~~~~~~~~ did you mean ':predicates'?\n");
    EXPECT_TRUE(contains(in_domain("(:init)"), "it belongs into the problem"));
    EXPECT_TRUE(contains(in_problem("(:action a) (:goal ())"), "it belongs into the domain"));
}

TEST(Syntax, SwappedFilesAreNoticed) {
    EXPECT_EQ(error_of(empty_problem(), domain("")),
              "domain.pddl:1:10: error: expected 'domain', found 'problem'\n"
              "  1 | (define (problem p) (:domain d)\n"
              "    |          ^~~~~~~ this is a problem; the domain's file comes first\n"
              "problem.pddl:1:10: error: expected 'problem', found 'domain'\n"
              "  1 | (define (domain d) (:requirements :adl :derived-predicates :action-costs)\n"
              "    |          ^~~~~~ this is a domain; the problem's file comes second\n");
}

TEST(Syntax, UnbalancedParenthesesAreExplained) {
    EXPECT_EQ(error_of("(define (domain d)\n (:predicates (p)\n\n", empty_problem()),
              "domain.pddl:2:18: error: expected '(' or ')', found the end of the file\n"
              "  2 |  (:predicates (p)\n"
              "    |                  ^ is a ')' missing? This part starts in line 2\n");
    EXPECT_TRUE(contains(error_of("(define (domain d) (:predicates (p)", empty_problem()),
                         "found the end of the file"));
    EXPECT_TRUE(contains(error_of("(define (domain d) (:predicates (p))", empty_problem()),
                         "expected a section or ')', found the end of the file"));
    EXPECT_TRUE(
        contains(error_of(domain(")(:types a)"), empty_problem()), "text after the end of the domain"));
}

TEST(Syntax, ErrorsInSeveralSectionsAreFoundInOneRun) {
    const std::string text =
        in_domain("(:types a -)\n(:action b :parameters ()\n(:action c :effect)\n(:predicates p)");
    EXPECT_TRUE(contains(text, "domain.pddl:2:12: error: expected a type, found ')'"));
    EXPECT_TRUE(contains(text, "domain.pddl:4:1: error: expected ':parameters'"));
    EXPECT_TRUE(contains(text, "domain.pddl:4:19: error: expected '(', found ')'"));
    EXPECT_TRUE(contains(text, "domain.pddl:5:14: error: expected '(' or ')', found 'p'"));
}

TEST(Syntax, ErrorsComeInOrderAndAreCapped) {
    std::string atoms;
    for (int i = 0; i < 50; ++i) atoms += "(nix)\n";
    const std::string text = in_problem("(:init\n" + atoms + ") (:goal (nix))");
    EXPECT_TRUE(contains(text, "problem.pddl:22:2: error: unknown predicate 'nix'"));
    EXPECT_FALSE(contains(text, "problem.pddl:23:2"));
    EXPECT_TRUE(text.ends_with("... and 31 more\n"));
    EXPECT_LT(text.find("problem.pddl:3:2"), text.find("problem.pddl:4:2"));
}

TEST(Limits, DepthIsBounded) {
    for (const std::string unit : {"(", "(and ", "(not ", "(exists (?x) ", "(when (p) ", "(p "}) {
        std::string deep = "(:action a :effect ";
        while (deep.size() < (std::size_t{1} << 20)) deep += unit;
        EXPECT_TRUE(contains(in_domain(deep), "error: ")) << unit;
    }
    std::string line(std::size_t{1} << 20, '(');
    EXPECT_TRUE(contains(error_of(line, line), "expected 'define', found '('"));
    EXPECT_TRUE(contains(in_domain("(:durative-action " + line), "nested more than 400 deep"));
    std::string nested = "(p)";
    for (int i = 0; i < 399; ++i) nested = "(not " + nested + ")";
    EXPECT_EQ(in_domain("(:predicates (p)) (:action a :precondition " + nested + ")"), "");
    EXPECT_TRUE(contains(in_domain("(:predicates (p)) (:action a :precondition (not " + nested + "))"),
                         "lists nested more than 400 deep"));
}

TEST(Limits, BytesThatAreNoTextAreNamed) {
    EXPECT_TRUE(contains(in_domain(std::string("(:types a\0b)", 12)),
                         "expected a name, '- TYPE' or ')', found the byte 0x00"));
    EXPECT_TRUE(contains(in_domain("(:types a\xFF"
                                   "b)"),
                         "text that is not UTF-8"));
    EXPECT_EQ(in_domain("(:types \xC3\xA4) ; \xFF in a comment\n"), "");
    EXPECT_TRUE(contains(error_of("", empty_problem()), "domain.pddl: is empty"));
    EXPECT_TRUE(contains(error_of(domain(""), " \n"), "problem.pddl: is empty"));
}

struct Refused {
    const char* domain;
    const char* problem;
    const char* message;
};

class Unsupported : public testing::TestWithParam<Refused> {};

TEST_P(Unsupported, IsRefusedByName) {
    const std::string domain_text =
        domain("(:types t) (:predicates (p) (q ?x)) (:functions (total-cost) (f ?x) - number (g) - t)\n" +
               std::string(GetParam().domain));
    const std::string problem_text = problem("(:objects o - t)\n" + std::string(GetParam().problem));
    EXPECT_TRUE(is_unsupported(domain_text, problem_text));
    EXPECT_TRUE(contains(error_of(domain_text, problem_text), GetParam().message))
        << error_of(domain_text, problem_text);
}

INSTANTIATE_TEST_SUITE_P(
    Constructs, Unsupported,
    testing::Values(
        Refused{"(:durative-action a :parameters (?x) :duration (= ?duration 3) :condition (at start (p)) "
                ":effect (and))",
                "(:goal ())", "domain.pddl:3:2: unsupported: durative actions are not supported"},
        Refused{"(:constraints (always (p)))", "(:goal ())",
                "domain.pddl:3:2: unsupported: trajectory constraints"},
        Refused{"", "(:goal ()) (:constraints (sometime (p)))",
                "problem.pddl:3:13: unsupported: trajectory constraints"},
        Refused{"", "(:init (at 5 (p))) (:goal ())", "problem.pddl:3:9: unsupported: timed initial literals"},
        Refused{"", "(:goal (preference a (p)))", "problem.pddl:3:9: unsupported: preferences"},
        Refused{"", "(:goal (>= (f o) 3))", "problem.pddl:3:8: unsupported: numeric conditions"},
        Refused{"", "(:goal (= (f o) 3))", "problem.pddl:3:8: unsupported: numeric conditions"},
        Refused{"", "(:goal (= (g) o))", "problem.pddl:3:8: unsupported: object fluents"},
        Refused{"", "(:goal (q (g)))", "problem.pddl:3:9: unsupported: object fluents"},
        Refused{"", "(:init (= (g) o)) (:goal ())", "problem.pddl:3:12: unsupported: object fluents"},
        Refused{"", "(:goal ()) (:metric maximize (total-cost))",
                "problem.pddl:3:21: unsupported: metrics other than"},
        Refused{"", "(:goal ()) (:metric minimize (+ (total-cost) 1))", "unsupported: metrics other than"},
        Refused{"(:action a :parameters (?x) :effect (increase (f ?x) 1))", "(:goal ())",
                "3:37: unsupported: numeric effects other than"},
        Refused{"(:action a :effect (decrease (total-cost) 1))", "(:goal ())",
                "3:20: unsupported: numeric effects"},
        Refused{"(:action a :effect (when (p) (increase (total-cost) 1)))", "(:goal ())",
                "3:30: unsupported: conditional and universal costs"},
        Refused{"(:action a :effect (increase (total-cost) (total-cost)))", "(:goal ())",
                "unsupported: costs that depend on the total cost"},
        Refused{"(:action a :effect (assign (g) o))", "(:goal ())", "3:29: unsupported: object fluents"},
        Refused{"(:process a)", "(:goal ())", "3:2: unsupported: processes"},
        Refused{"(:event a)", "(:goal ())", "3:2: unsupported: events"},
        Refused{"(:task a :parameters ())", "(:goal ())", "3:2: unsupported: hierarchical tasks"}));

TEST(UnsupportedAndWrong, IsAnErrorFirst) {
    const std::string domain_text = domain("(:durative-action a) (:action b :effect (nix))");
    EXPECT_FALSE(is_unsupported(domain_text, empty_problem()));
    EXPECT_TRUE(contains(error_of(domain_text, empty_problem()), "durative actions are not supported"));
}

TEST(Errors, CarryTheirDiagnostics) {
    try {
        parse(domain("(:action b :effect (nix))"), empty_problem());
        FAIL();
    } catch (const InputError& error) {
        ASSERT_EQ(error.diagnostics().size(), 1U);
        EXPECT_EQ(error.diagnostics()[0].message, "unknown predicate 'nix'");
        EXPECT_EQ(error.diagnostics()[0].where.length, 3U);
    }
}

}  // namespace
}  // namespace praxis
