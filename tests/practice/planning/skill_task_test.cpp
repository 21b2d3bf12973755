#include "practice/planning/skill_task.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "parser/diagnostic.hpp"
#include "tests/practice/support/tokens.hpp"

namespace praxis::practice {
namespace {

using test::Tokens;

/// Tokens whose description or atoms are changed.
class Changed : public Tokens {
  public:
    Changed() : Tokens(2, 3, {{0, 1}, {1, 2}, {2, 0}}), changed_(Tokens::description()) {}
    const Description& description() const override { return changed_; }
    bool holds(const State& state, const GroundAtom& atom) const override {
        if (everywhere && atom.predicate == 0) return true;
        if (nowhere && atom.predicate == 0) return false;
        return Tokens::holds(state, atom);
    }
    Description changed_;
    bool everywhere = false, nowhere = false;
};

TEST(SkillTask, ReadsStatesAndJudgesSuccess) {
    const Tokens environment(2, 3, {{0, 1}, {1, 2}, {2, 0}});
    const SkillTask skills(environment);
    EXPECT_EQ(skills.size(), 2u * 3 + 2);
    Random random(1);
    PracticeTask task = environment.sample_task(random);
    std::vector<std::int32_t> before, after;
    skills.read(task.initial, before);
    const SkillIndex move = skills.find("(move t1 p0 p1)");
    const SkillIndex mark = skills.find("(mark t1 p2)");
    EXPECT_TRUE(skills.applicable(move, before));
    EXPECT_FALSE(skills.applicable(mark, before));
    EXPECT_FALSE(skills.succeeded(move, before, before));
    environment.execute(task.initial, skills.skill(move), {}, random);
    skills.read(task.initial, after);
    EXPECT_TRUE(skills.succeeded(move, before, after));
    EXPECT_FALSE(skills.succeeded(skills.find("(move t0 p0 p1)"), before, after));
    EXPECT_EQ(skills.goal(task.goal).size(), 2u);
    EXPECT_FALSE(skills.holds(skills.goal(task.goal), task.initial));
    EXPECT_EQ(skills.schema(mark).name, "mark");
    EXPECT_THROW(skills.find("(mark t9 p2)"), std::invalid_argument);
}

TEST(SkillTask, RefusesAGoalThatNoSkillCanReach) {
    const Tokens environment(1, 3, {{0, 1}, {2, 0}});
    const SkillTask skills(environment);
    const std::vector<GroundAtom> goal = {{0, {0, 3}}};
    EXPECT_THROW(skills.goal(goal), std::invalid_argument);
}

TEST(SkillTask, SaysWhichNumberOfAGoalIsWrong) {
    const Tokens environment(1, 2, {{0, 1}});
    const SkillTask skills(environment);
    const auto refusal = [&](const GroundAtom& atom) -> std::string {
        try {
            skills.goal(std::vector<GroundAtom>{atom});
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(refusal({1, {0}}), "none");
    EXPECT_EQ(refusal({2, {0}}),
              "a goal has an atom of predicate 2; the environment's description has 2 predicates, numbered "
              "from 0");
    EXPECT_NE(refusal({-1, {0}}).find("predicate -1;"), std::string::npos);
    EXPECT_NE(refusal({1, {3}}).find("object 3; the environment's description has 3 objects"),
              std::string::npos);
    EXPECT_NE(refusal({1, {-7}}).find("object -7;"), std::string::npos);
    EXPECT_NE(refusal({1, {0, 1}}), "none") << "an argument too many";
}

TEST(SkillTask, RefusesADescriptionThatDoesNotFitTheDomain) {
    Changed no_skill, no_object, no_predicate, twice, broken;
    no_skill.changed_.schemas.pop_back();
    EXPECT_THROW(SkillTask{no_skill}, std::invalid_argument);
    no_object.changed_.objects.pop_back();
    EXPECT_THROW(SkillTask{no_object}, std::invalid_argument);
    no_predicate.changed_.predicates.pop_back();
    EXPECT_THROW(SkillTask{no_predicate}, std::invalid_argument);
    twice.changed_.objects.push_back("t0");
    EXPECT_THROW(SkillTask{twice}, std::invalid_argument);
    broken.changed_.domain = "(define (domain tokens)";
    EXPECT_THROW(SkillTask{broken}, InputError);
}

TEST(SkillTask, RefusesAtomsThatTheDomainExcludes) {
    Changed environment;
    const SkillTask skills(environment);
    std::vector<std::int32_t> values;
    const State state = {0, 0, 0, 0, 0};
    skills.read(state, values);
    environment.everywhere = true;
    EXPECT_THROW(skills.read(state, values), std::logic_error);
    environment.everywhere = false;
    environment.nowhere = true;
    EXPECT_THROW(skills.read(state, values), std::logic_error);
}

}  // namespace
}  // namespace praxis::practice
