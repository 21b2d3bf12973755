#include "belief/perception/classifier.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include "belief/perception/errors.hpp"

namespace praxis::belief {
namespace {

constexpr std::size_t kClasses = 3;  // as the values of Truth

/// Softmax of three outputs.
std::array<float, kClasses> probabilities(const float* outputs) {
    const float most = std::max({outputs[0], outputs[1], outputs[2]});
    std::array<float, kClasses> result{};
    float sum = 0;
    for (std::size_t i = 0; i < kClasses; ++i) sum += result[i] = std::exp(outputs[i] - most);
    for (float& share : result) share /= sum;
    return result;
}

/// Sums in lanes of their own, so that the compiler may use vectors without reordering anything.
float dot(const float* a, const float* b, std::size_t size) {
    constexpr std::size_t kLanes = 8;
    std::array<float, kLanes> sums{};
    const std::size_t whole = size / kLanes * kLanes;
    for (std::size_t i = 0; i < whole; i += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) sums[lane] += a[i + lane] * b[i + lane];
    }
    float sum = 0;
    for (const float lane : sums) sum += lane;
    for (std::size_t i = whole; i < size; ++i) sum += a[i] * b[i];
    return sum;
}

}  // namespace

std::vector<float> colour_grid(std::span<const Image> images, std::size_t columns, std::size_t rows) {
    std::vector<float> features;
    features.reserve(images.size() * columns * rows * 3);
    for (const Image& image : images) {
        if (image.width == 0 || image.height == 0) throw PerceptionError("an image without pixels");
        for (std::size_t row = 0; row < rows; ++row) {
            const std::size_t top = row * image.height / rows;
            const std::size_t bottom = std::max((row + 1) * image.height / rows, top + 1);
            for (std::size_t column = 0; column < columns; ++column) {
                const std::size_t left = column * image.width / columns;
                const std::size_t right = std::max((column + 1) * image.width / columns, left + 1);
                std::array<float, 3> sum{};
                for (std::size_t y = top; y < bottom; ++y) {
                    for (std::size_t x = left; x < right; ++x) {
                        const Colour colour = image.at(x, y);
                        for (std::size_t i = 0; i < 3; ++i) sum[i] += static_cast<float>(colour[i]);
                    }
                }
                const auto pixels = static_cast<float>((bottom - top) * (right - left));
                for (const float channel : sum) features.push_back(channel / pixels / 127.5F - 1);
            }
        }
    }
    return features;
}

PixelClassifier::PixelClassifier(std::vector<AtomName> atoms, std::size_t features, ClassifierOptions options)
    : atoms_(std::move(atoms)),
      features_(features),
      options_(options),
      mean_(features, 0),
      scale_(features, 1),
      first_(options.hidden * features, 0),
      first_bias_(options.hidden, 0),
      second_(kClasses * atoms_.size() * options.hidden, 0),
      second_bias_(kClasses * atoms_.size(), 0),
      accuracies_(atoms_.size(), 0.51) {
    if (options.hidden == 0 || options.epochs < 1 || !(options.rate > 0)) {
        throw PerceptionError("a classifier needs hidden units, epochs and a positive rate of learning");
    }
}

void PixelClassifier::check(std::span<const LabelledLook> looks) const {
    if (looks.empty()) throw PerceptionError("a classifier needs looks to learn from");
    for (const LabelledLook& look : looks) {
        if (look.features.size() != features_ || look.labels.size() != atoms_.size()) {
            throw PerceptionError("a labelled look has " + std::to_string(look.features.size()) +
                                  " features and " + std::to_string(look.labels.size()) +
                                  " labels; needed are " + std::to_string(features_) + " and " +
                                  std::to_string(atoms_.size()));
        }
    }
}

void PixelClassifier::standardise(std::span<const LabelledLook> looks) {
    const auto count = static_cast<float>(looks.size());
    std::vector<float> squares(features_, 0);
    mean_.assign(features_, 0);
    for (const LabelledLook& look : looks) {
        for (std::size_t i = 0; i < features_; ++i) mean_[i] += look.features[i] / count;
    }
    for (const LabelledLook& look : looks) {
        for (std::size_t i = 0; i < features_; ++i) {
            const float difference = look.features[i] - mean_[i];
            squares[i] += difference * difference / count;
        }
    }
    // What hardly ever changes is noise: it is not blown up.
    for (std::size_t i = 0; i < features_; ++i) scale_[i] = 1 / (std::sqrt(squares[i]) + 0.03F);
}

std::vector<float> PixelClassifier::standardised(std::span<const float> features) const {
    std::vector<float> input(features_);
    for (std::size_t i = 0; i < features_; ++i) input[i] = (features[i] - mean_[i]) * scale_[i];
    return input;
}

