#include "tamp/motion/time_parametrisation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace praxis::tamp {

namespace {

/// Waypoints nearer than this to one another are one; corners that turn by less are none.
constexpr double kSame = 1e-9;

double distance(const Configuration& a, const Configuration& b) {
    double squared = 0;
    for (std::size_t j = 0; j < a.size(); ++j) squared += (a[j] - b[j]) * (a[j] - b[j]);
    return std::sqrt(squared);
}

/// A straight stretch of the path.
struct Segment {
    std::vector<double> direction;  ///< of length 1
    double length = 0;
    double speed = 0;         ///< greatest along the path
    double acceleration = 0;  ///< greatest along the path
};

/// The end of one segment and the beginning of the next, passed at one speed. A blend at speed s lasts
/// `duration_rate` * s and starts that time times s/2 before the corner.
struct Corner {
    double duration_rate = 0;
    double turn = 0;  ///< length of the difference of the directions
    double most_speed_squared = 0;
    double speed_squared = 0;
    double free_speed_squared = -1;  ///< the speed whose blend was checked last and is free
    int shrunk = 0;                  ///< how often a blend touched something
};

void check(const Path& path, const MotionLimits& limits, const TimingOptions& options) {
    if (path.empty()) throw std::invalid_argument("time parametrisation: the path is empty");
    const std::size_t dimension = path.front().size();
    for (const Configuration& waypoint : path) {
        if (waypoint.size() != dimension) {
            throw std::invalid_argument("time parametrisation: waypoints differ in size");
        }
        if (!std::ranges::all_of(waypoint, [](double q) { return std::isfinite(q); })) {
            throw std::invalid_argument("time parametrisation: a waypoint is not finite");
        }
    }
    if (limits.velocity.size() != dimension || limits.acceleration.size() != dimension) {
        throw std::invalid_argument("time parametrisation: limits for " +
                                    std::to_string(limits.velocity.size()) + " variables, waypoints of " +
                                    std::to_string(dimension));
    }
    const auto proper = [](double limit) { return limit > 0 && std::isfinite(limit); };
    if (!std::ranges::all_of(limits.velocity, proper) || !std::ranges::all_of(limits.acceleration, proper)) {
        throw std::invalid_argument("time parametrisation: limits must be positive and finite");
    }
    if (!(options.max_deviation >= 0) || !(options.step > 0)) {
        throw std::invalid_argument("time parametrisation: 'max_deviation' or 'step' is out of range");
    }
}

class Timing {
  public:
    Timing(const Path& path, const MotionLimits& limits, const TimingOptions& options)
        : limits_(limits), options_(options) {
        add_segments(path);
        add_corners();
    }

    Trajectory run() {
        choose_speeds();
        if (options_.checker != nullptr) {
            while (shrink_blends_that_touch()) choose_speeds();
        }
        write();
        return std::move(trajectory_);
    }

  private:
    std::size_t dimension() const { return limits_.velocity.size(); }

    Segment segment(const Configuration& from, const Configuration& to, double length) const {
        Segment made;
        made.length = length;
        made.direction.resize(dimension());
        made.speed = made.acceleration = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < dimension(); ++j) {
            made.direction[j] = (to[j] - from[j]) / length;
            const double rate = std::abs(made.direction[j]);
            if (rate == 0) continue;
            made.speed = std::min(made.speed, limits_.velocity[j] / rate);
            made.acceleration = std::min(made.acceleration, limits_.acceleration[j] / rate);
        }
        return made;
    }

    /// Joins segments that go on straight, and leaves out those without length.
    void add_segments(const Path& path) {
        waypoints_.push_back(path.front());
        for (std::size_t i = 1; i < path.size(); ++i) {
            const double length = distance(waypoints_.back(), path[i]);
            if (length < kSame) continue;
            if (!std::isfinite(length)) {
                throw std::invalid_argument("time parametrisation: waypoints are too far apart");
            }
            Segment next = segment(waypoints_.back(), path[i], length);
            if (!segments_.empty() && distance(segments_.back().direction, next.direction) < kSame) {
                waypoints_.pop_back();
                const double whole = distance(waypoints_.back(), path[i]);
                segments_.back() = segment(waypoints_.back(), path[i], whole);
            } else {
                segments_.push_back(std::move(next));
            }
            waypoints_.push_back(path[i]);
        }
        // What was left out at the end.
        if (!segments_.empty()) waypoints_.back() = path.back();
    }

