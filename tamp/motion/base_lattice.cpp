#include "tamp/motion/base_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace praxis::tamp {

namespace {

constexpr double kTurn = 2 * std::numbers::pi / (BaseLattice::kYaws - 1);

}  // namespace

BaseLattice::BaseLattice(const Configuration& start, const AxisBox& extent, const BaseLatticeOptions& options)
    : origin_(start) {
    const auto reach = [](double length) { return std::isfinite(length) ? std::max(length, 0.0) : 0.0; };
    const double left = reach(start[0] - extent.lower.x()), right = reach(extent.upper.x() - start[0]);
    const double below = reach(start[1] - extent.lower.y()), above = reach(extent.upper.y() - start[1]);
    const double most = static_cast<double>(options.most_poses) / kYaws;
    cell_ = std::max(options.cell, std::sqrt((left + right) * (below + above) / most));
    // A hall that is long and narrow.
    cell_ = std::max(cell_, std::max(left + right, below + above) / most);
    start_column_ = static_cast<int>(left / cell_);
    start_row_ = static_cast<int>(below / cell_);
    columns_ = start_column_ + 1 + static_cast<int>(right / cell_);
    rows_ = start_row_ + 1 + static_cast<int>(above / cell_);
}

Configuration BaseLattice::positions(Pose pose) const {
    const int number = static_cast<int>(pose);
    return {origin_[0] + cell_ * (number / kYaws % columns_ - start_column_),
            origin_[1] + cell_ * (number / kYaws / columns_ - start_row_),
            origin_[2] + kTurn * (number % kYaws - kYaws / 2)};
}

std::vector<BaseLattice::Pose> BaseLattice::around(const Configuration& positions) const {
    const double x = (positions[0] - origin_[0]) / cell_ + start_column_;
    const double y = (positions[1] - origin_[1]) / cell_ + start_row_;
    const double yaw = (positions[2] - origin_[2]) / kTurn + kYaws / 2;
    if (!(x >= -1 && y >= -1 && x <= columns_ && y <= rows_ && yaw >= -1 && yaw <= kYaws)) return {};
    std::vector<std::pair<double, Pose>> found;
    const auto down = [](double value) { return static_cast<int>(std::floor(value)); };
    for (int row = down(y); row <= down(y) + 1; ++row) {
        for (int column = down(x); column <= down(x) + 1; ++column) {
            for (int turn = down(yaw); turn <= down(yaw) + 1; ++turn) {
                if (row < 0 || row >= rows_ || column < 0 || column >= columns_ || turn < 0 || turn >= kYaws)
                    continue;
                const double distance =
                    std::pow(x - column, 2) + std::pow(y - row, 2) + std::pow(yaw - turn, 2);
                found.emplace_back(distance, at(column, row, turn));
            }
        }
    }
    std::ranges::sort(found);
    std::vector<Pose> poses;
    for (const auto& [distance, pose] : found) poses.push_back(pose);
    return poses;
}

std::vector<BaseLattice::Pose> BaseLattice::within(double x, double y, double radius) const {
    const auto column = [&](double at) { return (at - origin_[0]) / cell_ + start_column_; };
    const auto row = [&](double at) { return (at - origin_[1]) / cell_ + start_row_; };
    const auto first = [](double at) { return static_cast<int>(std::ceil(std::max(at, 0.0))); };
    const auto last = [](double at, int count) {
        return static_cast<int>(std::floor(std::min(at, count - 1.0)));
    };
    std::vector<Pose> poses;
    for (int i = first(row(y - radius)); i <= last(row(y + radius), rows_); ++i) {
        for (int k = first(column(x - radius)); k <= last(column(x + radius), columns_); ++k) {
            if (std::hypot(k - column(x), i - row(y)) * cell_ > radius) continue;
            for (int yaw = 0; yaw < kYaws; ++yaw) poses.push_back(at(k, i, yaw));
        }
    }
    return poses;
}

LatticeMap::LatticeMap(const BaseLattice& lattice, std::unique_ptr<CollisionChecker> fixed)
    : lattice_(lattice), fixed_(std::move(fixed)), known_(lattice.size(), Known::no) {}

