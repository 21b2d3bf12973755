// Prompts, and what becomes of right and wrong answers.
#include "belief/perception/questions.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>

#include "belief/perception/depth_camera.hpp"
#include "belief/perception/json_answer.hpp"
#include "tests/belief/perception/support.hpp"

namespace praxis::belief {
namespace {

using test::contains;
using test::perception_error;

const std::vector<std::string> kViews = {"top", "side"};
const std::vector<std::string> kTypes = {"cup", "box"};
constexpr Truth kTrue = Truth::known_true;
constexpr Truth kFalse = Truth::known_false;
constexpr Truth kUnknown = Truth::unknown;

QuestionAnswers read(const std::string& text, std::size_t questions) {
    return read_question_answers(text, questions, kViews, kTypes);
}

TEST(Questions, AreSentencesOfTheirPredicates) {
    QuestionTexts texts;
    texts.predicates["inside"].sentence = "Is {0} inside {1}? ({0}!)";
    EXPECT_EQ(question_sentence(texts, {{"inside", "cup1", "drawer"}}), "Is cup1 inside drawer? (cup1!)");
    EXPECT_EQ(question_sentence(texts, {{"open", "drawer"}}), "Is (open drawer) true?");
    for (const char* wrong :
         {"Is {2} there?", "Is {x} there?", "Is {} there?", "Is {0 there?", "{", "{-1}"}) {
        texts.predicates["inside"].sentence = wrong;
        EXPECT_TRUE(contains(perception_error([&] {
                                 question_sentence(texts, {{"inside", "cup1", "drawer"}});
                             }),
                             "does not fit"))
            << wrong;
    }
}

TEST(Questions, AreAllInOnePrompt) {
    QuestionTexts texts;
    texts.predicates["open"].sentence = "Is {0} open?";
    texts.objects["d1"] = "the upper drawer";
    texts.types = kTypes;
    texts.remarks = "The light is poor.";
    const std::vector<AtomName> atoms = {{{"open", "d1"}}, {{"open", "d2"}}};
    const std::vector<std::string> objects = {"d1", "d2"};
    const std::string prompt = question_prompt(texts, kViews, objects, atoms);
    for (const char* part : {"top, side", "The light is poor.", "- d1 (the upper drawer)\n- d2\n",
                             "1. Is d1 open?\n", "2. Is d2 open?\n", "cup, box", "\"detections\""}) {
        EXPECT_TRUE(contains(prompt, part)) << part;
    }
    texts.types.clear();
    EXPECT_FALSE(contains(question_prompt(texts, kViews, objects, atoms), "detections"));
}

TEST(Answers, AreReadByNumber) {
    const QuestionAnswers answers =
        read(R"({"answers":[{"question":3,"answer":"unknown"},{"question":2,"answer":false},)"
             R"({"question":1,"answer":"true"}]})",
             3);
    EXPECT_TRUE(answers.usable);
    EXPECT_EQ(answers.values, (std::vector<Truth>{kTrue, kFalse, kUnknown}));
    EXPECT_TRUE(answers.problems.empty());
}

TEST(Answers, ThatAreMissingExtraOrContradictoryAreUnknown) {
    const QuestionAnswers answers = read(
        R"({"answers":[{"question":1,"answer":"true"},{"question":1,"answer":"true"},)"
        R"({"question":2,"answer":"true"},{"question":2,"answer":"false"},{"question":2,"answer":"true"},)"
        R"({"question":3,"answer":"perhaps"},{"question":3,"answer":"true"},{"question":9,"answer":"true"},)"
        R"({"question":0,"answer":"true"},{"question":1.5,"answer":"true"},{"question":-1,"answer":"true"},)"
        R"({"question":18446744073709551615,"answer":"true"},"true",null,{"question":5},)"
        R"({"question":6,"answer":"unknown"},{"question":6,"answer":"true"}]})",
        6);
    EXPECT_TRUE(answers.usable);
    EXPECT_EQ(answers.values, (std::vector<Truth>{kTrue, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown}));
    std::string all;
    for (const std::string& problem : answers.problems) all += problem + '\n';
    for (const char* part : {"question 2 has contradicting", "question 3 is not", "no question 9",
                             "no question 0", "no question -1", "question 4 has no answer",
                             "question 5 has no answer", "question 6 has contradicting"}) {
        EXPECT_TRUE(contains(all, part)) << part << " in\n" << all;
    }
}

TEST(Answers, OfNoFormAreUnusable) {
    for (const char* text :
         {"", "true", "[]", "{}", "{\"answers\":{}}", "{\"answers\":[]}", "{\"answers\":[{\"question\":1}]}",
          "{\"answers\":[{\"question\":2,\"answer\":\"true\"}]}", "Sure! {\"answers\":[]}",
          R"({"answers":[{"question":1,"answer":"true"}]} and so on)",
          R"({"answers":[{"question":1,"answer":"true","answer":"false"}]})", R"({"answers":[{"question":1,)",
          R"({"answers":[{"question":1,"answer":"yes"}]})", "\xff", "{\"answers\":[NaN]}"}) {
        const QuestionAnswers answers = read(text, 1);
        EXPECT_FALSE(answers.usable) << text;
        EXPECT_FALSE(answers.problems.empty()) << text;
        EXPECT_EQ(answers.values, std::vector<Truth>{kUnknown});
    }
    const std::string fenced = "\n```json\n{\"answers\":[{\"question\":1,\"answer\":\"true\"}]}\n```  ";
    EXPECT_TRUE(read(fenced, 1).usable);
    EXPECT_TRUE(read("{}", 0).usable);
    EXPECT_FALSE(read(std::string(100000, '['), 1).usable);
}

TEST(Answers, ListWhatIsSeen) {
    const QuestionAnswers answers = read(
        R"({"detections":[
            {"object":"cup1","type":"cup","view":"side","pixel":[3,4.5],"confidence":0.25},
            {"object":null,"type":"box","view":"top"},
            {"object":"x","type":"spoon","view":"top"}, {"type":"cup","view":"left"}, {"type":"cup"}, 7, {},
            {"type":"cup","view":"top","pixel":["a",1]}, {"type":"cup","view":"top","pixel":[1,2,3]},
            {"type":"cup","view":"top","confidence":2}, {"type":"cup","view":"top","confidence":"high"}]})",
        0);
    EXPECT_TRUE(answers.usable);
    ASSERT_EQ(answers.seen.size(), 4U);
    EXPECT_EQ(answers.seen[0].object, "cup1");
    EXPECT_EQ(answers.seen[0].view, 1U);
    EXPECT_EQ((*answers.seen[0].pixel)[1], 4.5);
    EXPECT_EQ(answers.seen[0].confidence, 0.25);
    EXPECT_EQ(answers.seen[1].object, "");
    EXPECT_FALSE(answers.seen[1].pixel || answers.seen[2].pixel || answers.seen[3].pixel);
    EXPECT_EQ(answers.problems.size(), 7U);
}

