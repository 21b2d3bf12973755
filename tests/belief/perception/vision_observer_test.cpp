// The observer from the images to the percept, over a real connection and with every kind of wrong answer.
#include "belief/perception/vision_observer.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "belief/perception/recorded_model.hpp"
#include "belief/perception/vision_model.hpp"
#include "tests/belief/perception/chat_server.hpp"
#include "tests/belief/perception/support.hpp"

namespace praxis::belief {
namespace {

using test::contains;
using test::FunctionModel;
using test::perception_error;

class Images : public ImageSource {
  public:
    std::vector<View> look(std::stop_token) override {
        ++looks;
        return views;
    }
    std::vector<View> views;
    int looks = 0;
};

/// Looks down on a table from one metre: pixel (u, v) is the place ((u - 50) / 100, (v - 50) / 100).
View view_of_table(const std::string& name) {
    DepthCamera camera;
    camera.pinhole = {100, 100, 50, 50};
    camera.depth = {101, 101, std::vector<float>(101 * 101, 1)};
    return {name, test::kPngHead + name, camera};
}

const std::vector<AtomName> kAtoms = {
    {{"open", "drawer"}}, {{"inside", "cup1", "drawer"}}, {{"dirty", "cup1"}}};
const std::vector<std::string> kObjects = {"cup1", "drawer"};

struct Scene {
    Scene() {
        images.views = {view_of_table("top")};
        options.texts.types = {"cup"};
        options.texts.predicates["open"] = {"Is {0} open?", true, 0.75};
        options.texts.predicates["inside"].sentence = "Is {0} inside {1}?";
        options.accuracy = 0.9;
        options.warn = [this](const std::string& text) { warnings += text + '\n'; };
    }
    Percept observe(ChatModel& model) {
        VisionObserver observer(model, images, options);
        return observer.observe({nullptr, kAtoms, kObjects}, {});
    }
    Images images;
    VisionObserverOptions options;
    std::string warnings;
};

std::string answers(const std::vector<std::string>& values,
                    nlohmann::json detections = nlohmann::json::array()) {
    nlohmann::json list = nlohmann::json::array();
    for (std::size_t i = 0; i < values.size(); ++i)
        list.push_back({{"question", i + 1}, {"answer", values[i]}});
    return nlohmann::json{{"answers", list}, {"detections", std::move(detections)}}.dump();
}

nlohmann::json cup(const nlohmann::json& object, const std::string& view, double u, double v) {
    return {{"object", object}, {"type", "cup"}, {"view", view}, {"pixel", {u, v}}};
}

std::vector<Truth> values_of(const Percept& percept) {
    std::vector<Truth> values;
    for (const Reading& reading : percept.readings) values.push_back(reading.value);
    return values;
}

const std::vector<Truth> kAllUnknown(3, Truth::unknown);
const std::vector<Truth> kOneOfEach = {Truth::known_true, Truth::known_false, Truth::unknown};

TEST(VisionObserver, SeesThroughAServerAndThenThroughItsRecord) {
    const test::TemporaryFile file;
    Scene scene;
    Percept first;
    {
        test::ChatServer server([](const test::ReceivedRequest& request, auto) {
            const auto content = nlohmann::json::parse(request.body)["messages"][1]["content"];
            const std::string prompt = content[0]["text"];
            const bool right = content.size() == 2 &&
                               contains(prompt, "1. Is drawer open?\n2. Is cup1 inside drawer?\n") &&
                               contains(prompt, "3. Is (dirty cup1) true?");
            return test::says(right ? answers({"true", "false", "unknown"},
                                              nlohmann::json::array({cup("cup1", "top", 60, 40)}))
                                    : "confused");
        });
        VisionModelOptions options;
        options.base = server.base();
        options.model = "eye";
        VisionModel model(options);
        RecordedModel recorder(file.path(), RecordMode::record, "eye", &model);
        first = scene.observe(recorder);
    }
    ASSERT_EQ(first.readings.size(), 3U);
    EXPECT_EQ(first.readings[1].atom, kAtoms[1]);
    EXPECT_EQ(values_of(first), kOneOfEach);
    EXPECT_EQ(first.readings[0].accuracy, 0.75);
    EXPECT_EQ(first.readings[1].accuracy, 0.9);
    ASSERT_EQ(first.detections.size(), 1U);
    EXPECT_EQ(first.detections[0].object, "cup1");
    EXPECT_NEAR(first.detections[0].position->x, 0.1, 1e-9);
    EXPECT_NEAR(first.detections[0].position->y, -0.1, 1e-9);
    EXPECT_NEAR(first.detections[0].position->z, 1, 1e-9);
    EXPECT_EQ(scene.warnings, "");

    RecordedModel replay(file.path(), RecordMode::replay, "eye");
    EXPECT_EQ(values_of(scene.observe(replay)), kOneOfEach);
    scene.images.views[0].image += "moved";
    EXPECT_TRUE(contains(perception_error([&] { scene.observe(replay); }), "no answer"));
}

TEST(VisionObserver, AsksAgainWithTheErrorAndThenGivesUp) {
    Scene scene;
    std::string told;
    FunctionModel mended([&](const auto& messages) {
        if (messages.size() == 2) return std::string("The drawer is open.");
        told = messages.back().text;
        return answers({"true", "false", "unknown"});
    });
    EXPECT_EQ(values_of(scene.observe(mended)), kOneOfEach);
    EXPECT_TRUE(contains(told, "cannot be used: not JSON")) << told;
    EXPECT_TRUE(contains(scene.warnings, "not JSON"));

    FunctionModel babbler([](const auto&) { return std::string(1 << 20, 'b'); });
    EXPECT_EQ(values_of(scene.observe(babbler)), kAllUnknown);
    EXPECT_EQ(babbler.asked, 3);
    EXPECT_TRUE(contains(scene.warnings, "no usable answer in 3 attempts"));
}

TEST(VisionObserver, BelievesNoLiar) {
    Scene scene;
    FunctionModel liar([](const auto&) {
        return std::string(R"({"answers":[{"question":1,"answer":"true"},{"question":1,"answer":"false"},)"
                           R"({"question":2,"answer":"false"},{"question":7,"answer":"true"}]})");
    });
    EXPECT_EQ(values_of(scene.observe(liar)),
              (std::vector<Truth>{Truth::unknown, Truth::known_false, Truth::unknown}));
    for (const char* part : {"question 1 has contradicting", "no question 7", "question 3 has no answer"}) {
        EXPECT_TRUE(contains(scene.warnings, part)) << scene.warnings;
    }
}

TEST(VisionObserver, AsksOnlyWhatItMayAndOnce) {
    Scene scene;
    scene.options.texts.predicates["dirty"].ask = false;
    scene.options.questions = 1;
    int most = 0;
    FunctionModel model([&](const auto& messages) {
        most = std::max(most, contains(messages[1].text, "\n2. ") ? 2 : 1);
        return answers({"true"});
    });
    VisionObserver observer(model, scene.images, scene.options);
    const std::vector<AtomName> twice = {kAtoms[0], kAtoms[1], kAtoms[0], kAtoms[2], AtomName{}};
    const Percept percept = observer.observe({nullptr, twice, kObjects}, {});
    EXPECT_EQ(percept.readings.size(), 2U);
    EXPECT_EQ(most, 1);
    EXPECT_EQ(model.asked, 2);
    EXPECT_EQ(scene.images.looks, 1);
}

TEST(VisionObserver, NamesThingsTheSameFromViewToView) {
    Scene scene;
    scene.images.views = {view_of_table("top"), view_of_table("wrist")};
    std::vector<nlohmann::json> script = {
        // Three cups, of which the model names one, and an invented name that means another cup in each view.
        {cup("cup1", "top", 50, 50), cup(nullptr, "top", 70, 50), cup("red", "top", 90, 50),
         cup("red", "wrist", 71, 50), cup(nullptr, "wrist", 50, 51)},
        // Later: one was pushed a little, another was taken away, and the names are gone.
        {cup(nullptr, "wrist", 52, 50), cup(nullptr, "top", 89, 51)}};
    std::size_t turn = 0;
    FunctionModel model([&](const auto&) { return answers({"true", "true", "true"}, script[turn++]); });
    scene.options.memory.gate = 0.06;
    VisionObserver observer(model, scene.images, scene.options);
    const Percept first = observer.observe({nullptr, kAtoms, kObjects}, {});
    ASSERT_EQ(first.detections.size(), 3U);
    EXPECT_EQ(first.detections[0].object, "cup1");
    EXPECT_EQ(first.detections[1].object, "cup2");
    EXPECT_EQ(first.detections[2].object, "cup3");
    const Percept second = observer.observe({nullptr, kAtoms, kObjects}, {});
    ASSERT_EQ(second.detections.size(), 2U);
    EXPECT_EQ(second.detections[0].object, "cup3");
    EXPECT_EQ(second.detections[1].object, "cup1");
    EXPECT_EQ(observer.memory().objects().size(), 3U);
}

TEST(VisionObserver, WithoutDepthNamesMustDo) {
    Scene scene;
    scene.images.views[0].depth.reset();
    FunctionModel model([&](const auto&) {
        return answers({"true", "true", "true"},
                       {cup("cup1", "top", 1, 1), cup("Blue Mug", "top", 2, 2), cup(nullptr, "top", 3, 3)});
    });
    const Percept percept = scene.observe(model);
    ASSERT_EQ(percept.detections.size(), 2U);
    EXPECT_FALSE(percept.detections[0].position);
    EXPECT_EQ(percept.detections[1].object, "blue-mug");
    EXPECT_TRUE(contains(scene.warnings, "neither a name nor a position"));
}

TEST(VisionObserver, TellsWhatIsOutOfOrder) {
    Scene scene;
    FunctionModel model([](const auto&) { return answers({"true", "true", "true"}); });
    scene.images.views.push_back(view_of_table("top"));
    EXPECT_TRUE(contains(perception_error([&] { scene.observe(model); }), "two views are named 'top'"));
    scene.images.views.clear();
    EXPECT_TRUE(contains(perception_error([&] { scene.observe(model); }), "no image"));
    scene.images.views = {view_of_table("top")};
    scene.images.views[0].depth->depth.width = 3;
    EXPECT_TRUE(contains(perception_error([&] { scene.observe(model); }), "depth image"));
    FunctionModel broken([](const auto&) -> std::string { throw PerceptionError("no such host"); });
    scene.images.views = {view_of_table("top")};
    EXPECT_EQ(perception_error([&] { scene.observe(broken); }), "no such host");
    for (const double accuracy : {0.5, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
        scene.options.accuracy = accuracy;
        EXPECT_TRUE(contains(perception_error([&] { scene.observe(model); }), "accuracy"));
    }
}

TEST(VisionObserver, LooksAtNothingWithoutAQuestion) {
    Scene scene;
    scene.options.texts.types.clear();
    FunctionModel model([](const auto&) { return std::string(); });
    VisionObserver observer(model, scene.images, scene.options);
    EXPECT_TRUE(observer.observe({nullptr, {}, kObjects}, {}).readings.empty());
    EXPECT_EQ(scene.images.looks + model.asked, 0);
}

}  // namespace
}  // namespace praxis::belief
