#include "tamp/motion/rrt_connect.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tamp/motion/sampler.hpp"
#include "tamp/motion/tree.hpp"

namespace praxis::tamp {

namespace {

/// Radius of the domain of a node whose extension has failed once, how it shrinks and grows, and its least
/// value.
constexpr float kDomain = 4;
constexpr float kDomainChange = 1e-4F;
constexpr float kLeastDomain = 1;
/// Failed extensions that are kept.
constexpr std::size_t kBlockedKept = 32;
/// Unlimited variables that slide are sampled to this beyond the start and the goals (metres).
constexpr double kBeyond = 2;

using Point = std::array<double, Tree::kMaxDimension>;

class RrtConnect {
  public:
    RrtConnect(CollisionChecker& checker, std::span<const double> start, std::span<const Configuration> goals,
               const RrtConnectOptions& options)
        : checker_(checker),
          options_(options),
          dimension_(start.size()),
          periods_(periods()),
          sampler_(ranges(start, goals), options.seed),
          trees_{Tree(periods_), Tree(periods_)} {
        trees_[0].add(start.data(), -1);
        for (const Configuration& goal : goals) trees_[1].add(goal.data(), -1);
        goal_count_ = static_cast<int>(goals.size());
    }

    RrtConnectResult run() {
        if (try_straight()) return std::move(result_);
        for (int i = 0; i < options_.max_iterations; ++i) {
            if (i % 64 == 63 && options_.budget.exhausted() != Stop::none) break;
            result_.iterations = i + 1;
            turn();
            if (grow()) break;
        }
        result_.nodes = trees_[0].size() + trees_[1].size();
        return std::move(result_);
    }

  private:
    const Robot& robot() const { return *checker_.problem().robot; }
    const Variable& variable(std::size_t v) const {
        const Group& group = robot().groups[static_cast<std::size_t>(checker_.problem().group)];
        return robot().variables[static_cast<std::size_t>(group.variables[v])];
    }

    std::vector<double> periods() const {
        std::vector<double> periods(dimension_, 0.0);
        for (std::size_t v = 0; v < dimension_; ++v) {
            if (variable(v).continuous) periods[v] = 2 * std::numbers::pi;
        }
        return periods;
    }

    std::vector<Interval> ranges(std::span<const double> start, std::span<const Configuration> goals) const {
        std::vector<Interval> ranges(dimension_);
        for (std::size_t v = 0; v < dimension_; ++v) {
            Interval& range = ranges[v];
            if (variable(v).continuous) {
                range = {-std::numbers::pi, std::numbers::pi};
                continue;
            }
            range = {start[v], start[v]};
            for (const Configuration& goal : goals) {
                range = {std::min(range.lower, goal[v]), std::max(range.upper, goal[v])};
            }
            range = {std::isfinite(variable(v).lower) ? variable(v).lower : range.lower - kBeyond,
                     std::isfinite(variable(v).upper) ? variable(v).upper : range.upper + kBeyond};
        }
        return ranges;
    }

    /// The change that leads from one configuration to another, continuous variables by the shorter way.
    void difference(const double* from, const double* to, Point& change) const {
        for (std::size_t v = 0; v < dimension_; ++v) {
            change[v] = to[v] - from[v];
            if (periods_[v] > 0) change[v] -= periods_[v] * std::round(change[v] / periods_[v]);
        }
    }

    /// from + part * change
    void along(const double* from, const Point& change, double part, Point& to) const {
        for (std::size_t v = 0; v < dimension_; ++v) to[v] = from[v] + part * change[v];
    }

    bool is_free(const double* from, const Point& to) {
        return checker_.is_extension_free({from, dimension_}, {to.data(), dimension_}, options_.step);
    }

    bool try_straight() {
        for (int goal = 0; goal < goal_count_; ++goal) {
            Point change;
            Point end;
            difference(trees_[0][0], trees_[1][goal], change);
            along(trees_[0][0], change, 1, end);
            if (!is_free(trees_[0][0], end)) continue;
            append_branch(trees_[0], 0, result_.path);
            append_branch(trees_[1], goal, result_.path);
            unroll(result_.path);
            result_.goal = goal;
            return true;
        }
        return false;
    }

    /// Trees take turns while neither is more than twice the other; else the smaller one grows.
    void turn() {
        const int own = trees_[growing_].size();
        const int other = trees_[1 - growing_].size();
        if (own > other || other < 2 * own) growing_ = 1 - growing_;
    }

