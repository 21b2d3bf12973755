#include "tamp/motion/straight_line.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace praxis::tamp {

namespace {

constexpr int kHalvings = 6;
constexpr int kIterations = 12;
constexpr double kMostPieces = 1e5;

void check(const InverseKinematics& ik, std::span<const double> start, const Pose& target,
           const StraightLineOptions& options) {
    const Group& group = ik.robot().groups[static_cast<std::size_t>(ik.group())];
    if (!ik.robot().within_limits(group, start)) {
        throw std::invalid_argument("straight line: the start is not within the limits of the group");
    }
    if (!is_finite(target)) throw std::invalid_argument("straight line: the target is not finite");
    for (double number : {options.step, options.turning_step, options.deviation, options.max_jump,
                          options.position_tolerance, options.rotation_tolerance, options.check_step}) {
        if (!(number > 0)) throw std::invalid_argument("straight line: options must be positive");
    }
    if (options.checker != nullptr && options.checker->dimension() != start.size()) {
        throw std::invalid_argument("straight line: the checker is for another group");
    }
}

class Line {
  public:
    Line(const InverseKinematics& ik, std::span<const double> start, const Pose& target,
         const StraightLineOptions& options)
        : options_(options),
          from_(ik.forward(start)),
          to_(target),
          turn_from_(from_.linear()),
          turn_to_(to_.linear()),
          problem_{.chain = ik.chain(),
                   .target = {},
                   .position_tolerance = options.position_tolerance,
                   .rotation_tolerance = options.rotation_tolerance,
                   .lower = ik.lower(),
                   .upper = ik.upper(),
                   .iterations = kIterations} {
        line_.path.emplace_back(start.begin(), start.end());
    }

    StraightLine run() {
        const Configuration& start = line_.path.front();
        if (options_.checker != nullptr && !options_.checker->is_free(start)) {
            line_.end = LineEnd::collision;
            line_.blocked = start;
            return std::move(line_);
        }
        const double way = (to_.translation() - from_.translation()).norm();
        const double angle = turn_from_.angularDistance(turn_to_);
        const double pieces = std::ceil(std::max({1.0, way / options_.step, angle / options_.turning_step}));
        if (!(pieces <= kMostPieces)) {
            throw std::invalid_argument("straight line: too long for its steps; take larger ones");
        }
        for (double piece = 1; piece <= pieces; ++piece) {
            if (!advance((piece - 1) / pieces, piece / pieces, kHalvings)) return std::move(line_);
        }
        return std::move(line_);
    }

  private:
    Pose pose_at(double share) const {
        Pose pose = Pose::Identity();
        pose.translation() = (1 - share) * from_.translation() + share * to_.translation();
        pose.linear() = turn_from_.slerp(share, turn_to_).toRotationMatrix();
        return pose;
    }

    /// False if the line ends between the two shares of it.
    bool advance(double first, double last, int halvings) {
        const Configuration& before = line_.path.back();
        Columns positions = {};
        std::ranges::copy(before, positions.begin());
        problem_.target = to_frame(pose_at(last));
        if (!descend(problem_, positions).converged || !is_near_line(before, positions, (first + last) / 2)) {
            if (halvings > 0) {
                const double middle = (first + last) / 2;
                return advance(first, middle, halvings - 1) && advance(middle, last, halvings - 1);
            }
            line_.end = LineEnd::kinematics;
            return false;
        }
        Configuration next(positions.begin(), positions.begin() + static_cast<long>(before.size()));
        if (options_.checker != nullptr &&
            !options_.checker->is_motion_free(before, next, options_.check_step)) {
            line_.end = LineEnd::collision;
            line_.blocked = std::move(next);
            return false;
        }
        line_.path.push_back(std::move(next));
        line_.fraction = last;
        return true;
    }

    /// No variable jumps, and half-way in joint space the tool is near the given share of the line.
    bool is_near_line(const Configuration& before, const Columns& after, double share) const {
        Columns middle = {};
        for (std::size_t j = 0; j < before.size(); ++j) {
            if (std::abs(after[j] - before[j]) > options_.max_jump) return false;
            middle[j] = (before[j] + after[j]) / 2;
        }
        IkDescent half_way = problem_;
        half_way.target = to_frame(pose_at(share));
        const IkDescentResult error = measure(half_way, problem_.chain.forward(middle.data()));
        return error.position_error <= options_.deviation && error.rotation_error <= options_.deviation;
    }

    const StraightLineOptions& options_;
    const Pose from_;
    const Pose to_;
    const Eigen::Quaterniond turn_from_;
    const Eigen::Quaterniond turn_to_;
    IkDescent problem_;
    StraightLine line_;
};

}  // namespace

StraightLine straight_line(const InverseKinematics& ik, std::span<const double> start, const Pose& target,
                           const StraightLineOptions& options) {
    check(ik, start, target, options);
    return Line(ik, start, target, options).run();
}

}  // namespace praxis::tamp
