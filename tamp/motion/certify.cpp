#include "tamp/motion/certify.hpp"

#include "tamp/motion/rrt_connect.hpp"
#include "tamp/motion/shortcut.hpp"

namespace praxis::tamp {

namespace {

constexpr int kRepairs = 16;
constexpr int kRepairIterations = 2000;
constexpr int kRepairCuts = 16;

/// A checker whose motions are certified whatever step is asked for: what RRT-Connect makes of it is
/// certified.
class CertifyingChecker final : public CollisionChecker {
  public:
    explicit CertifyingChecker(CollisionChecker& checker) : checker_(checker) {}

    const CollisionProblem& problem() const override { return checker_.problem(); }
    bool is_free(std::span<const double> positions) override { return checker_.is_free(positions); }
    bool is_motion_free(std::span<const double> from, std::span<const double> to, double step) override {
        return checker_.is_motion_free(from, to, step) && checker_.is_motion_certified(from, to);
    }
    bool is_extension_free(std::span<const double> from, std::span<const double> to, double step) override {
        return checker_.is_extension_free(from, to, step) && checker_.is_motion_certified(from, to);
    }
    bool is_motion_certified(std::span<const double> from, std::span<const double> to) override {
        return checker_.is_motion_certified(from, to);
    }
    void find_contacts(std::span<const double> positions, std::vector<Contact>& contacts) override {
        checker_.find_contacts(positions, contacts);
    }
    const std::vector<Contact>& fixed_contacts() const override { return checker_.fixed_contacts(); }

  private:
    CollisionChecker& checker_;
};

}  // namespace

int find_uncertified(CollisionChecker& checker, const Path& path) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (!checker.is_motion_certified(path[i], path[i + 1])) return static_cast<int>(i);
    }
    return -1;
}

bool certify(CollisionChecker& checker, Path& path, const CertifyOptions& options) {
    CertifyingChecker certifying(checker);
    Path certified = {path.front()};
    int repairs = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (checker.is_motion_certified(path[i], path[i + 1])) {
            certified.push_back(path[i + 1]);
            continue;
        }
        if (++repairs > kRepairs) return false;
        RrtConnectOptions repair = {.seed = options.seed + i, .max_iterations = kRepairIterations};
        repair.budget = options.budget;
        Path detour = rrt_connect(certifying, path[i], std::span(&path[i + 1], 1), repair).path;
        if (detour.empty()) return false;
        shortcut(certifying, detour, {.seed = options.seed, .tries = kRepairCuts, .budget = options.budget});
        certified.insert(certified.end(), detour.begin() + 1, detour.end());
    }
    path = std::move(certified);
    return true;
}

RrtConnectResult certified_rrt_connect(CollisionChecker& checker, std::span<const double> start,
                                       std::span<const Configuration> goals,
                                       const RrtConnectOptions& options) {
    CertifyingChecker certifying(checker);
    return rrt_connect(certifying, start, goals, options);
}

}  // namespace praxis::tamp