    void add_corners() {
        corners_.resize(waypoints_.size());
        for (std::size_t i = 1; i + 1 < waypoints_.size(); ++i) {
            const Segment& before = segments_[i - 1];
            const Segment& after = segments_[i];
            Corner& corner = corners_[i];
            corner.turn = distance(before.direction, after.direction);
            for (std::size_t j = 0; j < dimension(); ++j) {
                corner.duration_rate =
                    std::max(corner.duration_rate,
                             std::abs(after.direction[j] - before.direction[j]) / limits_.acceleration[j]);
            }
            const double speed = std::min(before.speed, after.speed);
            corner.most_speed_squared =
                std::min({speed * speed, std::min(before.length, after.length) / corner.duration_rate,
                          8 * options_.max_deviation / (corner.duration_rate * corner.turn)});
        }
    }

    /// Of path on either side of a corner.
    double blend_length(const Corner& corner) const {
        return corner.duration_rate * corner.speed_squared / 2;
    }

    /// The blend at a share in [0, 1] of its time.
    Configuration blend_at(std::size_t i, double share) const {
        const double half = blend_length(corners_[i]);
        Configuration at = waypoints_[i];
        for (std::size_t j = 0; j < dimension(); ++j) {
            at[j] += half * (share * share * segments_[i].direction[j] -
                             (1 - share) * (1 - share) * segments_[i - 1].direction[j]);
        }
        return at;
    }

    bool blend_is_free(std::size_t i) const {
        // A chord of one n-th of the blend is within its deviation / n^2 of it.
        constexpr double kChordError = 5e-4;
        const double deviation = blend_length(corners_[i]) * corners_[i].turn / 4;
        const int pieces = 2 + static_cast<int>(std::min(64.0, std::sqrt(deviation / kChordError)));
        Configuration from = blend_at(i, 0);
        for (int piece = 1; piece <= pieces; ++piece) {
            Configuration to = blend_at(i, static_cast<double>(piece) / pieces);
            if (!options_.checker->is_motion_free(from, to, options_.step)) return false;
            from = std::move(to);
        }
        return true;
    }

    /// True if a blend touched something: it gets a quarter of its size, and none the fourth time.
    bool shrink_blends_that_touch() {
        bool any = false;
        for (std::size_t i = 1; i + 1 < corners_.size(); ++i) {
            Corner& corner = corners_[i];
            if (corner.speed_squared == 0 || corner.speed_squared == corner.free_speed_squared) continue;
            if (blend_is_free(i)) {
                corner.most_speed_squared = corner.free_speed_squared = corner.speed_squared;
                continue;
            }
            corner.most_speed_squared = ++corner.shrunk < 4 ? corner.speed_squared / 4 : 0;
            any = true;
        }
        return any;
    }

    /// The greatest speeds at the corners from which and to which the segments can accelerate.
    void choose_speeds() {
        for (Corner& corner : corners_) corner.speed_squared = corner.most_speed_squared;
        for (std::size_t i = 0; i < segments_.size(); ++i) bound(corners_[i], segments_[i], corners_[i + 1]);
        for (std::size_t i = segments_.size(); i-- > 0;) bound(corners_[i + 1], segments_[i], corners_[i]);
    }

    /// Of x = speed^2: far.x <= near.x + 2 a (length - what both blends take of it).
    static void bound(const Corner& near, const Segment& segment, Corner& far) {
        const double a = segment.acceleration;
        const double most = (near.speed_squared * (1 - a * near.duration_rate) + 2 * a * segment.length) /
                            (1 + a * far.duration_rate);
        far.speed_squared = std::min(far.speed_squared, std::max(0.0, most));
    }

