// A small trained classifier: which atoms hold, from pixels.
//
// Its input is a coarse grid of mean colours of each view; one hidden layer (rectified) leads to three
// outputs per atom: holds, does not hold, cannot be told. Trained by stochastic gradient descent on labelled
// looks, rendered or real. On looks that it was not trained on, it measures how often it is right about each
// atom, which becomes the accuracy of its readings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "belief/percept.hpp"
#include "belief/perception/image.hpp"

namespace praxis::belief {

/// Mean colours of a grid over each image, -1 to 1: columns * rows * 3 values an image. Images smaller than
/// the grid are sampled.
std::vector<float> colour_grid(std::span<const Image> images, std::size_t columns = 16,
                               std::size_t rows = 12);

struct LabelledLook {
    std::vector<float> features;
    std::vector<Truth> labels;  ///< per atom
};

struct ClassifierOptions {
    std::size_t hidden = 24;
    int epochs = 8;
    float rate = 0.02F;      ///< of learning, at first; falls to a tenth
    double certainty = 0.7;  ///< what is less probable than this is unknown
    std::uint64_t seed = 0;  ///< the same seed and looks give the same classifier
};

class PixelClassifier {
  public:
    struct Judgement {
        Truth value = Truth::unknown;
        double probability = 1;  ///< as the network believes
    };

    PixelClassifier(std::vector<AtomName> atoms, std::size_t features, ClassifierOptions options = {});

    /// Trains from the beginning. Throws PerceptionError if there is no look, or one of the wrong size.
    void train(std::span<const LabelledLook> looks);

    /// A judgement per atom. Throws PerceptionError if the features are of the wrong size.
    std::vector<Judgement> judge(std::span<const float> features) const;

    /// Measures accuracies on looks that were not trained on: of the times an atom was judged true or false,
    /// the share in which its label was the same (with one imagined success and one failure: Laplace).
    void calibrate(std::span<const LabelledLook> looks);

    const std::vector<AtomName>& atoms() const { return atoms_; }
    /// Measured by `calibrate`, by atom; at least 0.51.
    const std::vector<double>& accuracies() const { return accuracies_; }

  private:
    void check(std::span<const LabelledLook> looks) const;
    void standardise(std::span<const LabelledLook> looks);
    std::vector<float> standardised(std::span<const float> features) const;
    void run(std::span<const float> input, std::vector<float>& hidden, std::vector<float>& outputs) const;
    void learn(const LabelledLook& look, float rate);

    std::vector<AtomName> atoms_;
    std::size_t features_;
    ClassifierOptions options_;
    std::vector<float> mean_, scale_;          ///< of the features: (x - mean) * scale
    std::vector<float> first_, first_bias_;    ///< hidden * features
    std::vector<float> second_, second_bias_;  ///< (3 * atoms) * hidden
    std::vector<double> accuracies_;
};

}  // namespace praxis::belief
