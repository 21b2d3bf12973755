#include "belief/perception/scene_observer.hpp"

#include <fstream>
#include <sstream>
#include <utility>

#include "belief/perception/settings.hpp"

namespace praxis::belief {
namespace {

constexpr double kMostSeconds = 3600;
constexpr double kMostCost = 1e9;

std::chrono::milliseconds milliseconds_of(double seconds) {
    return std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000));
}

VisionModelOptions service_of(Settings settings) {
    VisionModelOptions service;
    service.base = settings.text("url", service.base);
    service.model = settings.text("model");
    service.key_variable = settings.text("key_variable", "");
    service.limits.timeout = milliseconds_of(settings.number("timeout", 0.001, kMostSeconds, 60));
    service.limits.certificates = settings.text("certificates", "");
    service.attempts = static_cast<int>(settings.whole("attempts", 1, 100, service.attempts));
    service.longest_pause = milliseconds_of(settings.number("longest_pause", 0, kMostSeconds, 30));
    service.temperature = settings.number("temperature", 0, 2, 0);
    if (!settings.flag("send_temperature", true)) service.temperature = std::nullopt;
    service.json = settings.flag("json", true);
    service.more = settings.raw("more");
    service.prompt_price = settings.number("prompt_price", 0, kMostCost, 0);
    service.completion_price = settings.number("completion_price", 0, kMostCost, 0);
    if (settings.has("cost_limit")) service.cost_limit = settings.number("cost_limit", 0, kMostCost);
    settings.finish();
    return service;
}

SceneObserverSettings::Record record_of(Settings settings, const std::filesystem::path& folder) {
    SceneObserverSettings::Record record;
    record.file = folder / settings.text("file");
    const std::string mode = settings.text("mode", "cache");
    if (mode != "record" && mode != "cache" && mode != "replay")
        settings.fail("mode", "must be record, cache or replay");
    record.mode = mode == "record"  ? RecordMode::record
                  : mode == "cache" ? RecordMode::cache
                                    : RecordMode::replay;
    settings.finish();
    return record;
}

VisionObserverOptions questions_of(Settings settings) {
    constexpr double kLeast = 0.5 + 1e-9;
    VisionObserverOptions observer;
    observer.accuracy = settings.number("accuracy", kLeast, 1, observer.accuracy);
    observer.attempts = static_cast<int>(settings.whole("attempts", 1, 100, observer.attempts));
    observer.questions = static_cast<std::size_t>(settings.whole("at_once", 1, 10'000, 200));
    observer.texts.remarks = settings.text("remarks", "");
    for (auto& [name, predicate] : settings.named_objects("predicates")) {
        PredicateQuestion& question = observer.texts.predicates[name];
        question.sentence = predicate.text("sentence", "");
        question.ask = predicate.flag("ask", true);
        if (predicate.has("accuracy")) question.accuracy = predicate.number("accuracy", kLeast, 1);
        predicate.finish();
    }
    for (const auto& [name, words] : settings.named_texts("objects")) observer.texts.objects[name] = words;
    settings.finish();
    return observer;
}

}  // namespace

SceneObserverSettings read_scene_observer(const std::filesystem::path& file) {
    std::ostringstream text;
    std::ifstream in(file, std::ios::binary);
    if (!in || !(text << in.rdbuf())) throw PerceptionError("cannot read '" + file.string() + '\'');
    Settings settings = Settings::parse(text.str(), file.string());
    SceneObserverSettings result;
    result.service = service_of(settings.object("service"));
    if (settings.has("record")) result.record = record_of(settings.object("record"), file.parent_path());
    if (settings.has("questions")) result.observer = questions_of(settings.object("questions"));
    result.scene = read_scene(settings.object("scene"));
    settings.finish();
    return result;
}

SceneObservers::SceneObservers(SceneObserverSettings settings) : settings_(std::move(settings)) {
    const auto& record = settings_.record;
    if (!record || record->mode != RecordMode::replay)
        model_ = std::make_unique<VisionModel>(settings_.service);
    if (record)
        recorded_ = std::make_unique<RecordedModel>(record->file, record->mode, settings_.service.model,
                                                    model_.get());
}

std::unique_ptr<Observer> SceneObservers::look_at(const Holds& holds) const {
    for (const DescribedBody& body : settings_.scene.bodies) {
        if (body.open) holds(*body.open);
        for (const DescribedBody::Place& place : body.places)
            if (place.atom) holds(*place.atom);
    }
    struct Camera {
        explicit Camera(SceneSource source) : images(std::move(source)) {}
        SceneSource images;
    };
    class SceneObserver : private Camera, public VisionObserver {
      public:
        SceneObserver(ChatModel& model, SceneSource source, const VisionObserverOptions& options)
            : Camera(std::move(source)), VisionObserver(model, images, options) {}
    };
    SceneSource source([scene = settings_.scene, holds] { return scene_of(scene, holds); },
                       settings_.scene.cameras, settings_.scene.noise);
    ChatModel& model = recorded_ ? static_cast<ChatModel&>(*recorded_) : *model_;
    return std::make_unique<SceneObserver>(model, std::move(source), settings_.observer);
}

}  // namespace praxis::belief
