// A vision-language model as the observer of simulated worlds, set up by a file: which service, what is
// asked, what a world looks like, where the answers are kept.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "belief/perception/recorded_model.hpp"
#include "belief/perception/scene_settings.hpp"
#include "belief/perception/vision_model.hpp"
#include "belief/perception/vision_observer.hpp"

namespace praxis::belief {

struct SceneObserverSettings {
    VisionModelOptions service;
    struct Record {
        std::filesystem::path file;
        RecordMode mode = RecordMode::cache;
    };
    std::optional<Record> record;
    VisionObserverOptions observer;
    SceneDescription scene;
};

/// Reads a file (docs/perception.md has its members). The file of records is beside it, unless its path is
/// absolute. Throws PerceptionError, naming the place.
SceneObserverSettings read_scene_observer(const std::filesystem::path& file);

/// One service for any number of worlds.
class SceneObservers {
  public:
    using Holds = std::function<bool(const AtomName&)>;

    /// Throws PerceptionError if a setting makes no sense.
    explicit SceneObservers(SceneObserverSettings settings);

    /// An observer of the world in which `holds` says at any time whether an atom holds; it is asked at once
    /// about every atom of the scene, and may refuse one by throwing. Refers to this and to `holds`' world.
    std::unique_ptr<Observer> look_at(const Holds& holds) const;

    /// What the service has used up.
    VisionModelCounters counters() const { return model_ ? model_->counters() : VisionModelCounters{}; }
    /// Answers that came from the file of records.
    std::int64_t replayed() const { return recorded_ ? recorded_->replayed() : 0; }

  private:
    SceneObserverSettings settings_;
    std::unique_ptr<VisionModel> model_;  ///< null if all is replayed
    std::unique_ptr<RecordedModel> recorded_;
};

}  // namespace praxis::belief
