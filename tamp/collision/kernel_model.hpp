// What the kernel reads, made from a collision problem.
//
// Margins. The kernel computes on floats. Every operation along a chain of n frames errs by at most a few
// units in the last place of the largest coordinate (the *extent*: how far anything that can matter is from
// the world's origin), so radii are changed by 2^-20 * (n + 2) * extent: for an arm of seven joints and a
// reach of one metre about 10 micrometres. Outer models grow by it, so that they never miss a contact; inner
// models shrink by it, so that they never see one that is not there.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "tamp/collision/checker.hpp"
#include "tamp/collision/kernel.hpp"
#include "tamp/collision/solid.hpp"

namespace praxis::tamp {

class KernelModel {
  public:
    /// Throws std::invalid_argument where a link or an attached body has shapes but no balls, and for groups
    /// of more than 16 variables.
    KernelModel(const CollisionProblem& problem, BallSide side, SolidCache& cache);

    kernel::Model view() const;
    /// The balls are the shapes, and there are no grids: what the kernel says of contacts is so but for the
    /// margin.
    bool exact() const { return exact_; }
    /// Metres added to (outer) or taken from (inner) radii.
    double margin() const { return margin_; }

  private:
    friend class KernelModelBuilder;

    struct alignas(32) LeverBlock {
        std::array<float, kernel::kLanes> lever = {};
    };

    int variable_count_ = 0;
    bool exact_ = true;
    double margin_ = 0;
    std::vector<kernel::Frame> frames_;
    std::vector<kernel::Part> parts_;
    std::vector<kernel::Cluster> clusters_;
    std::vector<kernel::Ball> balls_;
    std::vector<kernel::Obstacle> obstacles_;  ///< by part, in blocks of eight
    std::vector<kernel::ObstacleBoxes> boxes_;
    std::vector<kernel::Grid> grids_;
    std::vector<std::shared_ptr<const DistanceGrid>> distances_;  ///< that the grids point to
    std::vector<kernel::PartPair> pairs_;
    std::vector<LeverBlock> levers_;
    std::vector<float> turns_;
};

}  // namespace praxis::tamp
