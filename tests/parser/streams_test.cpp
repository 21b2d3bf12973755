// Stream files: what is read, and what is said about wrong ones.
#include "parser/streams.hpp"

#include <gtest/gtest.h>

#include "tests/parser/texts.hpp"

namespace praxis {
namespace {

using test::contains;
using test::problem;

const std::string kDomain = test::domain(
    "(:types block region pose - object fixed - pose)"
    "(:constants c - region)"
    "(:predicates (on ?b - block ?r - region) (pose ?b - block ?p - pose) (good ?p - pose) (at ?b - block ?p "
    "- pose)"
    "             (apart ?p ?q - pose) (clear ?p - pose) (unsafe ?p - pose))"
    "(:functions (total-cost) (effort ?p - pose) - number)"
    "(:derived (unsafe ?p - pose) (exists (?b - block ?q - pose) (and (at ?b ?q) (not (apart ?p ?q)))))"
    "(:action put :parameters (?b - block ?p - pose) :precondition (and (pose ?b ?p) (not (unsafe ?p)))"
    "  :effect (at ?b ?p))");
const std::string kProblem = problem("(:objects b - block r - region) (:init (on b r)) (:goal (and))");

std::string streams(const std::string& sections) {
    return "(define (stream s)\n" + sections + ")\n";
}

StreamLoadResult read(const std::string& sections, const std::string& domain = kDomain) {
    return parse_streams({"domain.pddl", domain}, {"problem.pddl", kProblem},
                         {"streams.pddl", streams(sections)});
}

std::string error_of(const std::string& sections, const std::string& domain = kDomain) {
    try {
        read(sections, domain);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(Streams, AreRead) {
    const StreamTask task =
        read(
            "(:stream Sample :inputs (?b - block ?r - region) :domain (on ?b ?r) :outputs (?p - fixed)\n"
            "  :certified (and (pose ?b ?p) (good ?p)) :fluents (AT))\n"
            "(:stream test :inputs (?p ?q - pose) :domain (and (good ?p) (good ?q)) :certified (apart ?p "
            "?q))\n"
            "(:predicate (clear ?p) (good ?p))\n"
            "(:function (effort ?p) (good ?p))")
            .task;
    EXPECT_EQ(task.name, "s");
    ASSERT_EQ(task.streams.size(), 3u);
    const StreamSchema& sample = task.streams[0];
    EXPECT_EQ(sample.name, "sample");
    EXPECT_EQ(sample.input_count(), 2u);
    EXPECT_EQ(sample.output_count(), 1u);
    ASSERT_EQ(sample.domain.size(), 1u);
    EXPECT_EQ(task.task->predicates[sample.domain[0].predicate.index()].name, "on");
    EXPECT_EQ(sample.domain[0].terms[1], Term::variable(1));
    ASSERT_EQ(sample.certified.size(), 2u);
    EXPECT_EQ(sample.certified[0].terms[1], Term::variable(2));
    ASSERT_EQ(sample.fluents.size(), 1u);
    EXPECT_EQ(task.task->predicates[sample.fluents[0].index()].name, "at");
    std::vector<std::string> types;
    for (const TypeId type : sample.output_types[0]) types.push_back(task.task->types[type.index()].name);
    EXPECT_EQ(types, (std::vector<std::string>{"object", "pose", "fixed"}));
    EXPECT_EQ(task.streams[1].output_count(), 0u);
    EXPECT_EQ(task.streams[2].name, "clear");
    EXPECT_EQ(task.streams[2].certified[0].terms[0], Term::variable(0));
    ASSERT_EQ(task.functions.size(), 1u);
    EXPECT_EQ(task.task->functions[task.functions[0].function.index()].name, "effort");
    EXPECT_TRUE(task.certified[sample.certified[0].predicate.index()]);
    EXPECT_FALSE(task.certified[sample.domain[0].predicate.index()]);
}

TEST(Streams, MistakesHaveAPlaceAndAMend) {
    EXPECT_EQ(error_of("(:stream a :inputs (?b - block) :certified (onn ?b c) :certified (on ?b c))"),
              "streams.pddl:2:45: error: unknown predicate 'onn'\n"
              "  2 | (:stream a :inputs (?b - block) :certified (onn ?b c) :certified (on ?b c)))\n"
              "    |                                             ^~~ did you mean 'on'?\n");
    const auto says = [](const std::string& sections, const std::string& part) {
        const std::string error = error_of(sections);
        EXPECT_TRUE(contains(error, part)) << error;
        EXPECT_TRUE(contains(error, "streams.pddl:")) << error;
    };
    const std::string in = "(:stream a :inputs (?b - block) ";
    says(in + ":outputs (?p - pose) :certified (posse ?b ?p))", "did you mean 'pose'?");
    says(in + ":domain (pose ?b ?p) :outputs (?p - pose) :certified (pose ?b ?p))", "unbound variable '?p'");
    says(in + ":outputs (?b - pose) :certified (good ?b))", "'?b' is an input already");
    says(in + ":outputs (?p - pose) :certified (pose ?p))", "takes 2 arguments, not 1");
    says(in + ":outputs (?p - posse) :certified (pose ?b ?p))", "did you mean 'pose'?");
    says(in + ":outputs (?p - pose))", "stream 'a' certifies nothing");
    says(in + ":outputs (?p - pose) :certified (at ?b ?p))", "cannot certify 'at', which actions change");
    says(in + ":outputs (?p - pose) :certified (unsafe ?p))", "which is derived");
    says(in + ":domain (at ?b c) :certified (on ?b c))", "list it under ':fluents'");
    says(in + ":domain (or (on ?b c)) :certified (on ?b c))", "expected atoms, joined with 'and'");
    says(in + ":fluents (unsafe) :certified (on ?b c))", "cannot be a fluent");
    says(in + ":fluents (att) :certified (on ?b c))", "did you mean 'at'?");
    says(in + ":certified (on ?b c)) " + in + ":certified (on ?b c))", "duplicate stream 'a'");
    says("(:strem a)", "did you mean ':stream'?");
    says("(:action a)", "it belongs into the domain");
    says("(:stream a :outptus (?p))", "':outputs'");
    says("(:function (eforts ?p) (good ?p))", "did you mean 'effort'?");
    says("(:function (effort ?p ?q) (good ?p))", "takes 1 arguments, not 2");
    says("(:predicate (claer ?p) (good ?p))", "did you mean 'clear'?");
    says("(:stream a :inputs (?b", "found");
}

TEST(Streams, WhatTheyCertifyMustNotBeNegated) {
    const std::string far = "(:stream a :inputs (?p ?q - pose) :certified (apart ?p ?q))";
    EXPECT_EQ(error_of(far), "") << "twice negated is not negated";
    const std::string negated =
        error_of("(:stream a :inputs (?p - pose) :certified (good ?p))",
                 test::domain("(:types pose) (:predicates (good ?p - pose) (done))"
                              "(:action a :parameters (?p - pose) :precondition (not (good "
                              "?p)) :effect (done))"));
    EXPECT_TRUE(contains(negated, "certify the contrary")) << negated;
    const std::string effect =
        error_of("(:stream a :inputs (?p - pose) :certified (good ?p))",
                 test::domain("(:types pose) (:predicates (good ?p - pose) (done))"
                              "(:action a :parameters (?p - pose) :effect (when (good ?p) "
                              "(done)))"));
    EXPECT_TRUE(contains(effect, "make two actions of it")) << effect;
}

TEST(Streams, WorthAWarning) {
    const auto warnings = [](const std::string& sections) {
        std::string text;
        const StreamLoadResult result = read(sections);
        for (const Diagnostic& warning : result.warnings)
            text += to_string(warning, *result.task.task->sources);
        return text;
    };
    EXPECT_TRUE(contains(warnings("(:stream a :inputs (?x) :outputs (?p - pose) :certified (good ?p))"),
                         "any object can be this input"));
    EXPECT_TRUE(contains(warnings("(:stream a :outputs (?p ?q - pose) :certified (good ?p))"),
                         "nothing is certified of this output"));
}

}  // namespace
}  // namespace praxis