bool LatticeMap::is_free(BaseLattice::Pose pose) {
    Known& known = known_[pose];
    if (known == Known::no) {
        const CollisionProblem& problem = fixed_->problem();
        const Group& base = problem.robot->groups[static_cast<std::size_t>(problem.group)];
        const Configuration positions = lattice_.positions(pose);
        const bool free = problem.robot->within_limits(base, positions) && fixed_->is_free(positions);
        known = free ? Known::free : Known::taken;
    }
    return known == Known::free;
}

std::vector<BaseLattice::Pose> LatticeMap::touching(CollisionChecker& one, double x, double y,
                                                    double radius) const {
    std::vector<BaseLattice::Pose> poses = lattice_.within(x, y, radius);
    std::erase_if(poses, [&](BaseLattice::Pose pose) {
        return known_[pose] == Known::taken || one.is_free(lattice_.positions(pose));
    });
    return poses;
}

LatticeSearch::LatticeSearch(LatticeMap& map, std::vector<const std::vector<Pose>*> taken)
    : map_(map), taken_(std::move(taken)), heads_(map.lattice().size()), nodes_(map.lattice().size()) {
    for (std::size_t body = 0; body < taken_.size(); ++body) {
        for (const Pose pose : *taken_[body]) {
            links_.push_back({static_cast<int>(body), heads_[pose]});
            heads_[pose] = static_cast<std::uint32_t>(links_.size());
        }
    }
    const Pose start = map_.lattice().start();
    reach(start, start, 0, 0);
}

std::uint32_t LatticeSearch::removals(Pose before, Pose pose) const {
    std::uint32_t count = 0;
    for (std::uint32_t i = heads_[pose]; i != 0; i = links_[i - 1].next) {
        bool is_new = true;
        for (std::uint32_t k = heads_[before]; k != 0; k = links_[k - 1].next)
            is_new = is_new && links_[k - 1].body != links_[i - 1].body;
        count += is_new ? 1 : 0;
    }
    return count;
}

void LatticeSearch::reach(Pose pose, Pose parent, std::uint32_t removals, std::uint32_t length) {
    Node& node = nodes_[pose];
    if (node.settled || std::pair(node.removals, node.length) <= std::pair(removals, length)) return;
    node.removals = removals;
    node.length = length;
    node.parent = parent;
    open_.push({removals, length, pose});
}

void LatticeSearch::settle_next() {
    const Entry entry = open_.top();
    open_.pop();
    Node& node = nodes_[entry.pose];
    if (node.settled) return;
    node.settled = true;
    map_.lattice().visit_neighbours(entry.pose, [&](Pose next, std::uint32_t length) {
        if (nodes_[next].settled || !map_.is_free(next)) return;
        reach(next, entry.pose, entry.removals + removals(entry.pose, next), entry.length + length);
    });
}

LatticeSearch::Way LatticeSearch::way_to(Pose last) const {
    Way way{.found = true};
    const Pose start = map_.lattice().start();
    for (Pose pose = last;; pose = nodes_[pose].parent) {
        way.poses.push_back(pose);
        for (std::uint32_t i = heads_[pose]; i != 0; i = links_[i - 1].next)
            way.bodies.push_back(links_[i - 1].body);
        if (pose == start) break;
    }
    std::ranges::reverse(way.poses);
    std::ranges::sort(way.bodies);
    way.bodies.erase(std::unique(way.bodies.begin(), way.bodies.end()), way.bodies.end());
    return way;
}

const LatticeSearch::Way& LatticeSearch::to(const Configuration& goal) {
    for (const auto& [known, way] : answers_)
        if (known == goal) return way;
    std::vector<Pose> beside = map_.lattice().around(goal);
    std::erase_if(beside, [&](Pose pose) {
        return !map_.is_free(pose) || !map_.fixed().is_motion_free(map_.lattice().positions(pose), goal);
    });
    const auto best = [&] {
        const Node* least = nullptr;
        Pose pose = 0;
        for (const Pose one : beside) {
            const Node& node = nodes_[one];
            if (!node.settled) continue;
            if (least != nullptr &&
                std::pair(least->removals, least->length) <= std::pair(node.removals, node.length))
                continue;
            least = &node;
            pose = one;
        }
        return std::pair(least, pose);
    };
    auto [least, pose] = best();
    while (!beside.empty() && least == nullptr && !open_.empty()) {
        settle_next();
        std::tie(least, pose) = best();
    }
    return answers_.emplace_back(goal, least != nullptr ? way_to(pose) : Way()).second;
}

}  // namespace praxis::tamp
