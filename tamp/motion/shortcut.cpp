#include "tamp/motion/shortcut.hpp"

#include <algorithm>
#include <cmath>

#include "search/engines/random.hpp"

namespace praxis::tamp {

namespace {

double distance(const Configuration& a, const Configuration& b) {
    double squares = 0;
    for (std::size_t v = 0; v < a.size(); ++v) squares += (a[v] - b[v]) * (a[v] - b[v]);
    return std::sqrt(squares);
}

/// A place on a path: on the edge that begins at waypoint `edge`.
struct Place {
    std::size_t edge = 0;
    Configuration at = {};
    double from_start = 0;
};

class Shortcutter {
  public:
    Shortcutter(CollisionChecker& checker, Path& path, const ShortcutOptions& options)
        : checker_(checker), path_(path), options_(options), random_(options.seed) {}

    void run() {
        skip_waypoints();
        if (path_.size() < 3) return;
        measure();
        int in_vain = 0;
        for (int i = 0; i < options_.tries && in_vain < options_.patience && path_.size() > 2; ++i) {
            if (options_.budget.exhausted() != Stop::none) return;
            in_vain = cut() ? 0 : in_vain + 1;
        }
    }

  private:
    bool sees(const Configuration& from, const Configuration& to) {
        return checker_.is_extension_free(from, to, options_.step);
    }

    void skip_waypoints() {
        for (std::size_t i = 0; i + 2 < path_.size(); ++i) {
            for (std::size_t j = path_.size() - 1; j > i + 1; --j) {
                if (!sees(path_[i], path_[j])) continue;
                path_.erase(path_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                            path_.begin() + static_cast<std::ptrdiff_t>(j));
                break;
            }
        }
    }

    void measure() {
        lengths_.assign(path_.size(), 0.0);
        for (std::size_t i = 1; i < path_.size(); ++i)
            lengths_[i] = lengths_[i - 1] + distance(path_[i - 1], path_[i]);
    }

    Place random_place() {
        const double at = static_cast<double>(random_.next() >> 11) * 0x1p-53 * lengths_.back();
        const auto after = std::ranges::upper_bound(lengths_, at);
        const std::size_t edge =
            std::min(static_cast<std::size_t>(after - lengths_.begin()) - 1, path_.size() - 2);
        const double length = lengths_[edge + 1] - lengths_[edge];
        const double part = length > 0 ? (at - lengths_[edge]) / length : 0;
        Place place = {edge, path_[edge], at};
        for (std::size_t v = 0; v < place.at.size(); ++v) {
            place.at[v] += part * (path_[edge + 1][v] - path_[edge][v]);
        }
        return place;
    }

    /// Straight between two random places, if that is shorter and free.
    bool cut() {
        constexpr double kLeastGain = 1e-3;
        Place first = random_place();
        Place second = random_place();
        if (first.from_start > second.from_start) std::swap(first, second);
        if (first.edge == second.edge) return false;
        const double gain = second.from_start - first.from_start - distance(first.at, second.at);
        if (gain < kLeastGain * lengths_.back() || !sees(first.at, second.at)) return false;
        const auto begin = path_.begin() + static_cast<std::ptrdiff_t>(first.edge) + 1;
        const auto end = path_.begin() + static_cast<std::ptrdiff_t>(second.edge) + 1;
        const auto gap = path_.erase(begin, end);
        path_.insert(gap, {std::move(first.at), std::move(second.at)});
        measure();
        return true;
    }

    CollisionChecker& checker_;
    Path& path_;
    const ShortcutOptions& options_;
    Random random_;
    std::vector<double> lengths_ = {};  ///< from the start to each waypoint
};

}  // namespace

void shortcut(CollisionChecker& checker, Path& path, const ShortcutOptions& options) {
    Shortcutter(checker, path, options).run();
}

}  // namespace praxis::tamp
