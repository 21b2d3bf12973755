#include "tamp/motion/ik_descent.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace praxis::tamp {

namespace {

using Vector = std::array<double, 3>;
constexpr std::size_t kMaxRows = 6;

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

std::size_t rows_of(IkTask task) {
    if (task == IkTask::pose) return 6;
    return task == IkTask::position ? 3 : 5;
}

/// The rotation vector of the matrix m (rows), whose angle is in [0, pi].
Vector rotation_vector(const std::array<Vector, 3>& m) {
    const Vector skew = {(m[2][1] - m[1][2]) / 2, (m[0][2] - m[2][0]) / 2, (m[1][0] - m[0][1]) / 2};
    const double cosine = (m[0][0] + m[1][1] + m[2][2] - 1) / 2;
    const double sine = std::sqrt(dot(skew, skew));
    if (sine < 1e-9 && cosine > 0) return skew;
    const double angle = std::atan2(sine, cosine);
    if (sine > 1e-5) {
        const double scale = angle / sine;
        return {scale * skew[0], scale * skew[1], scale * skew[2]};
    }
    // Nearly half a turn: the axis is in the symmetric part.
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (m[i][i] > m[k][k]) k = i;
    }
    const double largest = std::sqrt(std::max(0.0, (m[k][k] - cosine) / (1 - cosine)));
    Vector axis;
    for (std::size_t i = 0; i < 3; ++i) {
        axis[i] = i == k ? largest : (m[i][k] + m[k][i]) / (2 * (1 - cosine) * largest);
    }
    const double sign = dot(axis, skew) < 0 ? -1 : 1;
    return {sign * angle * axis[0], sign * angle * axis[1], sign * angle * axis[2]};
}

/// Rotation that takes the frame's orientation to the target's, in the frame's own axes.
Vector rotation_error(const IkDescent& problem, const Frame& frame) {
    const Frame& target = problem.target;
    if (problem.task == IkTask::position) return {0, 0, 0};
    if (problem.task == IkTask::position_and_axis) {
        const double along_x = dot(frame.x, target.z);
        const double along_y = dot(frame.y, target.z);
        const double sine = std::hypot(along_x, along_y);
        const double angle = std::atan2(sine, dot(frame.z, target.z));
        if (sine < 1e-12) return {angle, 0, 0};
        return {-along_y * angle / sine, along_x * angle / sine, 0};
    }
    return rotation_vector({{{dot(frame.x, target.x), dot(frame.x, target.y), dot(frame.x, target.z)},
                             {dot(frame.y, target.x), dot(frame.y, target.y), dot(frame.y, target.z)},
                             {dot(frame.z, target.x), dot(frame.z, target.y), dot(frame.z, target.z)}}});
}

/// Position in the world's axes, then rotation in the frame's.
std::array<double, kMaxRows> task_error(const IkDescent& problem, const Frame& frame) {
    const Vector rotation = rotation_error(problem, frame);
    return {problem.target.origin[0] - frame.origin[0],
            problem.target.origin[1] - frame.origin[1],
            problem.target.origin[2] - frame.origin[2],
            rotation[0],
            rotation[1],
            rotation[2]};
}

/// Squares of the lengths of its two halves.
std::array<double, 2> squares(const std::array<double, kMaxRows>& error) {
    return {error[0] * error[0] + error[1] * error[1] + error[2] * error[2],
            error[3] * error[3] + error[4] * error[4] + error[5] * error[5]};
}

/// The error of the task and how it changes with each column.
struct Linearisation {
    std::array<double, kMaxRows> error;
    std::array<std::array<double, kMaxRows>, kMaxColumns> columns;
    double position_error;
    double rotation_error;
    double squared;
};

class Descent {
  public:
    Descent(const IkDescent& problem, Columns& positions)
        : problem_(problem),
          columns_(problem.chain.columns()),
          rows_(rows_of(problem.task)),
          positions_(positions) {}