/// Something like JSON: values in which names and values of the schema occur by chance.
rc::Gen<nlohmann::json> gen_json(int depth) {
    return rc::gen::exec([depth] {
        const int kind = *rc::gen::inRange(0, depth > 0 ? 8 : 5);
        if (kind == 0) return nlohmann::json(nullptr);
        if (kind == 1) return nlohmann::json(*rc::gen::arbitrary<bool>());
        if (kind == 2) return nlohmann::json(*rc::gen::inRange(-2, 6));
        if (kind <= 4)
            return nlohmann::json(
                *rc::gen::element<std::string>("true", "false", "unknown", "cup", "top", "x"));
        nlohmann::json value = kind == 5 ? nlohmann::json::array() : nlohmann::json::object();
        const int count = *rc::gen::inRange(0, 5);
        for (int i = 0; i < count; ++i) {
            if (kind == 5) {
                value.push_back(*gen_json(depth - 1));
            } else {
                value[*rc::gen::element<std::string>("question", "answer", "answers", "detections", "type",
                                                     "view", "object", "pixel")] = *gen_json(depth - 1);
            }
        }
        return value;
    });
}

TEST(Answers, OfAnyShapeGiveOnlyWhatWasSaid) {
    EXPECT_TRUE(rc::check([] {
        nlohmann::json answers = nlohmann::json::array();
        std::vector<std::vector<nlohmann::json>> said(4);  // by question
        const int count = *rc::gen::inRange(0, 8);
        for (int i = 0; i < count; ++i) {
            if (*rc::gen::inRange(0, 4) == 0) {
                answers.push_back(*gen_json(2));
                if (answers.back().is_object() && answers.back().contains("question"))
                    answers.back().erase("question");
                continue;
            }
            const int question = *rc::gen::inRange(0, 5);
            const auto answer =
                *rc::gen::element<nlohmann::json>("true", "false", "unknown", "maybe", true, 1);
            answers.push_back({{"question", question}, {"answer", answer}});
            if (question >= 1 && question <= 3) said[static_cast<std::size_t>(question)].push_back(answer);
        }
        const nlohmann::json whole = {{"answers", answers}, {"detections", *gen_json(3)}};
        const QuestionAnswers result = read(whole.dump(), 3);
        for (std::size_t i = 1; i <= 3; ++i) {
            const auto all = [&](auto is) {
                return !said[i].empty() && std::all_of(said[i].begin(), said[i].end(), is);
            };
            const bool yes = all([](const auto& a) { return a == "true" || a == true; });
            const bool no = all([](const auto& a) { return a == "false"; });
            RC_ASSERT(result.values[i - 1] == (yes ? kTrue : no ? kFalse : kUnknown));
        }
    }));
}

