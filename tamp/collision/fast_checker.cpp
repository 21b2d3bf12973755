#include "tamp/collision/fast_checker.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "tamp/collision/kernel_model.hpp"

namespace praxis::tamp {

namespace {

constexpr int kLanes = kernel::kLanes;
constexpr double kFarthest = 1e4;
/// Lengths of stretches of a motion (radians and metres): the first, and those where halving ends.
constexpr double kFirstStretch = 1.0 / 8;
constexpr double kLastStretch = 1.0 / 8192;
constexpr double kLastCoveredStretch = 1.0 / 1024;

/// Numbers for eight configurations, as the kernel reads them.
template <std::size_t size>
struct alignas(32) Aligned {
    std::array<float, size> v;
};

using Positions = Aligned<16 * kLanes>;

class Scratch {
  public:
    explicit Scratch(const kernel::Model& model)
        : blocks_(static_cast<std::size_t>(kernel::scratch_size(model)) / kLanes + 1) {}
    float* get() { return blocks_.front().v.data(); }

  private:
    std::vector<Aligned<kLanes>> blocks_;
};

/// A model with what a call of the kernel needs.
struct Side {
    KernelModel model;
    kernel::Model view;
    Scratch scratch;

    Side(const CollisionProblem& problem, BallSide side, SolidCache& cache)
        : model(problem, side, cache), view(model.view()), scratch(view) {}
    Side(const Side&) = delete;
    Side& operator=(const Side&) = delete;

    unsigned collisions(const Positions& positions) {
        return kernel::functions().collisions(view, positions.v.data(), scratch.get());
    }
};

/// A segment on floats.
struct Segment {
    std::array<float, 16> from = {};
    std::array<float, 16> change = {};
    double length = 0;
};

/// A stretch of a segment, as parts of it.
struct Stretch {
    float middle = 0;
    float width = 0;  ///< to either side
};

void require_group(const CollisionProblem& problem) {
    if (!problem.robot || !problem.world)
        throw std::invalid_argument("a collision problem needs a robot and a world");
    if (problem.group < 0 || static_cast<std::size_t>(problem.group) >= problem.robot->groups.size()) {
        throw std::invalid_argument("there is no group number " + std::to_string(problem.group));
    }
    if (problem.rest.size() != problem.robot->dimension()) {
        throw std::invalid_argument("the configuration at rest has " + std::to_string(problem.rest.size()) +
                                    " numbers, the robot " + std::to_string(problem.robot->dimension()));
    }
    if (!std::ranges::all_of(problem.rest, [](double q) { return std::abs(q) <= kFarthest; })) {
        throw std::invalid_argument("the configuration at rest is not finite");
    }
    for (const BodyState& body : problem.world->bodies()) {
        if (body.attachment &&
            (body.attachment->link < 0 ||
             static_cast<std::size_t>(body.attachment->link) >= problem.robot->links.size())) {
            throw std::invalid_argument("body '" + body.model->name +
                                        "' is attached to a link that is not there");
        }
    }
}

const CollisionProblem& checked(const CollisionProblem& problem) {
    require_group(problem);
    return problem;
}

/// Variables that only turn: whole turns of them change nothing.
std::vector<bool> turning_variables(const CollisionProblem& problem) {
    const std::vector<int>& variables =
        problem.robot->groups[static_cast<std::size_t>(problem.group)].variables;
    std::vector<bool> turning(variables.size(), true);
    for (const Joint& joint : problem.robot->joints) {
        const auto found = std::ranges::find(variables, joint.variable);
        if (found == variables.end()) continue;
        if (joint.type == JointType::prismatic || std::abs(joint.multiplier) != 1) {
            turning[static_cast<std::size_t>(found - variables.begin())] = false;
        }
    }
    return turning;
}

class FastChecker final : public CollisionChecker {
  public:
    FastChecker(const CollisionProblem& problem, std::shared_ptr<SolidCache> cache)
        : problem_(checked(problem)),
          cache_(cache ? std::move(cache) : make_solid_cache()),
          exact_(make_fcl_checker(problem_, cache_)),
          turning_(turning_variables(problem_)),
          outer_(problem_, BallSide::outer, *cache_) {
        if (!outer_.model.exact()) inner_.emplace(problem_, BallSide::inner, *cache_);
    }