    IkDescentResult run() {
        linearise(positions_, now_);
        approach(problem_.iterations);
        IkDescentResult found = result();
        if (!found.converged || problem_.posture == nullptr) return found;
        const Columns arrived = positions_;
        slide();
        approach(kCorrections);
        if (converged(now_) && away(positions_) < away(arrived)) return result();
        positions_ = arrived;
        found.iterations = iterations_;
        return found;
    }

  private:
    static constexpr double kDamping = 1e-2;
    static constexpr double kLeastDamping = 1e-9;
    static constexpr double kMostDamping = 1e4;
    static constexpr double kPull = 0.5;
    static constexpr double kStill = 1e-3;
    static constexpr double kFarOff = 0.01;
    static constexpr int kSlides = 15;
    static constexpr int kCorrections = 5;
    static constexpr double kSlow = 0.7;
    static constexpr int kPatience = 3;
    static constexpr double kLongestStep = 1;

    bool converged(const Linearisation& at) const {
        return at.position_error <= problem_.position_tolerance &&
               at.rotation_error <= problem_.rotation_tolerance;
    }
    IkDescentResult result() const {
        return {converged(now_), iterations_, now_.position_error, now_.rotation_error};
    }

    /// Until the error is within the tolerances, or no longer shrinks.
    void approach(int iterations) {
        double damping_scale = kDamping;
        int slow = 0;
        for (int i = 0; i < iterations && !converged(now_); ++i, ++iterations_) {
            Columns next = positions_;
            step(damping_scale * now_.squared + kLeastDamping, 0, next);
            linearise(next, then_);
            if (then_.squared > now_.squared) {
                damping_scale *= 8;
                if (damping_scale > kMostDamping) return;
                continue;
            }
            damping_scale = std::max(damping_scale / 4, kDamping / 64);
            slow = then_.squared > kSlow * now_.squared ? slow + 1 : 0;
            positions_ = next;
            now_ = then_;
            if (slow >= kPatience) return;
        }
    }

    /// Along the solutions towards the posture, hardly leaving them.
    void slide() {
        double pull = kPull;
        for (int i = 0; i < kSlides; ++i, ++iterations_) {
            Columns next = positions_;
            if (step(kLeastDamping, pull, next) < kStill) return;
            linearise(next, then_);
            if (then_.squared > kFarOff) {
                pull /= 2;
                continue;
            }
            positions_ = next;
            now_ = then_;
        }
    }

    double away(const Columns& positions) const {
        double squared = 0;
        for (std::size_t j = 0; j < columns_; ++j) {
            const double difference = positions[j] - problem_.posture[j];
            squared += difference * difference;
        }
        return squared;
    }

    void linearise(const Columns& positions, Linearisation& at) const {
        Jacobian jacobian;
        const Frame frame = problem_.chain.forward(positions.data(), jacobian);
        at.error = task_error(problem_, frame);
        const auto [position_squared, rotation_squared] = squares(at.error);
        at.position_error = std::sqrt(position_squared);
        at.rotation_error = std::sqrt(rotation_squared);
        at.squared = position_squared + rotation_squared;
        for (std::size_t j = 0; j < columns_; ++j) {
            const Vector& angular = jacobian.angular[j];
            const Vector& linear = jacobian.linear[j];
            at.columns[j] = {linear[0],
                             linear[1],
                             linear[2],
                             dot(angular, frame.x),
                             dot(angular, frame.y),
                             dot(angular, frame.z)};
        }
    }

