// An observer that looks through cameras and asks a vision-language model what it sees.
//
// After each action, all atoms in question go to the model in one prompt with the images of all views. Its
// answers become readings of a given accuracy; what it sees becomes detections, lifted into the world where
// the view has depth, and named by an object memory so that a thing keeps its name from look to look.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "belief/perception/chat.hpp"
#include "belief/perception/depth_camera.hpp"
#include "belief/perception/object_memory.hpp"
#include "belief/perception/questions.hpp"
#include "belief/robot.hpp"

namespace praxis::belief {

struct View {
    std::string name;                  ///< "top", "wrist"; different for each view
    std::string image;                 ///< the bytes of a PNG or JPEG file
    std::optional<DepthCamera> depth;  ///< of the same pixels as the image
};

class ImageSource {
  public:
    virtual ~ImageSource() = default;
    /// The present moment as all cameras see it. Throws PerceptionError if they do not work.
    virtual std::vector<View> look(std::stop_token stop) = 0;
};

struct VisionObserverOptions {
    QuestionTexts texts;
    double accuracy = 0.95;       ///< of answers; above 0.5, at most 1
    std::size_t questions = 200;  ///< per prompt, at most
    int attempts = 3;             ///< prompts for one answer that can be read
    ObjectMemoryOptions memory;
    std::function<void(const std::string&)> warn;  ///< told what was left out of an answer, and why
};

class VisionObserver : public Observer {
  public:
    /// Both must outlive the observer. Throws PerceptionError if an option makes no sense.
    VisionObserver(ChatModel& model, ImageSource& images, VisionObserverOptions options);

    /// A reading for each different atom asked for (of predicates that are to be asked), and the detections,
    /// one for each object seen. If the model never answers in the form asked for, all readings are unknown.
    /// Throws PerceptionError if the model or the cameras are out of order, StoppedError if `stop` asks.
    Percept observe(const ObservationRequest& request, std::stop_token stop) override;

    /// The objects seen; add those that the task knows, with their types, before the first look.
    ObjectMemory& memory() { return memory_; }

  private:
    QuestionAnswers ask(const std::vector<View>& views, std::span<const std::string> names,
                        std::span<const std::string> objects, std::span<const AtomName> questions,
                        const std::stop_token& stop);
    void detect(const std::vector<View>& views, const std::vector<SeenObject>& seen,
                std::span<const std::string> objects, Percept& percept);
    double accuracy_of(const AtomName& atom) const;
    void warn(const std::string& text) const;

    ChatModel& model_;
    ImageSource& images_;
    VisionObserverOptions options_;
    ObjectMemory memory_;
    std::int64_t step_ = 0;
};

}  // namespace praxis::belief
