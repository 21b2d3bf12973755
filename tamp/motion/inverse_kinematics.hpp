// Inverse kinematics: positions of a group that bring a tool to a target pose.
//
// Works for any group that moves the tool: an arm, an arm with its mobile base, slides, mimic joints, up to
// 16 variables. Fewer than six are right for tasks that leave something free (`IkTask`). A solver descends
// (`ik_descent.hpp`) from one start after the other: the caller's own, then those of an even spread whose
// tool is nearest to the target (`ik_starts.hpp`). A closed form, where the caller has one, is asked first;
// what it says is checked and polished before it counts. Collisions are not looked at: ask for several
// solutions, or again with another seed.
//
//     const InverseKinematics ik(robot, arm, hand_link, tool);
//     if (const IkResult found = ik.solve(target)) use(found.positions);
//
// A solver does not change once made: threads may share it. Equal questions have equal answers. Making one
// costs about half a millisecond.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "tamp/motion/ik_descent.hpp"
#include "tamp/motion/ik_starts.hpp"

namespace praxis::tamp {

/// A closed form for one group of one robot: appends positions of the group that (nearly) bring the tool to
/// `target` in the world. Candidates may be wrong or out of limits: they are checked. It is called from
/// whatever threads use the solver.
using AnalyticKinematics = std::function<void(const Pose& target, std::vector<Configuration>& candidates)>;

struct IkOptions {
    IkTask task = IkTask::pose;
    double position_tolerance = 1e-5;  ///< metres
    double rotation_tolerance = 1e-4;  ///< radians
    /// Tried first, by variable of the group; angles without limits come out nearest to it, or to 0.
    std::optional<Configuration> start = {};
    /// What the redundancy left by the task is used for: solutions slide towards these positions.
    std::optional<Configuration> posture = {};
    int attempts = 100;      ///< starts tried
    int iterations = 40;     ///< of one attempt
    std::uint64_t seed = 0;  ///< other seeds find other solutions
    /// Two solutions differ in some variable by more than this (radians or metres).
    double distinct = 0.1;
};

enum class IkStatus : std::uint8_t {
    solved,
    not_found,     ///< no attempt arrived: nothing is proved
    out_of_reach,  ///< proved: the target is further away than the chain is long
};

struct IkResult {
    IkStatus status = IkStatus::not_found;
    Configuration positions = {};  ///< of the group; empty unless solved
    double position_error = 0;     ///< metres
    double rotation_error = 0;     ///< radians
    int attempts = 0;
    int iterations = 0;  ///< of all attempts

    explicit operator bool() const { return status == IkStatus::solved; }
};

class InverseKinematics {
  public:
    /// `tool`: the frame in `link` that is brought to targets. The robot's other variables stay at `rest`
    /// (by default `Robot::zero`). Throws std::invalid_argument as `KinematicChain` does.
    InverseKinematics(std::shared_ptr<const Robot> robot, int group, int link,
                      const Pose& tool = Pose::Identity(), std::optional<Configuration> rest = {},
                      AnalyticKinematics analytic = {});

    /// `target` is in the world. Throws std::invalid_argument if it is not a finite pose, or for options
    /// that make no sense.
    IkResult solve(const Pose& target, const IkOptions& options = {}) const;
    /// Up to `count` solutions, distinct from each other, in the order found.
    std::vector<Configuration> solve_all(const Pose& target, std::size_t count,
                                         const IkOptions& options = {}) const;
    /// Pose of the tool in the world.
    Pose forward(std::span<const double> positions) const;

    const Robot& robot() const { return *robot_; }
    int group() const { return group_; }
    const KinematicChain& chain() const { return chain_; }
    /// Limits of the group's variables.
    const Columns& lower() const { return lower_; }
    const Columns& upper() const { return upper_; }

  private:
    template <class Accept>
    IkResult search(const Pose& target, const IkOptions& options, Accept&& accept) const;
    void normalise(const IkOptions& options, Columns& positions) const;
    Columns to_columns(const Configuration& positions, const char* name) const;

    std::shared_ptr<const Robot> robot_;
    int group_;
    Configuration rest_;
    KinematicChain chain_;
    Columns lower_ = {};
    Columns upper_ = {};
    std::array<bool, kMaxColumns> continuous_ = {};
    IkStarts starts_;
    AnalyticKinematics analytic_;
};

}  // namespace praxis::tamp
