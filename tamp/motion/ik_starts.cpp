#include "tamp/motion/ik_starts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "search/engines/random.hpp"

namespace praxis::tamp {

EvenSequence::EvenSequence(std::size_t dimension) {
    // The ratio solves g^(d+1) = g + 1.
    double ratio = 1.5;
    for (int i = 0; i < 64; ++i) ratio = std::pow(1 + ratio, 1 / (static_cast<double>(dimension) + 1));
    double power = 1;
    for (std::size_t j = 0; j < dimension; ++j) steps_[j] = power /= ratio;
}

double EvenSequence::operator()(std::uint64_t index, std::size_t coordinate) const {
    const double value = 0.5 + steps_[coordinate] * static_cast<double>(index);
    return value - std::floor(value);
}

IkStarts::IkStarts(const KinematicChain& chain, const Columns& lower, const Columns& upper,
                   const Columns& rest) {
    const std::size_t dimension = chain.columns();
    const EvenSequence sequence(dimension);
    positions_.resize(kCount);
    for (std::vector<float>& numbers : reached_) numbers.reserve(kCount);
    for (std::size_t i = 0; i < kCount; ++i) {
        Columns& positions = positions_[i];
        for (std::size_t j = 0; j < dimension; ++j) {
            const double low = std::isfinite(lower[j]) ? lower[j] : rest[j] - 1;
            const double high = std::isfinite(upper[j]) ? upper[j] : rest[j] + 1;
            positions[j] = std::clamp(low + sequence(i, j) * (high - low), lower[j], upper[j]);
        }
        const Frame frame = chain.forward(positions.data());
        for (std::size_t k = 0; k < 3; ++k) {
            reached_[k].push_back(static_cast<float>(frame.origin[k]));
            reached_[k + 3].push_back(static_cast<float>(frame.x[k]));
            reached_[k + 6].push_back(static_cast<float>(frame.z[k]));
        }
    }
}

IkStarts::Order::Order(const IkStarts& starts, const IkDescent& problem, std::uint64_t seed) {
    constexpr float kAxisWeight = 0.25F;
    const bool with_x = problem.task == IkTask::pose;
    const bool with_z = problem.task != IkTask::position;
    distance_.fill(0);
    for (std::size_t k = 0; k < 9; ++k) {
        if ((k >= 3 && k < 6 && !with_x) || (k >= 6 && !with_z)) continue;
        const Frame& target = problem.target;
        const double wanted = k < 3 ? target.origin[k] : k < 6 ? target.x[k - 3] : target.z[k - 6];
        const auto value = static_cast<float>(wanted);
        const float weight = k < 3 ? 1 : kAxisWeight;
        const float* reached = starts.reached_[k].data();
        for (std::size_t i = 0; i < kCount; ++i) {
            const float difference = reached[i] - value;
            distance_[i] += weight * difference * difference;
        }
    }
    if (seed == 0) return;
    Random random(seed);
    for (float& distance : distance_) distance *= 1 + 0x1p-62F * 3 * static_cast<float>(random.next() >> 2);
}

std::size_t IkStarts::Order::next() {
    const auto nearest = std::ranges::min_element(distance_);
    if (*nearest == std::numeric_limits<float>::infinity()) return kCount;
    *nearest = std::numeric_limits<float>::infinity();
    return static_cast<std::size_t>(nearest - distance_.begin());
}

}  // namespace praxis::tamp