    const CollisionProblem& problem() const override { return problem_; }

    bool is_free(std::span<const double> positions) override {
        require(positions);
        if (!fixed_contacts().empty()) return false;
        Positions lanes;
        for (std::size_t v = 0; v < positions.size(); ++v) {
            std::fill_n(&lanes.v[v * kLanes], kLanes, static_cast<float>(wrapped(v, positions[v])));
        }
        if (outer_.collisions(lanes) == 0) return true;
        if (!inner_ || inner_->collisions(lanes) != 0) return false;
        return exact_->is_free(positions);
    }

    bool is_motion_free(std::span<const double> from, std::span<const double> to, double step) override {
        return is_segment_free(from, to, step, true);
    }

    bool is_extension_free(std::span<const double> from, std::span<const double> to, double step) override {
        return is_segment_free(from, to, step, false);
    }

    bool is_motion_certified(std::span<const double> from, std::span<const double> to) override {
        const Segment segment = make_segment(from, to);
        if (!fixed_contacts().empty()) return false;
        turn_ = kernel::functions().sweeps(outer_.view, segment.change.data(), sweeps_.v.data());
        const int first = std::max(1, static_cast<int>(std::ceil(segment.length / kFirstStretch)));
        const float width = 0.5F / static_cast<float>(first);
        open_.clear();
        for (int i = first; i-- > 0;)
            open_.push_back({static_cast<float>(2 * i + 1) * width, width * 1.0001F});
        while (!open_.empty()) {
            if (!prove_some(segment, from, to)) return false;
        }
        return true;
    }

    void find_contacts(std::span<const double> positions, std::vector<Contact>& contacts) override {
        exact_->find_contacts(positions, contacts);
    }

    const std::vector<Contact>& fixed_contacts() const override { return exact_->fixed_contacts(); }

  private:
    void require(std::span<const double> positions) const {
        if (positions.size() != turning_.size()) {
            throw std::invalid_argument(std::to_string(positions.size()) + " positions for a group of " +
                                        std::to_string(turning_.size()) + " variables");
        }
        if (!std::ranges::all_of(positions, [](double q) { return std::abs(q) <= kFarthest; })) {
            throw std::invalid_argument("a position is not finite, or beyond 10000");
        }
    }

    double wrapped(std::size_t variable, double q) const {
        constexpr double kTurn = 2 * std::numbers::pi;
        return std::abs(q) > std::numbers::pi && turning_[variable] ? q - kTurn * std::round(q / kTurn) : q;
    }

    Segment make_segment(std::span<const double> from, std::span<const double> to) const {
        Segment segment;
        bool good = from.size() == turning_.size() && to.size() == turning_.size();
        const std::size_t count = good ? from.size() : 0;
        double squares = 0;
        for (std::size_t v = 0; v < count; ++v) {
            good = good && std::abs(from[v]) <= kFarthest && std::abs(to[v]) <= kFarthest;
            const double change = to[v] - from[v];
            segment.from[v] = static_cast<float>(wrapped(v, from[v]));
            segment.change[v] = static_cast<float>(change);
            squares += change * change;
        }
        if (!good) {
            require(from);
            require(to);
        }
        segment.length = std::sqrt(squares);
        return segment;
    }

    bool is_segment_free(std::span<const double> from, std::span<const double> to, double step,
                         bool with_start) {
        if (!(step >= 1e-6))
            throw std::invalid_argument("the step of a motion's check must be at least 1e-6");
        const Segment segment = make_segment(from, to);
        if (!fixed_contacts().empty()) return false;
        const double configurations = std::ceil(segment.length / step - 1e-9) + (with_start ? 1 : 0);
        const int rakes = std::max(1, static_cast<int>(std::ceil(configurations / kLanes)));
        if (!inner_) {
            return kernel::functions().motion_free(outer_.view, segment.from.data(), segment.change.data(),
                                                   rakes, with_start, outer_.scratch.get());
        }
        for (int i = 0, turns = kernel::rake_turns(rakes); i < turns; ++i) {
            const int rake = kernel::rake_at(i, rakes);
            if (rake >= 0 && !is_rake_free(segment, from, to, rake, rakes, with_start ? 0 : 1)) return false;
        }
        return true;
    }

