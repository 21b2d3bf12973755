#include "tamp/manipulation/join_motions.hpp"

#include <algorithm>

#include "tamp/manipulation/manipulator_model.hpp"

namespace praxis::tamp {

namespace {

/// Executes pieces as far as configuration and world go.
struct Progress {
    const Robot* robot;
    Configuration configuration;
    World world;

    void follow(const MotionPiece& piece) {
        if (!piece.path.empty()) {
            robot->insert(robot->groups[static_cast<std::size_t>(piece.group)], piece.path.back(),
                          configuration);
        }
        if (piece.attach) world = world.with_attached(piece.attach->first, piece.attach->second);
        if (piece.detach) world = world.with_pose(piece.detach->first, piece.detach->second);
    }
};

using Pieces = std::vector<MotionPiece>;

/// How many pieces at the end of `pieces` lead home.
std::size_t trailing(const Pieces& pieces) {
    const auto last =
        std::find_if_not(pieces.rbegin(), pieces.rend(), [](const MotionPiece& p) { return p.homing; });
    return static_cast<std::size_t>(last - pieces.rbegin());
}

std::size_t leading(const Pieces& pieces) {
    const auto first = std::ranges::find_if_not(pieces, [](const MotionPiece& p) { return p.homing; });
    return static_cast<std::size_t>(first - pieces.begin());
}

class Joiner {
  public:
    Joiner(const Manipulator& manipulator, const World& world, const Budget& budget)
        : model_(manipulator.model()), budget_(budget), progress_{model_.robot.get(), model_.home, world} {}

    /// Replaces what leads home at the end of `before` and out again at the begin of `after`. `progress_` is
    /// at the begin of `before`, and then at the begin of `after`.
    void join(Pieces& before, Pieces& after) {
        const std::size_t kept = before.size() - trailing(before);
        for (std::size_t i = 0; i < kept; ++i) progress_.follow(before[i]);
        const std::size_t begin = leading(after);
        Pieces home(before.begin() + static_cast<std::ptrdiff_t>(kept), before.end());
        Pieces out(after.begin(), after.begin() + static_cast<std::ptrdiff_t>(begin));
        Pieces between = model_.base < 0 || same_base(home, out) ? direct(home, out) : by_base(home, out);
        before.resize(kept);
        after.erase(after.begin(), after.begin() + static_cast<std::ptrdiff_t>(begin));
        after.insert(after.begin(), between.begin(), between.end());
    }

  private:
    static const MotionPiece* piece_of(const Pieces& pieces, int group) {
        const auto found = std::ranges::find(pieces, group, &MotionPiece::group);
        return found == pieces.end() ? nullptr : &*found;
    }

    bool same_base(const Pieces& home, const Pieces& out) const {
        const MotionPiece* drive = piece_of(home, model_.base);
        const MotionPiece* next = piece_of(out, model_.base);
        if (!drive && !next) return true;
        return drive && next && drive->path.front() == next->path.back();
    }

    /// The arm goes from where it is to where the next action wants it.
    Pieces direct(const Pieces& home, const Pieces& out) {
        const MotionPiece* back = piece_of(home, model_.arm);
        const MotionPiece* forth = piece_of(out, model_.arm);
        if (!back || !forth) return both(home, out);
        return replace(*back, *forth, both(home, out));
    }

    /// The arm is folded, the base goes from where it is to where the next action wants it.
    Pieces by_base(const Pieces& home, const Pieces& out) {
        const MotionPiece* back = piece_of(home, model_.base);
        const MotionPiece* forth = piece_of(out, model_.base);
        if (!back || !forth) return both(home, out);
        Pieces result;
        const Progress begin = progress_;
        for (const MotionPiece& piece : home) {
            if (piece.group != model_.base) {
                progress_.follow(piece);
                result.push_back(piece);
            }
        }
        Pieces drive = replace(*back, *forth, {*back, *forth});
        progress_ = begin;
        std::ranges::move(drive, std::back_inserter(result));
        for (const MotionPiece& piece : out) {
            if (piece.group != model_.base) result.push_back(piece);
        }
        return result;
    }

    static Pieces both(const Pieces& home, const Pieces& out) {
        Pieces pieces = home;
        pieces.insert(pieces.end(), out.begin(), out.end());
        return pieces;
    }

    /// One motion from where `back` begins to where `forth` ends, or else what there is.
    Pieces replace(const MotionPiece& back, const MotionPiece& forth, Pieces otherwise) {
        const Configuration& goal = forth.path.back();
        if (back.path.front() == goal) return {};
        const auto checker = model_.checker(std::make_shared<const World>(progress_.world), forth.group,
                                            progress_.configuration);
        MotionResult found = model_.travel(*checker, back.path.front(), goal, 0, budget_);
        if (found.status != MotionStatus::solved ||
            path_length(found.path) > path_length(back.path) + path_length(forth.path)) {
            return otherwise;
        }
        MotionPiece direct = forth;
        direct.path = std::move(found.path);
        return {std::move(direct)};
    }

    const ManipulatorModel& model_;
    const Budget& budget_;
    Progress progress_;
};

}  // namespace

std::vector<ActionMotion> join_motions(const Manipulator& manipulator, const World& world,
                                       std::vector<ActionMotion> motions, const Budget& budget) {
    Joiner joiner(manipulator, world, budget);
    for (std::size_t i = 0; i + 1 < motions.size(); ++i)
        joiner.join(motions[i].pieces, motions[i + 1].pieces);
    return motions;
}

}  // namespace praxis::tamp