TEST(DepthCamera, LiftsWhatItProjects) {
    EXPECT_TRUE(rc::check([] {
        DepthCamera camera;
        camera.pinhole = {200, 210, 64, 48};
        // Above the table, looking down: x stays, y and z turn round.
        camera.pose.rotation = {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
        camera.pose.translation = {0.2, 0.1, 1.5};
        camera.depth = {128, 96, std::vector<float>(128 * 96, 1.5F)};
        const Position point{0.2 + *rc::gen::inRange(-40, 41) * 0.01, 0.1 + *rc::gen::inRange(-30, 31) * 0.01,
                             0};
        const auto pixel = camera.project(point);
        RC_ASSERT(pixel.has_value());
        const auto lifted = camera.lift((*pixel)[0], (*pixel)[1]);
        RC_ASSERT(lifted.has_value());
        RC_ASSERT(std::abs(lifted->x - point.x) < 1e-6);
        RC_ASSERT(std::abs(lifted->y - point.y) < 1e-6);
        RC_ASSERT(std::abs(lifted->z - point.z) < 1e-6);
    }));
}

TEST(DepthCamera, HasNoPositionWhereItMeasuredNothing) {
    DepthCamera camera;
    camera.pinhole = {100, 100, 4, 4};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    camera.depth = {9, 9, std::vector<float>(81, nan)};
    EXPECT_FALSE(camera.lift(4, 4));
    for (const float invalid : {0.0F, -1.0F, 100.0F, std::numeric_limits<float>::infinity()}) {
        camera.depth.metres.assign(81, invalid);
        EXPECT_FALSE(camera.lift(4, 4));
    }
    camera.depth.metres.assign(81, 1);
    camera.depth.metres[4 * 9 + 4] = nan;  // a single pixel that failed
    EXPECT_TRUE(camera.lift(4, 4));
    camera.depth.metres[4 * 9 + 3] = 7;  // and one that lies
    EXPECT_EQ(camera.lift(4, 4)->z, 1);
    EXPECT_TRUE(camera.lift(0, 0) && camera.lift(8, 8));
    for (const double out : {-1.0, 9.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_FALSE(camera.lift(out, 4)) << out;
        EXPECT_FALSE(camera.lift(4, out)) << out;
    }
    camera.depth = {};
    EXPECT_FALSE(camera.lift(0, 0));
    EXPECT_NO_THROW(camera.check());
    camera.depth.width = 3;
    camera.depth.height = 3;
    EXPECT_THROW(camera.check(), PerceptionError);
}

}  // namespace
}  // namespace praxis::belief
