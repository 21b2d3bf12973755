// Collects why the ways to do a skill failed, and sums them up: the skill fails as long as every movable body
// that one of its ways needs gone is there.
#pragma once

#include <string>
#include <vector>

#include "tamp/collision/checker.hpp"
#include "tamp/manipulation/action_motion.hpp"
#include "tamp/motion/path.hpp"

namespace praxis::tamp {

/// The first contact on a path that is not free: "PHASE is in collision: ...". Not definite where none shows.
ActionFailure contact_on_path(CollisionChecker& checker, const Path& path, const std::string& phase);

class FailureLog {
  public:
    /// `what` is done, for messages: "pick can4".
    explicit FailureLog(std::string what) : what_(std::move(what)) {}

    /// One way fails, whatever movable bodies stand where.
    void add_fixed(const ActionFailure& why);
    /// One way fails as long as any of these bodies stands where it stands.
    void add_blocked(std::vector<int> bodies, const ActionFailure& why);
    /// No motion was found; as far as one can tell because of all these bodies.
    void add_no_path(const std::vector<int>& bodies, const ActionFailure& why);

    /// Blames few bodies, such that every way is blocked by one of them; where one body blocks all ways alone,
    /// it and its like (`ActionFailure::each`).
    ActionFailure take();

  private:
    void keep(const ActionFailure& why);

    std::string what_;
    ActionFailure failure_;
    std::vector<std::vector<int>> blocked_;  ///< by way: bodies each of which is enough; sorted
    std::vector<int> suspects_;
    int weight_ = -1;  ///< of the failure that is shown: the further a way came, the more it tells
};

}  // namespace praxis::tamp
