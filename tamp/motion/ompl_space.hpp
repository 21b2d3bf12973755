// The space of a checker's group as OMPL sees it. Only for the files that call OMPL.
#pragma once

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSpace.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tamp/collision/checker.hpp"

namespace praxis::tamp {

/// Bounded variables first, then circles. Not copied: OMPL keeps pointers into it.
class OmplSpace {
  public:
    /// Throws std::invalid_argument for a slide without limits.
    OmplSpace(CollisionChecker& checker, double step, double turning_weight);
    OmplSpace(const OmplSpace&) = delete;
    OmplSpace& operator=(const OmplSpace&) = delete;

    const ompl::base::SpaceInformationPtr& information() const { return information_; }

    void write(std::span<const double> positions, ompl::base::State* state) const;
    /// Angles without limits come out within half a turn of those of `near`.
    void read(const ompl::base::State* state, std::span<const double> near,
              std::span<double> positions) const;

    bool is_free(const ompl::base::State* state);
    bool is_motion_free(const ompl::base::State* from, const ompl::base::State* to);
    /// The same; if not free, a share of the motion that is, found by bisection.
    bool is_motion_free(const ompl::base::State* from, const ompl::base::State* to, double& free_share);

    std::uint64_t states() const { return states_; }
    std::uint64_t motions() const { return motions_; }

  private:
    void read_ends(const ompl::base::State* from, const ompl::base::State* to);

    CollisionChecker& checker_;
    double step_;
    std::vector<std::size_t> order_;  ///< column of each of OMPL's numbers
    std::vector<bool> continuous_;    ///< by column
    ompl::base::StateSpacePtr space_;
    ompl::base::SpaceInformationPtr information_;
    mutable std::vector<double> numbers_;
    std::vector<double> zero_;
    std::vector<double> from_;
    std::vector<double> to_;
    std::vector<double> middle_;
    std::uint64_t states_ = 0;
    std::uint64_t motions_ = 0;
};

}  // namespace praxis::tamp
