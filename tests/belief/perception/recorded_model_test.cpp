// What is recorded is said again without the model.
#include "belief/perception/recorded_model.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "belief/perception/vision_model.hpp"
#include "tests/belief/perception/chat_server.hpp"
#include "tests/belief/perception/support.hpp"

namespace praxis::belief {
namespace {

using test::contains;
using test::perception_error;
using test::TemporaryFile;

std::vector<Message> question(const std::string& text, const std::string& pixels = "") {
    return {{Role::user, text, {test::kPngHead + pixels}}};
}

TEST(RecordedModel, ReplaysWhatAServerSaidWithoutIt) {
    const TemporaryFile file;
    {
        test::ChatServer server([](const auto&, std::size_t number) {
            return test::says("answer " + std::to_string(number), 7, 3);
        });
        VisionModelOptions options;
        options.base = server.base();
        options.model = "eye";
        VisionModel model(options);
        RecordedModel recorder(file.path(), RecordMode::record, model.name(), &model);
        EXPECT_EQ(recorder.ask(question("a"), {}).text, "answer 0");
        EXPECT_EQ(recorder.ask(question("b"), {}).text, "answer 1");
        EXPECT_EQ(recorder.ask(question("a"), {}).text, "answer 2");
        EXPECT_EQ(recorder.recorded(), 3);
    }
    RecordedModel replay(file.path(), RecordMode::replay, "eye");
    EXPECT_EQ(replay.ask(question("b"), {}).text, "answer 1");
    EXPECT_EQ(replay.ask(question("a"), {}).text, "answer 0");
    EXPECT_EQ(replay.ask(question("a"), {}).text, "answer 2");
    EXPECT_EQ(replay.ask(question("a"), {}).text, "answer 2");
    EXPECT_EQ(replay.ask(question("b"), {}).prompt_tokens, 7);
    EXPECT_EQ(replay.replayed(), 5);
}

TEST(RecordedModel, MissesInReplayAreErrors) {
    const TemporaryFile file;
    test::FunctionModel model([](const auto&) { return "yes"; });
    RecordedModel(file.path(), RecordMode::record, "eye", &model).ask(question("a", "1"), {});
    RecordedModel replay(file.path(), RecordMode::replay, "eye");
    EXPECT_EQ(replay.ask(question("a", "1"), {}).text, "yes");
    for (const auto& other :
         {question("b", "1"), question("a", "2"), std::vector<Message>{{Role::user, "a", {}}},
          std::vector<Message>{{Role::system, "a", {test::kPngHead + "1"}}}}) {
        EXPECT_TRUE(contains(perception_error([&] { replay.ask(other, {}); }), "has no answer of 'eye'"));
    }
    RecordedModel other_model(file.path(), RecordMode::replay, "ear");
    EXPECT_TRUE(contains(perception_error([&] { other_model.ask(question("a", "1"), {}); }), "of 'ear'"));
    EXPECT_TRUE(
        contains(perception_error([] { RecordedModel("/does/not/exist", RecordMode::replay, "eye"); }),
                 "cannot read"));
}

TEST(RecordedModel, CachesAcrossRuns) {
    const TemporaryFile file;
    std::filesystem::remove(file.path());
    test::FunctionModel model([](const auto& messages) { return "about " + messages[0].text; });
    for (int run = 0; run < 3; ++run) {
        RecordedModel cache(file.path(), RecordMode::cache, "eye", &model);
        EXPECT_EQ(cache.ask(question("a"), {}).text, "about a");
        EXPECT_EQ(cache.ask(question("a"), {}).text, "about a");
        EXPECT_EQ(cache.recorded(), run == 0 ? 1 : 0);
    }
    EXPECT_EQ(model.asked, 1);
    const auto line = nlohmann::json::parse(file.read());
    EXPECT_EQ(line["model"], "eye");
    EXPECT_EQ(line["messages"][0]["text"], "a");
    EXPECT_EQ(line["messages"][0]["images"][0].get<std::string>().size(), 64U);
}

TEST(RecordedModel, MendsARecordThatWasCutOff) {
    const TemporaryFile file;
    test::FunctionModel model([](const auto&) { return "yes\n\xff\"no\""; });
    {
        RecordedModel recorder(file.path(), RecordMode::record, "eye", &model);
        recorder.ask(question("a"), {});
        recorder.ask(question("b"), {});
    }
    const std::string whole = file.read();
    for (const std::size_t lost : {std::size_t{1}, std::size_t{2}, std::size_t{40}}) {
        file.write(whole.substr(0, whole.size() - lost));
        {
            RecordedModel cache(file.path(), RecordMode::cache, "eye", &model);
            cache.ask(question("b"), {});
            EXPECT_EQ(cache.recorded(), lost == 1 ? 0 : 1);  // the final newline alone is no loss
            cache.ask(question("c"), {});
        }
        RecordedModel replay(file.path(), RecordMode::replay, "eye");
        for (const char* text : {"a", "b", "c"}) EXPECT_NO_THROW(replay.ask(question(text), {})) << lost;
    }
}

TEST(RecordedModel, RefusesForeignLines) {
    const TemporaryFile file;
    for (const char* line : {"hello", "{}", "[]", R"({"key": 7, "answer": {}})"}) {
        file.write(std::string("\n") + line + "\n\n");
        EXPECT_TRUE(contains(perception_error([&] { RecordedModel(file.path(), RecordMode::replay, "eye"); }),
                             ":2: this line is not an exchange"));
    }
}

TEST(RecordedModel, KeepsNothingOfAFailure) {
    const TemporaryFile file;
    test::FunctionModel model([](const auto&) -> std::string { throw PerceptionError("out of order"); });
    RecordedModel recorder(file.path(), RecordMode::record, "eye", &model);
    EXPECT_EQ(perception_error([&] { recorder.ask(question("a"), {}); }), "out of order");
    EXPECT_EQ(file.read(), "");
    EXPECT_THROW(RecordedModel(file.path(), RecordMode::cache, "eye"), PerceptionError);
}

}  // namespace
}  // namespace praxis::belief