void PixelClassifier::run(std::span<const float> input, std::vector<float>& hidden,
                          std::vector<float>& outputs) const {
    hidden.resize(options_.hidden);
    outputs.resize(second_bias_.size());
    for (std::size_t j = 0; j < hidden.size(); ++j) {
        hidden[j] =
            std::max(first_bias_[j] + dot(input.data(), first_.data() + j * features_, features_), 0.0F);
    }
    for (std::size_t k = 0; k < outputs.size(); ++k) {
        outputs[k] = second_bias_[k] + dot(hidden.data(), second_.data() + k * hidden.size(), hidden.size());
    }
}

void PixelClassifier::learn(const LabelledLook& look, float rate) {
    // `look.features` are standardised already.
    std::vector<float> hidden;
    std::vector<float> slopes;
    run(look.features, hidden, slopes);
    for (std::size_t atom = 0; atom < atoms_.size(); ++atom) {
        const auto shares = probabilities(slopes.data() + atom * kClasses);
        for (std::size_t i = 0; i < kClasses; ++i) {
            const bool right = static_cast<std::size_t>(look.labels[atom]) == i;
            slopes[atom * kClasses + i] = shares[i] - (right ? 1.0F : 0.0F);
        }
    }
    std::vector<float> hidden_slopes(hidden.size(), 0);
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        float* weights = second_.data() + k * hidden.size();
        const float step = rate * slopes[k];
        for (std::size_t j = 0; j < hidden.size(); ++j) {
            hidden_slopes[j] += slopes[k] * weights[j];
            weights[j] -= step * hidden[j];
        }
        second_bias_[k] -= step;
    }
    for (std::size_t j = 0; j < hidden.size(); ++j) {
        if (hidden[j] <= 0) continue;
        float* weights = first_.data() + j * features_;
        const float step = rate * hidden_slopes[j];
        for (std::size_t i = 0; i < features_; ++i) weights[i] -= step * look.features[i];
        first_bias_[j] -= step;
    }
}

void PixelClassifier::train(std::span<const LabelledLook> looks) {
    check(looks);
    standardise(looks);
    std::vector<LabelledLook> samples;
    samples.reserve(looks.size());
    for (const LabelledLook& look : looks) samples.push_back({standardised(look.features), look.labels});

    std::mt19937_64 random(options_.seed);
    const auto fill = [&random](std::vector<float>& weights, std::size_t inputs) {
        std::normal_distribution<float> normal(0, std::sqrt(1.0F / static_cast<float>(inputs)));
        for (float& weight : weights) weight = normal(random);
    };
    fill(first_, features_);
    fill(second_, options_.hidden);
    std::ranges::fill(first_bias_, 0.0F);
    std::ranges::fill(second_bias_, 0.0F);
    std::vector<std::size_t> order(samples.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const float start = options_.rate / std::sqrt(static_cast<float>(features_) / 100.0F);
    for (int epoch = 0; epoch < options_.epochs; ++epoch) {
        std::ranges::shuffle(order, random);
        const float done = static_cast<float>(epoch) / static_cast<float>(options_.epochs);
        for (const std::size_t sample : order) learn(samples[sample], start * (1 - 0.9F * done));
    }
}

std::vector<PixelClassifier::Judgement> PixelClassifier::judge(std::span<const float> features) const {
    if (features.size() != features_) {
        throw PerceptionError("a look has " + std::to_string(features.size()) +
                              " features; the classifier knows " + std::to_string(features_));
    }
    std::vector<float> hidden;
    std::vector<float> outputs;
    run(standardised(features), hidden, outputs);
    std::vector<Judgement> result;
    for (std::size_t atom = 0; atom < atoms_.size(); ++atom) {
        const auto shares = probabilities(outputs.data() + atom * kClasses);
        const auto best = std::ranges::max_element(shares);
        const double probability = static_cast<double>(*best);
        const auto value = static_cast<Truth>(best - shares.begin());
        result.push_back({probability < options_.certainty ? Truth::unknown : value, probability});
    }
    return result;
}

void PixelClassifier::calibrate(std::span<const LabelledLook> looks) {
    check(looks);
    std::vector<int> told(atoms_.size(), 0);
    std::vector<int> right(atoms_.size(), 0);
    for (const LabelledLook& look : looks) {
        const auto judgements = judge(look.features);
        for (std::size_t atom = 0; atom < atoms_.size(); ++atom) {
            if (judgements[atom].value == Truth::unknown) continue;
            ++told[atom];
            if (judgements[atom].value == look.labels[atom]) ++right[atom];
        }
    }
    for (std::size_t atom = 0; atom < atoms_.size(); ++atom) {
        accuracies_[atom] = std::max((right[atom] + 1.0) / (told[atom] + 2.0), 0.51);
    }
}

}  // namespace praxis::belief
