// An observer set up by a file: its settings, its pictures, its records.
#include "belief/perception/scene_observer.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "belief/perception/settings.hpp"
#include "tests/belief/perception/chat_server.hpp"
#include "tests/belief/perception/support.hpp"

namespace praxis::belief {
namespace {

using test::ChatServer;
using test::contains;
using test::perception_error;
using test::says;
using Json = nlohmann::json;

constexpr Colour kRed{220, 40, 40};

Json settings(const std::string& url = "http://127.0.0.1:1/v1") {
    return Json::parse(R"json({
      "service": {"url": ")json" +
                       url + R"json(", "model": "m", "timeout": 5, "attempts": 1,
                  "prompt_price": 10, "completion_price": 10},
      "record": {"file": "answers.jsonl"},
      "questions": {"accuracy": 0.9, "predicates": {"inside": {"sentence": "Is {0} inside {1}?"}},
                    "objects": {"cup": "the red cup"}},
      "scene": {
        "cameras": [{"name": "top", "side": "above", "centre": [0, 0, 0], "distance": 1.5, "visible": 1.3,
                     "width": 80, "height": 60}],
        "bodies": [
          {"name": "drawer", "shape": "drawer", "colour": [130, 90, 50], "size": [0.3, 0.2, 0.15],
           "at": [-0.3, 0.2, 0], "open": "(open drawer)"},
          {"name": "cup", "shape": "cylinder", "colour": [220, 40, 40], "size": [0.1, 0.1, 0.08],
           "places": [{"if": "(inside cup drawer)", "at": [-0.3, 0.2, 0.02]},
                      {"if": "(held cup)", "at": [0.3, -0.2, 0]}]}]}})json");
}

class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "praxis-XXXXXX").string();
        path_ = ::mkdtemp(name.data());
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::filesystem::path write(const Json& json) const {
        std::ofstream(path_ / "observer.json") << json.dump();
        return path_ / "observer.json";
    }

  private:
    std::filesystem::path path_;
};

std::size_t red_pixels(const SceneDescription& description, bool inside, bool open) {
    const Scene scene = scene_of(description, [&](const AtomName& atom) {
        if (atom.words[0] == "open") return open;
        return atom == AtomName{{"inside", "cup", "drawer"}} && inside;
    });
    const Image image = render(scene, description.cameras[0]).image;
    std::size_t count = 0;
    for (std::size_t y = 0; y < image.height; ++y)
        for (std::size_t x = 0; x < image.width; ++x) count += image.at(x, y) == kRed;
    return count;
}

TEST(SceneSettings, BodiesStandWhereAtomsSay) {
    const SceneDescription scene = read_scene(Settings::parse(settings()["scene"].dump(), "s"));
    EXPECT_GT(red_pixels(scene, true, true), 10u);
    EXPECT_EQ(red_pixels(scene, true, false), 0u);  // the drawer is shut
    EXPECT_EQ(red_pixels(scene, false, true), 0u);
}

TEST(SceneObservers, AskTheServiceOnceAndReplayWithoutIt) {
    const Folder folder;
    Json json;
    std::size_t requests = 0;
    const AtomName inside{{"inside", "cup", "drawer"}};
    const std::vector<std::string> objects{"cup", "drawer"};
    const ObservationRequest request{nullptr, std::span(&inside, 1), objects};
    const auto holds = [](const AtomName& atom) { return atom.words[0] != "held"; };
    {
        ChatServer server([&](const test::ReceivedRequest& received, std::size_t) {
            ++requests;
            EXPECT_TRUE(contains(received.body, "Is cup inside drawer?"));
            EXPECT_TRUE(contains(received.body, "data:image/png;base64,"));
            EXPECT_TRUE(contains(received.body, "the red cup"));
            return says(R"({"answers": [{"question": 1, "answer": "true"}]})");
        });
        json = settings(server.base());
        const SceneObservers observers(read_scene_observer(folder.write(json)));
        for (int look = 0; look < 2; ++look) {
            const Percept percept = observers.look_at(holds)->observe(request, {});
            ASSERT_EQ(percept.readings.size(), 1u);
            EXPECT_EQ(percept.readings[0].value, Truth::known_true);
            EXPECT_EQ(percept.readings[0].accuracy, 0.9);
        }
        EXPECT_EQ(observers.counters().requests, 1);
        EXPECT_EQ(observers.replayed(), 1);
    }
    json["record"]["mode"] = "replay";
    json["service"].erase("url");
    const SceneObservers offline(read_scene_observer(folder.write(json)));
    EXPECT_EQ(offline.look_at(holds)->observe(request, {}).readings[0].value, Truth::known_true);
    EXPECT_EQ(requests, 1u);
    // Another picture is another question.
    const auto nothing = [](const AtomName&) { return false; };
    EXPECT_NE(perception_error([&] { offline.look_at(nothing)->observe(request, {}); }), "");
}