    void write() {
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            if (corners_[i].speed_squared > 0) write_blend(i);
            write_segment(i);
        }
        trajectory_.knots.push_back({.time = time_,
                                     .positions = waypoints_.back(),
                                     .velocities = Configuration(dimension(), 0),
                                     .accelerations = Configuration(dimension(), 0)});
    }

    void write_blend(std::size_t i) {
        const double speed = std::sqrt(corners_[i].speed_squared);
        Trajectory::Knot knot = {.time = time_,
                                 .positions = blend_at(i, 0),
                                 .velocities = segments_[i - 1].direction,
                                 .accelerations = segments_[i].direction};
        for (std::size_t j = 0; j < dimension(); ++j) {
            knot.accelerations[j] = (knot.accelerations[j] - knot.velocities[j]) / corners_[i].duration_rate;
            knot.velocities[j] *= speed;
        }
        add(std::move(knot), speed * corners_[i].duration_rate);
    }

    void write_segment(std::size_t i) {
        const Segment& segment = segments_[i];
        const double a = segment.acceleration;
        const double first = corners_[i].speed_squared;
        const double last = corners_[i + 1].speed_squared;
        const double begin = blend_length(corners_[i]);
        const double length = std::max(0.0, segment.length - begin - blend_length(corners_[i + 1]));
        const double peak =
            std::max({first, last, std::min(segment.speed * segment.speed, (first + last) / 2 + a * length)});
        const double speed = std::sqrt(peak);
        const double speeding_up = (peak - first) / (2 * a);
        const double slowing_down = (peak - last) / (2 * a);
        const double cruise = std::max(0.0, length - speeding_up - slowing_down);
        write_piece(i, begin, std::sqrt(first), a, (speed - std::sqrt(first)) / a);
        if (peak > 0) write_piece(i, begin + speeding_up, speed, 0, cruise / speed);
        write_piece(i, begin + speeding_up + cruise, speed, -a, (speed - std::sqrt(last)) / a);
    }

    /// Of segment i, from `along` its length on.
    void write_piece(std::size_t i, double along, double speed, double acceleration, double duration) {
        const Segment& segment = segments_[i];
        Trajectory::Knot knot = {.time = time_,
                                 .positions = waypoints_[i],
                                 .velocities = segment.direction,
                                 .accelerations = segment.direction};
        for (std::size_t j = 0; j < dimension(); ++j) {
            knot.positions[j] += along * segment.direction[j];
            knot.velocities[j] *= speed;
            knot.accelerations[j] *= acceleration;
        }
        add(std::move(knot), duration);
    }

    void add(Trajectory::Knot&& knot, double duration) {
        constexpr double kNothing = 1e-12;
        if (duration < kNothing) return;
        time_ += duration;
        trajectory_.knots.push_back(std::move(knot));
    }

    const MotionLimits& limits_;
    const TimingOptions& options_;
    std::vector<Configuration> waypoints_;
    std::vector<Segment> segments_;
    std::vector<Corner> corners_;  ///< one a waypoint; at the ends at rest
    Trajectory trajectory_;
    double time_ = 0;
};

}  // namespace

MotionLimits motion_limits(const Robot& robot, const Group& group, double velocity_scale,
                           double acceleration_scale) {
    for (double scale : {velocity_scale, acceleration_scale}) {
        if (!(scale > 0 && scale <= 1)) {
            throw std::invalid_argument("motion limits: scales are in (0, 1]");
        }
    }
    MotionLimits limits;
    for (int number : group.variables) {
        const Variable& variable = robot.variables[static_cast<std::size_t>(number)];
        limits.velocity.push_back(velocity_scale * variable.max_velocity);
        limits.acceleration.push_back(acceleration_scale * variable.max_acceleration);
    }
    return limits;
}

Trajectory time_parametrise(const Path& path, const MotionLimits& limits, const TimingOptions& options) {
    check(path, limits, options);
    return Timing(path, limits, options).run();
}

}  // namespace praxis::tamp
