// What is known, example by example.
#include "belief/belief.hpp"

#include <gtest/gtest.h>

#include "belief/worlds.hpp"
#include "tests/belief/texts.hpp"

namespace praxis::belief::test {
namespace {

class Knowing {
  public:
    explicit Knowing(const Texts& texts, std::size_t most_cases = 20'000)
        : task_(ground(texts)),
          belief_(std::make_shared<const Compilation>(task_, CompilationOptions{most_cases})) {}

    Truth operator()(const std::string& atom) const { return belief_.truth(fact_of(*task_, atom)); }
    void act(const std::string& name) {
        const std::uint32_t action = action_of(*task_, name);
        ASSERT_LT(action, task_->operator_count()) << name;
        ASSERT_TRUE(belief_.can(action)) << name;
        belief_.act(action);
    }
    bool can(const std::string& name) const { return belief_.can(action_of(*task_, name)); }
    /// Reads the atom as true or false.
    bool read(const std::string& atom, bool holds) {
        Fact fact = fact_of(*task_, atom);
        if (!holds) fact.value = 1 - fact.value;
        return belief_.learn(fact);
    }
    Belief& belief() { return belief_; }
    const BeliefTask& task() const { return *task_; }

  private:
    std::shared_ptr<const BeliefTask> task_;
    Belief belief_;
};

constexpr auto kTrue = Truth::known_true;
constexpr auto kFalse = Truth::known_false;
constexpr auto kUnknown = Truth::unknown;

/// Actions that set, clear and read p, q and r, so that all of them are facts.
const std::string kActions = [] {
    std::string text;
    for (const std::string atom : {"p", "q", "r"})
        text += "(:action set-" + atom + " :parameters () :effect (" + atom + "))" + "(:action clear-" +
                atom + " :parameters () :effect (not (" + atom + ")))" + "(:action look-" + atom +
                " :parameters () :observe (" + atom + "))";
    return text;
}();

Texts with(const std::string& init, const std::string& more_actions = "") {
    return propositional(
        "(p) (q) (r) (g)",
        kActions + "(:action win :parameters () :precondition (p) :effect (g))" + more_actions, init, "(g)");
}

TEST(Belief, KnowsTheFirstStateAsFarAsItIsCertain) {
    const Knowing knows(with("(p) (unknown (q))"));
    EXPECT_EQ(knows("(p)"), kTrue);
    EXPECT_EQ(knows("(q)"), kUnknown);
    EXPECT_EQ(knows("(r)"), kFalse);
    EXPECT_TRUE(knows.can("(win)"));
}

TEST(Belief, OneOfThreeByElimination) {
    Knowing knows(with("(oneof (p) (q) (r))"));
    EXPECT_TRUE(knows.read("(q)", false));
    EXPECT_EQ(knows("(p)"), kUnknown);
    EXPECT_TRUE(knows.read("(r)", false));
    EXPECT_EQ(knows("(p)"), kTrue);
    EXPECT_FALSE(knows.read("(p)", false));
    EXPECT_EQ(knows("(p)"), kTrue);
}

TEST(Belief, OneOfThreeExcludesTheOthers) {
    Knowing knows(with("(oneof (p) (q) (r))"));
    EXPECT_TRUE(knows.read("(q)", true));
    EXPECT_EQ(knows("(p)"), kFalse);
    EXPECT_EQ(knows("(r)"), kFalse);
}

TEST(Belief, BothWaysLeadToTheSame) {
    // Neither clause alone says so: if r did not hold, p and not p would follow (failed literals).
    Knowing knows(with("(unknown (q)) (or (r) (p) (q)) (or (r) (not (p)) (q))"));
    EXPECT_EQ(knows("(r)"), kUnknown);
    EXPECT_TRUE(knows.read("(q)", false));
    EXPECT_EQ(knows("(r)"), kTrue);
}

TEST(Belief, ActionsMakeKnown) {
    Knowing knows(with("(unknown (p))"));
    EXPECT_FALSE(knows.can("(win)"));
    knows.act("(set-p)");
    EXPECT_EQ(knows("(p)"), kTrue);
    knows.act("(clear-p)");
    EXPECT_EQ(knows("(p)"), kFalse);
}

TEST(Belief, ClausesSayNothingOfWhatHasBeenChanged) {
    Knowing knows(with("(or (p) (q))"));
    knows.act("(clear-p)");
    EXPECT_EQ(knows("(p)"), kFalse);
    EXPECT_EQ(knows("(q)"), kUnknown);
}

TEST(Belief, WhatHasBeenReadBeforeAChangeStillTells) {
    Knowing knows(with("(or (p) (q))"));
    EXPECT_TRUE(knows.read("(p)", false));
    knows.act("(set-p)");
    EXPECT_EQ(knows("(p)"), kTrue);
    EXPECT_EQ(knows("(q)"), kTrue);
}

TEST(Belief, AReadingAfterAChangeIsNoneOfTheFirstState) {
    Knowing knows(
        with("(oneof (p) (q))", "(:action drop :parameters () :effect (and (not (q)) (when (r) (p))))"));
    knows.act("(clear-q)");
    EXPECT_TRUE(knows.read("(q)", false));
    EXPECT_EQ(knows("(p)"), kUnknown);
}

TEST(Belief, AToggleLeavesOpenWhatWasOpen) {
    const Texts texts =
        with("(unknown (p))",
             "(:action toggle :parameters () :effect (and (when (p) (not (p))) (when (not (p)) (p))))");
    for (const std::size_t most_cases : {std::size_t{0}, std::size_t{100}}) {
        Knowing knows(texts, most_cases);
        knows.act("(toggle)");
        EXPECT_EQ(knows("(p)"), kUnknown);
        EXPECT_TRUE(knows.read("(p)", true));
        knows.act("(toggle)");
        EXPECT_EQ(knows("(p)"), kFalse);
    }
}

TEST(Belief, WhatIsForgottenIsNotKnown) {
    Knowing knows(
        with("(p) (q)", "(:action shake :parameters () :effect (and (unknown (p)) (unknown (r))))"));
    knows.act("(shake)");
    EXPECT_EQ(knows("(p)"), kUnknown);
    EXPECT_EQ(knows("(q)"), kTrue);
    EXPECT_EQ(knows("(r)"), kUnknown);
    EXPECT_TRUE(knows.read("(p)", false));
    EXPECT_EQ(knows("(p)"), kFalse);
    knows.act("(shake)");
    EXPECT_EQ(knows("(p)"), kUnknown);
}

TEST(Belief, CasesTellOfCausesByTheirEffects) {
    // The lamp tells of the switch, and then the switch of the first state of another lamp.
    const Texts texts = with("(unknown (p))", "(:action press :parameters () :effect (when (p) (q)))");
    Knowing exact(texts), rough(texts, 0);
    for (Knowing* knows : {&exact, &rough}) {
        knows->act("(press)");
        EXPECT_EQ((*knows)("(q)"), kUnknown);
        EXPECT_TRUE(knows->read("(q)", true));
    }
    EXPECT_EQ(exact("(p)"), kTrue);
    EXPECT_EQ(rough("(p)"), kUnknown);
}

TEST(Belief, ConditionalEffectsOnDerivedAtoms) {
    const Texts texts =
        propositional("(p) (q) (r) (both) (g)",
                      kActions +
                          "(:derived (both) (and (p) (q)))"
                          "(:action press :parameters () :effect (when (both) (r)))"
                          "(:action win :parameters () :precondition (and (r) (both)) :effect (g))",
                      "(unknown (p)) (unknown (q))", "(g)");
    for (const std::size_t most_cases : {std::size_t{0}, std::size_t{100}}) {
        Knowing knows(texts, most_cases);
        knows.act("(press)");
        EXPECT_EQ(knows("(r)"), kUnknown);
        EXPECT_TRUE(knows.read("(p)", true));
        EXPECT_TRUE(knows.read("(q)", true));
        knows.act("(press)");
        EXPECT_EQ(knows("(r)"), kTrue);
        EXPECT_TRUE(knows.can("(win)"));
    }
}

TEST(Belief, DerivedAtomsOfMoreCasesThanAPlanHas) {
    std::string things, init = "(oneof";
    for (int i = 0; i < 40; ++i) {
        things += " t" + std::to_string(i);
        init += " (p t" + std::to_string(i) + ")";
    }
    Knowing knows(
        {"(define (domain d) (:types thing) (:constants" + things +
             " - thing) (:predicates (p ?t - thing) (q ?t - thing) (bad ?t - thing) (next ?t ?u - thing) "
             "(done))"
             "(:derived (bad ?t - thing)"
             " (or (p ?t) (exists (?u - thing) (and (next ?u ?t) (bad ?u)))))"
             "(:action press :parameters (?t - thing) :effect (when (p ?t) (q ?t)))"
             "(:action go :parameters () :precondition (not (bad t1)) :effect (done)))",
         "(define (problem x) (:domain d) (:init (next t0 t1) (next t1 t0) " + init + ")) (:goal (done)))"});
    Random random(3);
    for (int i = 0; i < 5; ++i) {
        EXPECT_FALSE(knows.can("(go)"));
        knows.belief().begin_plan(random);
    }
    EXPECT_TRUE(knows.read("(p t1)", false));
    EXPECT_FALSE(knows.can("(go)"));
    EXPECT_TRUE(knows.read("(p t0)", false));
    EXPECT_TRUE(knows.can("(go)"));
}

TEST(Belief, AContradictingReadingChangesNothing) {
    Knowing knows(with("(unknown (p)) (q)", "(:action press :parameters () :effect (when (p) (r)))"));
    EXPECT_TRUE(knows.read("(p)", true));
    const std::vector<std::int32_t> before = knows.belief().values();
    const std::uint64_t fingerprint = knows.belief().fingerprint();
    EXPECT_FALSE(knows.read("(p)", false));
    EXPECT_FALSE(knows.read("(q)", false));
    EXPECT_EQ(knows.belief().values(), before);
    EXPECT_EQ(knows.belief().fingerprint(), fingerprint);
    EXPECT_EQ(knows("(p)"), kTrue);
}

TEST(Belief, FingerprintsTellBeliefsApart) {
    Knowing one(with("(unknown (p)) (unknown (q))")), other(with("(unknown (p)) (unknown (q))"));
    EXPECT_EQ(one.belief().fingerprint(), other.belief().fingerprint());
    one.read("(p)", true);
    EXPECT_NE(one.belief().fingerprint(), other.belief().fingerprint());
    other.read("(p)", false);
    EXPECT_NE(one.belief().fingerprint(), other.belief().fingerprint());
}

TEST(Belief, FingerprintsTellApartWhatCanStillBeDeduced) {
    // Both know that p does not hold; only one of them knows of q or r that one holds.
    Knowing one(with("(or (p) (q) (r))")), other(with("(or (p) (q) (r))"));
    one.act("(clear-p)");
    other.read("(p)", false);
    EXPECT_NE(one.belief().fingerprint(), other.belief().fingerprint());
}

TEST(Belief, WhatAFailedActionMayHaveChangedIsNotKnown) {
    Knowing knows(with("(oneof (p) (q))"));
    EXPECT_TRUE(knows.read("(p)", true));
    knows.belief().fail(action_of(knows.task(), "(clear-p)"));
    EXPECT_EQ(knows("(p)"), kUnknown);
    EXPECT_EQ(knows("(q)"), kFalse);
    EXPECT_TRUE(knows.read("(p)", false));
    EXPECT_EQ(knows("(p)"), kFalse);
}

TEST(Belief, AFailureThatCouldChangeNothingLeavesEverythingKnown) {
    Knowing knows(with("(oneof (p) (q))"));
    EXPECT_TRUE(knows.read("(p)", true));
    EXPECT_FALSE(knows.belief().fail(action_of(knows.task(), "(set-p)")));
    EXPECT_EQ(knows("(p)"), kTrue);
}

TEST(Belief, ContradictionsOnlyFoundByCasesLeaveNoModel) {
    const auto task =
        ground(with("(or (p) (q)) (or (p) (not (q))) (or (not (p)) (q)) (or (not (p)) (not (q)))",
                    "(:action press :parameters () :effect (when (p) (r)))"));
    const auto worlds = enumerate_worlds(*task, 10);
    ASSERT_TRUE(worlds);
    EXPECT_TRUE(worlds->empty());
    const Belief belief(compile(task));  // must not crash
    Random random(0);
    EXPECT_FALSE(sample_world(*task, random));
}

}  // namespace
}  // namespace praxis::belief::test