    /// Positions at parts `t` of a segment.
    void interpolate(const Segment& segment, const Aligned<kLanes>& t, Positions& positions) const {
        for (std::size_t v = 0; v < turning_.size(); ++v) {
            for (std::size_t lane = 0; lane < kLanes; ++lane) {
                positions.v[v * kLanes + lane] = segment.from[v] + t.v[lane] * segment.change[v];
            }
        }
    }

    bool is_exactly_free(std::span<const double> from, std::span<const double> to, double t) {
        point_.resize(from.size());
        for (std::size_t v = 0; v < from.size(); ++v) point_[v] = from[v] + t * (to[v] - from[v]);
        return exact_->is_free(point_);
    }

    /// Of the lanes in `doubtful`, which the covering balls say collide: does every one not?
    bool are_free(const Positions& positions, const Aligned<kLanes>& t, unsigned doubtful,
                  std::span<const double> from, std::span<const double> to) {
        if ((inner_->collisions(positions) & doubtful) != 0) return false;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            if ((doubtful >> lane & 1U) != 0 && !is_exactly_free(from, to, static_cast<double>(t.v[lane])))
                return false;
        }
        return true;
    }

    bool is_rake_free(const Segment& segment, std::span<const double> from, std::span<const double> to,
                      int rake, int rakes, int first) {
        Aligned<kLanes> t;
        for (int lane = 0; lane < kLanes; ++lane) {
            t.v[static_cast<std::size_t>(lane)] = static_cast<float>(lane * rakes + rake + first) /
                                                  static_cast<float>(kLanes * rakes - 1 + first);
        }
        Positions positions;
        interpolate(segment, t, positions);
        const unsigned doubtful = outer_.collisions(positions);
        return doubtful == 0 || are_free(positions, t, doubtful, from, to);
    }

    /// Takes up to eight open stretches and proves them free, or puts their halves back. False: there is a
    /// collision.
    bool prove_some(const Segment& segment, std::span<const double> from, std::span<const double> to) {
        const double last = inner_ ? kLastCoveredStretch : kLastStretch;
        Aligned<kLanes> t;
        Aligned<kLanes> width;
        const std::size_t count = std::min<std::size_t>(kLanes, open_.size());
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const Stretch& stretch = open_[open_.size() - 1 - std::min(lane, count - 1)];
            t.v[lane] = stretch.middle;
            width.v[lane] = stretch.width;
        }
        open_.resize(open_.size() - count);
        const unsigned unproved = kernel::functions().swept_collisions(
            outer_.view, segment.from.data(), segment.change.data(), t.v.data(), width.v.data(),
            sweeps_.v.data(), turn_, outer_.scratch.get());
        unsigned last_ones = 0;
        for (std::size_t lane = 0; lane < count; ++lane) {
            if ((unproved >> lane & 1U) == 0) continue;
            const float half = width.v[lane] / 2;
            if (2 * static_cast<double>(width.v[lane]) * segment.length <= last) {
                last_ones |= 1U << lane;
            } else {
                open_.push_back({t.v[lane] - half, half * 1.0001F});
                open_.push_back({t.v[lane] + half, half * 1.0001F});
            }
        }
        if (last_ones == 0) return true;
        Positions positions;
        interpolate(segment, t, positions);
        const unsigned touching = outer_.collisions(positions) & last_ones;
        return touching == 0 || (inner_ && are_free(positions, t, touching, from, to));
    }

    CollisionProblem problem_;
    std::shared_ptr<SolidCache> cache_;
    std::unique_ptr<CollisionChecker> exact_;
    std::vector<bool> turning_;
    Side outer_;
    std::optional<Side> inner_ = {};
    Aligned<kernel::kMaxParts> sweeps_ = {};  ///< of the segment that is being certified
    float turn_ = 0;
    std::vector<Stretch> open_ = {};
    Configuration point_ = {};
};

}  // namespace

std::unique_ptr<CollisionChecker> make_fast_checker(const CollisionProblem& problem,
                                                    std::shared_ptr<SolidCache> cache) {
    return std::make_unique<FastChecker>(problem, std::move(cache));
}

}  // namespace praxis::tamp
