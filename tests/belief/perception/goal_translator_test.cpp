// Goals in words become formulas that the parser has accepted.
#include "belief/perception/goal_translator.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "belief/perception/vision_model.hpp"
#include "parser/parser.hpp"
#include "tests/belief/perception/chat_server.hpp"
#include "tests/belief/perception/support.hpp"

namespace praxis::belief {
namespace {

using test::contains;
using test::FunctionModel;
using test::perception_error;

Vocabulary kitchen() {
    const Task task =
        parse_task(
            {"domain.pddl",
             "(define (domain kitchen) (:requirements :adl) (:types cup box - item item place - object)"
             "(:predicates (inside ?x - item ?p - place) (empty ?c - cup)"
             "  (touched ?x - (either cup place)))"
             "(:action look :parameters (?c - cup) :precondition (empty ?c) :effect (touched ?c)))"},
            {"problem.pddl",
             "(define (problem p) (:domain kitchen) (:objects cup1 cup2 - cup box1 - box drawer bin - place)"
             "(:init) (:goal (and)))"})
            .task;
    return vocabulary_of(*task);
}

std::string goal_answer(const std::string& goal) {
    return nlohmann::json{{"goal", goal}}.dump();
}

TEST(CheckGoal, AcceptsFormulasOverTheVocabulary) {
    const Vocabulary vocabulary = kitchen();
    for (const char* goal :
         {"(inside cup1 drawer)", "(and (inside cup1 drawer) (not (empty cup2)))",
          "(forall (?c - cup) (imply (empty ?c) (inside ?c bin)))",
          "(exists (?x - item ?p - place) (inside ?x ?p))", "(or (touched cup1) (touched bin))",
          "(exists (?x - item) (and (inside ?x bin) (not (= ?x box1))))"}) {
        std::string text = goal;
        EXPECT_EQ(check_goal(vocabulary, text), "") << goal;
        EXPECT_EQ(text, goal);
    }
    std::string text = "  ( AND\n(Inside cup1 ; in here\n   Drawer ) )\n";
    EXPECT_EQ(check_goal(vocabulary, text), "");
    EXPECT_EQ(text, "(and (inside cup1 drawer))");
}

TEST(CheckGoal, RefusesEverythingElse) {
    const Vocabulary vocabulary = kitchen();
    const auto error_of = [&](std::string goal) {
        const std::string before = goal;
        const std::string error = check_goal(vocabulary, goal);
        EXPECT_EQ(goal, before);
        return error;
    };
    EXPECT_TRUE(contains(error_of("(inside cup3 drawer)"), "unknown object 'cup3'"));
    EXPECT_TRUE(contains(error_of("(insde cup1 drawer)"), "did you mean 'inside'?"));
    EXPECT_TRUE(contains(error_of("(forall (?c - mug) (empty ?c))"), "'mug'"));
    EXPECT_TRUE(contains(error_of("(empty ?c)"), "?c"));
    EXPECT_NE(error_of("(inside drawer cup1)"), "");
    EXPECT_NE(error_of("(inside cup1)"), "");
    EXPECT_NE(error_of("(look cup1)"), "");
    for (const char* text : {"", "cup1", "inside cup1 drawer", "(inside cup1 drawer", "(inside cup1 drawer))",
                             "(and)) (:metric minimize (total-cost)", "(empty cup1) (empty cup2)", ")(",
                             "(empty cup1)) (:init (empty cup2)"}) {
        EXPECT_TRUE(contains(error_of(text), "not one expression")) << text;
    }
    EXPECT_EQ(error_of("(and)"), "the goal says nothing");
    EXPECT_NE(error_of("()"), "");
    EXPECT_NE(error_of("(and (and))"), "");
    EXPECT_TRUE(contains(error_of('(' + std::string(30000, ' ') + ')'), "longer"));
    EXPECT_NE(error_of(std::string(9000, '(') + std::string(9000, ')')), "");
}

TEST(TranslateGoal, CorrectsAWrongGoalWithTheParsersError) {
    // The whole way: a server that first invents a name, is shown the parser's words, and mends its goal.
    std::vector<nlohmann::json> heard;
    test::ChatServer server([&](const test::ReceivedRequest& request, std::size_t) {
        const auto messages = nlohmann::json::parse(request.body)["messages"];
        heard.push_back(messages);
        const std::string last = messages.back()["content"];
        if (messages.size() == 2) return test::says(goal_answer("(forall (?c - cup) (inside ?c drawr))"));
        if (contains(last, "did you mean 'drawer'?")) {
            return test::says("```json\n" + goal_answer("(forall (?c - cup)\n  (inside ?c drawer))") +
                              "\n```");
        }
        return test::says("I do not know");
    });
    VisionModelOptions options;
    options.base = server.base();
    options.model = "words";
    VisionModel model(options);
    GoalOptions goal_options;
    goal_options.meanings["inside"] = "the item is in the place";
    const TranslatedGoal goal =
        translate_goal(model, kitchen(), "Put all cups into the drawer", goal_options);
    EXPECT_EQ(goal.pddl, "(forall (?c - cup) (inside ?c drawer))");
    EXPECT_EQ(goal.attempts, 2);
    ASSERT_EQ(heard.size(), 2U);
    const std::string system = heard[0][0]["content"];
    EXPECT_TRUE(contains(system, "- (inside ?x1 - item ?x2 - place): the item is in the place")) << system;
    EXPECT_TRUE(contains(system, "- cup (a kind of item)")) << system;
    EXPECT_TRUE(contains(system, "- drawer - place")) << system;
    EXPECT_TRUE(contains(heard[0][1]["content"], "Put all cups into the drawer"));
    EXPECT_TRUE(contains(heard[1][3]["content"], "unknown object 'drawr'")) << heard[1][3];
}

TEST(TranslateGoal, GivesUpOnUnknownNames) {
    FunctionModel model([](const auto&) { return goal_answer("(on-fire cup1)"); });
    const std::string error = perception_error([&] { translate_goal(model, kitchen(), "Burn the cup"); });
    EXPECT_TRUE(contains(error, "no goal in 4 attempts")) << error;
    EXPECT_TRUE(contains(error, "on-fire")) << error;
    EXPECT_EQ(model.asked, 4);
}

TEST(TranslateGoal, TellsWhatTheModelFindsImpossible) {
    FunctionModel model([](const auto&) { return R"({"impossible": "nothing here can burn"})"; });
    EXPECT_THROW(translate_goal(model, kitchen(), "Burn the cup"), GoalError);
    EXPECT_EQ(perception_error([&] { translate_goal(model, kitchen(), "Burn the cup"); }),
              "the model finds no goal for this: nothing here can burn");
}

TEST(TranslateGoal, AsksAgainAfterAnythingElse) {
    const std::vector<std::string> answers = {"",
                                              "(empty cup1)",
                                              "[1]",
                                              R"({"goal": 7})",
                                              R"J({"goal": "(empty cup1)", "goal": "(empty cup2)"})J",
                                              goal_answer("(and)"),
                                              goal_answer("(empty cup1)")};
    int asked = 0;
    FunctionModel model([&](const auto&) { return answers[static_cast<std::size_t>(asked++)]; });
    GoalOptions options;
    options.attempts = static_cast<int>(answers.size());
    const TranslatedGoal goal = translate_goal(model, kitchen(), "Empty the first cup", options);
    EXPECT_EQ(goal.pddl, "(empty cup1)");
    EXPECT_EQ(goal.attempts, options.attempts);
}

TEST(TranslateGoal, RefusesAnInconsistentVocabulary) {
    FunctionModel model([](const auto&) { return goal_answer("(p a)"); });
    Vocabulary vocabulary;
    vocabulary.predicates.push_back({"p", {"mug"}});
    vocabulary.objects.push_back({"a", "object"});
    EXPECT_THROW(translate_goal(model, vocabulary, "p"), std::invalid_argument);
    vocabulary.predicates[0].parameters[0] = "object";
    EXPECT_EQ(translate_goal(model, vocabulary, "p").pddl, "(p a)");
    vocabulary.predicates.clear();
    vocabulary.predicates.push_back({"p", {}});
    FunctionModel plain([](const auto&) { return goal_answer("(p)"); });
    EXPECT_EQ(translate_goal(plain, vocabulary, "p").pddl, "(p)");
}

}  // namespace
}  // namespace praxis::belief