    void note_blocked(const double* from, const Point& to) {
        const Configuration first(from, from + dimension_);
        const Configuration second(to.begin(), to.begin() + static_cast<std::ptrdiff_t>(dimension_));
        if (result_.blocked.size() < kBlockedKept) {
            result_.blocked.emplace_back(first, second);
        } else {
            result_.blocked[blocked_count_ % kBlockedKept] = {first, second};
        }
        ++blocked_count_;
    }

    /// One extension towards a sample, and then towards the other tree. True: the trees have met.
    bool grow() {
        Tree& tree = trees_[growing_];
        Point sample;
        sampler_.next(sample.data());
        const Tree::Neighbour near = tree.nearest(sample.data());
        if (near.distance > static_cast<double>(tree.radius(near.node))) return false;
        Point change;
        Point reached;
        difference(tree[near.node], sample.data(), change);
        along(tree[near.node], change, std::min(1.0, options_.range / near.distance), reached);
        float& radius = tree.radius(near.node);
        if (!is_free(tree[near.node], reached)) {
            radius = std::isfinite(radius) ? std::max(radius * (1 - kDomainChange), kLeastDomain) : kDomain;
            if (blocked_count_ < 4 * kBlockedKept) note_blocked(tree[near.node], reached);
            return false;
        }
        radius *= 1 + kDomainChange;
        return connect(tree.add(reached.data(), near.node));
    }

    bool connect(int node) {
        Tree& tree = trees_[growing_];
        const Tree& other = trees_[1 - growing_];
        const Tree::Neighbour target = other.nearest(tree[node]);
        const int pieces = std::max(1, static_cast<int>(std::ceil(target.distance / options_.range)));
        Point change;
        difference(tree[node], other[target.node], change);
        for (int i = 0; i < pieces; ++i) {
            Point next;
            along(tree[node], change, 1.0 / pieces, next);
            if (!is_free(tree[node], next)) return false;
            node = tree.add(next.data(), node);
        }
        join(node, target.node);
        return true;
    }

    /// From a node up to its root.
    void append_branch(const Tree& tree, int node, Path& path) const {
        for (; node >= 0; node = tree.parent(node)) path.emplace_back(tree[node], tree[node] + dimension_);
    }

    /// The path over a node of the other tree and the last node of the growing one, which is at the same
    /// place but for rounding and left out.
    void join(int last, int other_node) {
        const int before = trees_[growing_].parent(last);
        append_branch(trees_[0], growing_ == 0 ? before : other_node, result_.path);
        std::ranges::reverse(result_.path);
        int from_goal = growing_ == 0 ? other_node : before;
        append_branch(trees_[1], from_goal, result_.path);
        while (trees_[1].parent(from_goal) >= 0) from_goal = trees_[1].parent(from_goal);
        result_.goal = from_goal;
        unroll(result_.path);
    }

    /// Lets continuous variables run on without jumps.
    void unroll(Path& path) const {
        for (std::size_t i = 1; i < path.size(); ++i) {
            Point change;
            difference(path[i - 1].data(), path[i].data(), change);
            for (std::size_t v = 0; v < dimension_; ++v) {
                if (periods_[v] > 0) path[i][v] = path[i - 1][v] + change[v];
            }
        }
    }

    CollisionChecker& checker_;
    const RrtConnectOptions& options_;
    std::size_t dimension_;
    std::vector<double> periods_;
    Sampler sampler_;
    std::array<Tree, 2> trees_;  ///< from the start, from the goals
    std::size_t growing_ = 1;
    int goal_count_ = 0;
    std::size_t blocked_count_ = 0;
    RrtConnectResult result_ = {};
};

}  // namespace

RrtConnectResult rrt_connect(CollisionChecker& checker, std::span<const double> start,
                             std::span<const Configuration> goals, const RrtConnectOptions& options) {
    const auto fits = [&](std::span<const double> positions) {
        return positions.size() == checker.dimension();
    };
    if (checker.dimension() > Tree::kMaxDimension)
        throw std::invalid_argument("motions have at most 16 variables");
    if (!fits(start) || !std::ranges::all_of(goals, fits)) {
        throw std::invalid_argument("start and goals of a motion need " +
                                    std::to_string(checker.dimension()) + " positions");
    }
    if (!(options.range > 0)) throw std::invalid_argument("the range of RRT-Connect must be above 0");
    if (goals.empty()) return {};
    return RrtConnect(checker, start, goals, options).run();
}

}  // namespace praxis::tamp
