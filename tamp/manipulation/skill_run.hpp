// One call of a skill: tries the ways of a site, one after the other, and puts together the pieces of motion
// of the one that works. To place a body is to pick it from where it shall stand, backwards.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tamp/manipulation/failure_log.hpp"
#include "tamp/manipulation/site.hpp"

namespace praxis::tamp {

class SkillRun {
  public:
    enum class Skill : std::uint8_t { pick, place };

    /// `body` stands at `pose` before it is picked, and after it is placed; where it stands in `world` means
    /// nothing.
    SkillRun(SkillSpace& space, Skill skill, const World& world, int body, const Pose& pose,
             const Grasp& grasp, const Budget& budget, std::uint64_t variation);

    /// `find_site` is called if the place is not taken.
    ActionResult run(const std::function<Site&()>& find_site);

  private:
    using Kind = TrajectoryDocument::Motion;

    /// A movable body that stands.
    struct Other {
        int body = 0;
        SkillSpace::Id standing = 0;
    };
    /// By lift: the bodies that each stop it, and how the first does.
    struct Stopped {
        std::vector<int> bodies = {};
        const ActionFailure* why = nullptr;
    };
    using Stoppers = std::array<std::optional<Stopped>, kLifts>;

    /// Something stands where the body shall stand.
    bool is_taken();
    /// Those that each stop a part of the way of the hand alone; `why`: how the first does.
    std::vector<int> hand_stoppers(std::size_t part, const ActionFailure*& why);
    std::vector<int> arm_stoppers(std::size_t part, const Stance& stance, Way& way,
                                  const ActionFailure*& why);
    bool hand_fails();
    /// Those that stop a lift of the hand.
    const Stopped& lift_stoppers(std::size_t lift);
    bool try_stance(Stance& stance);
    bool try_way(Stance& stance, Way& way);
    /// The hand, on the paths of the arm, touches nothing that it only just passes by.
    bool confirm(const Stance& stance, const Way& way, std::size_t lift);
    /// A path of the arm from home to `end`.
    std::optional<Path> travel(std::optional<KnownPath>& known, const Stance& stance, bool holding,
                               const Configuration& end, const std::string& phase);
    bool is_free_of_others(KnownPath& known, const Stance& stance, bool holding) const;
    /// The drives from home to the stance and back. Random motions are tried first, since most ways are easy;
    /// where they find none, the lattice says which bodies are in the way, here and for the stances after.
    bool drive(const Stance& stance, Path& there, Path& away);
    /// A path from home to the stance, which can be driven in either direction.
    std::optional<Path> drive_on_lattice(const Stance& stance, bool laden);
    /// The bodies that the best way on the lattice needs gone are logged.
    bool is_reachable(const Stance& stance, bool laden);
    std::vector<SkillSpace::Id> standing(bool laden) const;
    /// Blames the movable bodies that were met.
    void log_no_path(const MotionResult& found, const std::vector<int>& blockers, const std::string& phase);
    std::string in_the_way(const std::vector<int>& bodies) const;
    std::vector<int> movable_in(const std::vector<Contact>& contacts) const;
    void assemble(const Stance& stance, const Way& way, std::size_t lift, Path transit, Path transfer,
                  Path there, Path away);
    std::unique_ptr<CollisionChecker> checker(bool holding, int group, const Configuration& rest) const;
    Configuration home(const Stance& stance, bool holding) const;
    bool out_of_budget();

    SkillSpace& space_;
    const ManipulatorModel& model_;
    Site* site_ = nullptr;
    Skill skill_;
    int body_;
    Pose pose_;
    Grasp grasp_;
    const Budget& budget_;
    std::uint64_t variation_;
    FailureLog log_;
    WorldPointer standing_world_;  ///< the body stands at its pose
    WorldPointer holding_world_;   ///< the robot holds it
    std::vector<Other> others_;
    bool hard_drive_ = false;  ///< a drive was not easy
    Stoppers lift_stoppers_;   ///< of the hand; found out where they are asked for
    ActionMotion motion_;
};

}  // namespace praxis::tamp
