// What is read, but cannot be planned for, is refused with its place, not passed over.
#include <gtest/gtest.h>

#include <string>

#include "belief/belief_task.hpp"

namespace praxis::belief {
namespace {

std::string refusal(const std::string& domain, const std::string& problem) {
    try {
        ground_belief(parse_contingent({"d.pddl", domain}, {"p.pddl", problem}).task);
    } catch (const UnsupportedError& error) {
        return error.what();
    }
    return "";
}

constexpr const char* kProblem = "(define (problem p) (:domain d) (:init (unknown (q))) (:goal (r)))";

/// The refusal of a domain with an observable atom (o).
std::string refusal_of_model(const std::string& body) {
    return refusal(
        "(define (domain d) (:predicates (q) (r) (o)) (:variable v (q)) (:obs-variable w (o))" + body + ")",
        kProblem);
}

TEST(Refuse, ObservableAtomsThatMeanDifferentThings) {
    const std::string models =
        "(:action a :parameters () :sensing-model (when (q) (o)))"
        "(:action b :parameters () :sensing-model (when (r) (o)))";
    EXPECT_EQ(refusal_of_model(models + "(:action c :parameters () :precondition (q) :effect (r))"), "");
    EXPECT_NE(refusal_of_model(models + "(:action c :parameters () :precondition (o) :effect (r))")
                  .find("sensing models differ"),
              std::string::npos);
}

TEST(Refuse, EffectsOnObservableAtoms) {
    EXPECT_NE(refusal_of_model("(:action a :parameters () :effect (o) :sensing-model (when (q) (o)))")
                  .find("effect on an observable atom"),
              std::string::npos);
}

TEST(Refuse, ObservableAtomsInModels) {
    EXPECT_NE(refusal_of_model("(:action a :parameters () :effect (r) :sensing-model (when (not (o)) (o)))")
                  .find("in the condition of a sensing model"),
              std::string::npos);
}

TEST(Refuse, ObservableAtomsInInit) {
    EXPECT_NE(refusal("(define (domain d) (:predicates (q) (r)) (:obs-variable w (q))"
                      "(:action a :parameters () :effect (r) :sensing-model (when (r) (q))))",
                      kProblem)
                  .find("observable"),
              std::string::npos);
}

TEST(Refuse, DerivedAtomsInModels) {
    EXPECT_NE(refusal("(define (domain d) (:predicates (q) (r) (o) (e)) (:obs-variable w (o))"
                      "(:derived (e) (or (q) (r)))"
                      "(:action a :parameters () :effect (r) :sensing-model (when (e) (o))))",
                      kProblem)
                  .find("derived"),
              std::string::npos);
}

TEST(Refuse, LeavingAVariableOpenThatAnActionEmpties) {
    const std::string domain =
        "(define (domain d) (:predicates (q) (r) (x) (y)) (:variable v (x) (y))"
        "(:action lose :parameters () :effect (unknown (x)))"
        "(:action move :parameters () :precondition (x) :effect (and (not (x)) (y)))";
    const std::string problem = "(define (problem p) (:domain d) (:init) (:goal (y)))";
    EXPECT_EQ(refusal(domain + ")", problem), "");
    EXPECT_NE(refusal(domain + "(:action drop :parameters () :effect (not (x))))", problem).find("(drop)"),
              std::string::npos);
}

TEST(Refuse, DecayOfWhatIsSticky) {
    const std::string domain =
        "(define (domain d) (:predicates (q) (r)) (:decay q 3)"
        "(:action a :parameters () :precondition (q) :effect (r))";
    EXPECT_EQ(refusal(domain + ")", kProblem), "");
    EXPECT_NE(refusal(domain + "(:sticky (q)))", kProblem).find(":sticky"), std::string::npos);
}

TEST(Refuse, NothingOfAnOrdinaryTask) {
    EXPECT_EQ(refusal("(define (domain d) (:predicates (q) (r))"
                      "(:action a :parameters () :precondition (q) :effect (r))"
                      "(:action b :parameters () :observe (q)))",
                      kProblem),
              "");
}

}  // namespace
}  // namespace praxis::belief