TEST(SceneObservers, StopAtTheCostLimit) {
    ChatServer server([](const auto&, std::size_t) { return says("{\"answers\": []}", 100'000, 0); });
    const Folder folder;
    Json json = settings(server.base());
    json.erase("record");
    json["service"]["cost_limit"] = 1.5;  // an answer costs 1
    const SceneObservers observers(read_scene_observer(folder.write(json)));
    const AtomName inside{{"inside", "cup", "drawer"}};
    const ObservationRequest request{nullptr, std::span(&inside, 1), {}};
    const auto observer = observers.look_at([](const AtomName&) { return false; });
    EXPECT_TRUE(contains(perception_error([&] {
                             observer->observe(request, {});
                             observer->observe(request, {});
                         }),
                         "the limit is 1.5"));
    EXPECT_EQ(observers.counters().requests, 2);
}

TEST(SceneObservers, MayRefuseAtomsOfTheScene) {
    const Folder folder;
    const SceneObservers observers(read_scene_observer(folder.write(settings())));
    EXPECT_THROW(
        observers.look_at([](const AtomName&) -> bool { throw std::invalid_argument("no such atom"); }),
        std::invalid_argument);
}

TEST(SceneObservers, ErrorsNameThePlace) {
    const auto broken = [](const std::string& pointer, const Json& value) {
        const Folder folder;
        Json json = settings();
        json[Json::json_pointer(pointer)] = value;
        return perception_error([&] { SceneObservers(read_scene_observer(folder.write(json))); });
    };
    EXPECT_TRUE(contains(broken("/service/attempts", 0), "'service': 'attempts' must be a whole number"));
    EXPECT_TRUE(contains(broken("/service/timeout", "long"), "'timeout' must be a number"));
    EXPECT_TRUE(contains(broken("/service/modell", "m"), "'modell' is not a setting"));
    EXPECT_TRUE(contains(broken("/service/url", "ftp://x"), "ftp://x"));
    EXPECT_TRUE(contains(broken("/record/mode", "sometimes"), "must be record, cache or replay"));
    EXPECT_TRUE(contains(broken("/questions/accuracy", 0.4), "'accuracy' must be a number"));
    EXPECT_TRUE(contains(broken("/questions/objects/cup", 3), "'cup' must be a text"));
    EXPECT_TRUE(
        contains(broken("/scene/bodies/0/colour", {1, 2}), "'bodies' 1: 'colour' must be a list of 3"));
    EXPECT_TRUE(contains(broken("/scene/bodies/0/shape", "egg"), "must be cylinder, box, tray or drawer"));
    EXPECT_TRUE(contains(broken("/scene/bodies/0/open", "open drawer"), "must be an atom"));
    EXPECT_TRUE(contains(broken("/scene/bodies/1/places", Json::array()), "must be a list of objects"));
    EXPECT_TRUE(contains(broken("/scene/cameras/0/side", "below"), "must be above or front"));
    EXPECT_TRUE(contains(broken("/scene", 7), "'scene' must be an object"));
    EXPECT_TRUE(contains(perception_error([] { read_scene_observer("/nowhere/o.json"); }), "cannot read"));
    EXPECT_TRUE(
        contains(perception_error([] { Settings::parse("{]", "o.json"); }), "o.json: no JSON object"));
}

}  // namespace
}  // namespace praxis::belief
