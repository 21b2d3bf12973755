// Collects why the ways to do a skill failed, and sums them up: the skill fails as long as every movable body
// that one of its ways needs gone is there.
#pragma once

#include <string>

#include "tamp/collision/checker.hpp"
#include "tamp/manipulation/action_motion.hpp"

namespace praxis::tamp {

class FailureLog {
  public:
    /// `what` is done, for messages: "pick can4".
    FailureLog(std::string what, std::span<const int> hand_links)
        : what_(std::move(what)), hand_links_(hand_links) {}

    /// No configuration reaches the target.
    void add_unreachable(const std::string& message, bool definite);
    /// One way fails at these positions of the checker's group. Contacts with what no action can move stand
    /// for themselves; else one movable body is to blame, preferably one that is already. Whether it is the
    /// hand
    /// (`hand_links`) or what it holds that touches what stands: then no other position of the arm helps.
    bool add_contact(CollisionChecker& checker, std::span<const double> positions, const std::string& phase);
    /// The same for the first contact on a path.
    bool add_blocked_path(CollisionChecker& checker, const Path& path, const std::string& phase);
    /// The motion planner found nothing; it met these bodies.
    void add_no_path(const CollisionProblem& problem, const std::vector<int>& bodies,
                     const std::string& phase);

    ActionFailure take();

  private:
    void blame(int body);
    void keep(TrajectoryDocument::Reason reason, const std::string& message);

    /// Who moves with the hand, and who stands.
    bool is_of_hand(const World& world, const Contact& contact) const;

    std::string what_;
    std::span<const int> hand_links_;
    ActionFailure failure_;
    int weight_ = -1;  ///< of the failure that is shown: the further a way came, the more it tells
};

}  // namespace praxis::tamp
