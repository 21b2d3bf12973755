#include "search/landmarks/landmark_draft.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace praxis {

void LandmarkDraft::tidy() {
    std::erase_if(orderings, [&](const Ordering& o) { return !alive(o.before); });
    for (Ordering& o : orderings) {
        if (alive(o.after)) continue;
        // What holds just before some fact of a set need not hold just before this one.
        o.after = nodes[o.after].replaced_by;
        o.ordering = std::min(o.ordering, LandmarkOrdering::natural);
    }
    std::erase_if(orderings, [](const Ordering& o) { return o.before == o.after; });
    std::ranges::sort(orderings, [](const Ordering& a, const Ordering& b) {
        return std::tuple(a.before, a.after, b.ordering) < std::tuple(b.before, b.after, a.ordering);
    });
    const auto same = [](const Ordering& a, const Ordering& b) {
        return a.before == b.before && a.after == b.after;
    };
    orderings.erase(std::unique(orderings.begin(), orderings.end(), same), orderings.end());
}

namespace {

/// Depth-first search that drops a weakest ordering of each cycle it finds, of several the last.
class CycleBreaker {
  public:
    explicit CycleBreaker(LandmarkDraft& draft)
        : draft_(draft),
          begin_(draft.nodes.size() + 1, 0),
          next_(draft.nodes.size()),
          mark_(draft.nodes.size(), Mark::fresh),
          dropped_(draft.orderings.size(), 0) {
        for (const LandmarkDraft::Ordering& o : draft.orderings) ++begin_[o.before];
        std::exclusive_scan(begin_.begin(), begin_.end(), begin_.begin(), std::size_t{0});
    }

    std::vector<std::uint32_t> run() {
        for (std::uint32_t node = 0; node < draft_.nodes.size(); ++node) {
            if (draft_.alive(node) && mark_[node] == Mark::fresh) search(node);
        }
        std::size_t kept = 0;
        for (std::size_t i = 0; i < dropped_.size(); ++i) {
            const LandmarkDraft::Ordering ordering = draft_.orderings[i];
            if (!dropped_[i]) {
                draft_.orderings[kept++] = ordering;
            } else if (ordering.ordering == LandmarkOrdering::reasonable) {
                draft_.dropped.push_back(ordering);
            }
        }
        draft_.orderings.resize(kept);
        std::ranges::reverse(order_);
        return std::move(order_);
    }

  private:
    enum class Mark : std::uint8_t { fresh, on_path, done };

    void enter(std::uint32_t node) {
        mark_[node] = Mark::on_path;
        next_[node] = begin_[node];
        path_.push_back(node);
    }

    void search(std::uint32_t root) {
        enter(root);
        while (!path_.empty()) {
            const std::uint32_t node = path_.back();
            if (next_[node] == begin_[node + 1]) {
                mark_[node] = Mark::done;
                order_.push_back(node);
                path_.pop_back();
                continue;
            }
            const std::size_t edge = next_[node];
            const std::uint32_t after = draft_.orderings[edge].after;
            if (dropped_[edge] || mark_[after] == Mark::done) {
                ++next_[node];
            } else if (mark_[after] == Mark::fresh) {
                enter(after);  // the ordering is passed when the path comes back
            } else {
                drop_from_cycle(after);
            }
        }
    }

    /// The cycle is the end of the path from `first` on; each landmark's `next_` is its ordering on it.
    void drop_from_cycle(std::uint32_t first) {
        std::size_t weakest = path_.size() - 1;
        for (std::size_t i = path_.size(); i-- > 0;) {
            if (strength(i) < strength(weakest)) weakest = i;
            if (path_[i] == first) break;
        }
        dropped_[next_[path_[weakest]]] = 1;
        while (path_.size() > weakest + 1) {
            mark_[path_.back()] = Mark::fresh;
            path_.pop_back();
        }
    }

    LandmarkOrdering strength(std::size_t place) const {
        return draft_.orderings[next_[path_[place]]].ordering;
    }

    LandmarkDraft& draft_;
    std::vector<std::size_t> begin_;  ///< by landmark: its orderings before others
    std::vector<std::size_t> next_;
    std::vector<Mark> mark_;
    std::vector<char> dropped_;
    std::vector<std::uint32_t> path_;
    std::vector<std::uint32_t> order_;
};

}  // namespace

std::vector<std::uint32_t> break_cycles(LandmarkDraft& draft) {
    return CycleBreaker(draft).run();
}

}  // namespace praxis