    /// Adds one step to `next`; returns its largest component.
    double step(double damping, double pull, Columns& next) const {
        std::array<bool, kMaxColumns> fixed = {};
        Columns change = {};
        for (std::size_t round = 0; round < 3; ++round) {
            solve(damping, pull, fixed, change);
            bool all_inside = true;
            for (std::size_t j = 0; j < columns_; ++j) {
                if (fixed[j]) continue;
                const bool outwards =
                    change[j] < 0 ? positions_[j] <= problem_.lower[j] : positions_[j] >= problem_.upper[j];
                if (change[j] == 0 || !outwards) continue;
                fixed[j] = true;
                all_inside = false;
            }
            if (all_inside) break;
        }
        double longest = 0;
        for (std::size_t j = 0; j < columns_; ++j) longest = std::max(longest, std::abs(change[j]));
        const double scale = longest > kLongestStep ? kLongestStep / longest : 1;
        for (std::size_t j = 0; j < columns_; ++j) {
            if (fixed[j]) continue;
            next[j] = std::clamp(positions_[j] + scale * change[j], problem_.lower[j], problem_.upper[j]);
        }
        return longest;
    }

    /// change = z + J' (J J' + damping)^-1 (error - J z) over the columns that are not fixed, where z pulls
    /// towards the posture.
    void solve(double damping, double pull, const std::array<bool, kMaxColumns>& fixed,
               Columns& change) const {
        std::array<double, kMaxRows> right = now_.error;
        std::array<std::array<double, kMaxRows>, kMaxRows> matrix = {};
        for (std::size_t j = 0; j < columns_; ++j) {
            change[j] = 0;
            if (fixed[j]) continue;
            const std::array<double, kMaxRows>& column = now_.columns[j];
            if (pull > 0) {
                change[j] = pull * (problem_.posture[j] - positions_[j]);
                for (std::size_t i = 0; i < rows_; ++i) right[i] -= change[j] * column[i];
            }
            for (std::size_t i = 0; i < rows_; ++i) {
                for (std::size_t k = 0; k <= i; ++k) matrix[i][k] += column[i] * column[k];
            }
        }
        for (std::size_t i = 0; i < rows_; ++i) matrix[i][i] += damping;
        solve_in_place(matrix, right);
        for (std::size_t j = 0; j < columns_; ++j) {
            if (fixed[j]) continue;
            for (std::size_t i = 0; i < rows_; ++i) change[j] += now_.columns[j][i] * right[i];
        }
    }

    /// Cholesky; of the positive definite matrix only the lower triangle is read.
    void solve_in_place(std::array<std::array<double, kMaxRows>, kMaxRows>& matrix,
                        std::array<double, kMaxRows>& right) const {
        std::array<double, kMaxRows> inverse;
        for (std::size_t i = 0; i < rows_; ++i) {
            for (std::size_t k = 0; k <= i; ++k) {
                double sum = matrix[i][k];
                for (std::size_t l = 0; l < k; ++l) sum -= matrix[i][l] * matrix[k][l];
                if (i == k) {
                    matrix[i][i] = std::sqrt(std::max(sum, 1e-300));
                    inverse[i] = 1 / matrix[i][i];
                } else {
                    matrix[i][k] = sum * inverse[k];
                }
            }
        }
        for (std::size_t i = 0; i < rows_; ++i) {
            for (std::size_t k = 0; k < i; ++k) right[i] -= matrix[i][k] * right[k];
            right[i] *= inverse[i];
        }
        for (std::size_t i = rows_; i-- > 0;) {
            for (std::size_t k = i + 1; k < rows_; ++k) right[i] -= matrix[k][i] * right[k];
            right[i] *= inverse[i];
        }
    }

    const IkDescent& problem_;
    const std::size_t columns_;
    const std::size_t rows_;
    Columns& positions_;
    Linearisation now_;
    Linearisation then_;
    int iterations_ = 0;
};

}  // namespace

IkDescentResult descend(const IkDescent& problem, Columns& positions) {
    return Descent(problem, positions).run();
}

IkDescentResult measure(const IkDescent& problem, const Frame& frame) {
    const auto [position_squared, rotation_squared] = squares(task_error(problem, frame));
    IkDescentResult result;
    result.position_error = std::sqrt(position_squared);
    result.rotation_error = std::sqrt(rotation_squared);
    result.converged = result.position_error <= problem.position_tolerance &&
                       result.rotation_error <= problem.rotation_tolerance;
    return result;
}

}  // namespace praxis::tamp
