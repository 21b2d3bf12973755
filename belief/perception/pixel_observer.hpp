// An observer without any service: a trained classifier reads atoms from the images, coloured spots are
// detected as objects.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "belief/perception/classifier.hpp"
#include "belief/perception/object_memory.hpp"
#include "belief/perception/vision_observer.hpp"
#include "belief/robot.hpp"

namespace praxis::belief {

struct Spot {
    std::array<double, 2> pixel{};  ///< its middle: column, row
    std::size_t pixels = 0;
};

/// Connected areas (by edges) of at least `fewest` pixels in which every channel is within `tolerance` of the
/// colour, by rows and columns of their first pixels.
std::vector<Spot> find_spots(const Image& image, Colour colour, int tolerance, std::size_t fewest);

/// Objects of a type are spots of a colour.
struct SpotType {
    std::string type;
    Colour colour{};
    int tolerance = 30;
    std::size_t fewest = 12;  ///< pixels
    std::string view;         ///< the view they are looked for in; it must have depth
};

class PixelObserver : public Observer {
  public:
    /// `images` and `classifier` must outlive the observer.
    PixelObserver(ImageSource& images, const PixelClassifier& classifier, std::vector<SpotType> spots = {},
                  ObjectMemoryOptions memory = {});

    /// Readings of the atoms asked for that the classifier knows, with its measured accuracies; detections of
    /// spots. Throws PerceptionError if the images are not those that the classifier was trained for.
    Percept observe(const ObservationRequest& request, std::stop_token stop) override;

    ObjectMemory& memory() { return memory_; }

  private:
    ImageSource& images_;
    const PixelClassifier& classifier_;
    std::vector<SpotType> spots_;
    ObjectMemory memory_;
    std::int64_t step_ = 0;
};

}  // namespace praxis::belief
