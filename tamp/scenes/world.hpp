// What surrounds the robot: bodies with poses, what is attached to the robot, and which contacts are allowed.
//
// A `World` is an immutable snapshot: changes make a new one and share the shapes, so that a snapshot may be
// kept, compared and read by other threads. Bodies keep their numbers in all snapshots made from one another.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tamp/geometry/shape.hpp"

namespace praxis::tamp {

/// What does not change of a body.
struct BodyModel {
    std::string name = {};
    std::vector<PlacedShape> shapes = {};
    std::vector<Ball> balls =
        {};                ///< cover the shapes wholly; made by `make_body` unless there is a map among them
    bool movable = false;  ///< the robot may move it
    std::array<float, 3> color = {0.7F, 0.7F, 0.7F};  ///< red, green, blue in [0, 1]
};

/// Held by the robot: its pose is that of the link times `in_link`.
struct Attachment {
    int link = 0;
    Pose in_link = Pose::Identity();
    std::vector<int> touching = {};  ///< links that may touch it (the hand and its fingers)
};

struct BodyState {
    std::shared_ptr<const BodyModel> model = {};
    Pose pose = Pose::Identity();  ///< in the world; means nothing while attached
    std::optional<Attachment> attachment = {};
};

/// One of two things that touch: a link of the robot, or a body (by number).
struct Participant {
    enum class Kind : std::uint8_t { link, body };
    Kind kind = Kind::link;
    int index = 0;
    friend auto operator<=>(const Participant&, const Participant&) = default;
};

struct Contact {
    Participant first;
    Participant second;
    friend auto operator<=>(const Contact&, const Contact&) = default;
};

class World {
  public:
    World() = default;

    std::size_t size() const { return bodies_.size(); }
    const BodyState& operator[](int body) const { return bodies_[static_cast<std::size_t>(body)]; }
    const std::vector<BodyState>& bodies() const { return bodies_; }
    /// -1 if there is none.
    int find(std::string_view name) const;
    /// Bodies that may touch each other, and links that may touch bodies: not checked.
    bool allowed(const Participant& first, const Participant& second) const;

    /// Each makes another snapshot. They throw std::invalid_argument for numbers out of range, names that are
    /// there already and poses that are not finite.
    World with_body(std::shared_ptr<const BodyModel> model, const Pose& pose) const;
    /// Stands there; no longer attached.
    World with_pose(int body, const Pose& pose) const;
    World with_attached(int body, const Attachment& attachment) const;
    World with_allowed(const Participant& first, const Participant& second) const;

  private:
    std::vector<BodyState> bodies_ = {};
    std::vector<Contact> allowed_ = {};  ///< sorted; the smaller participant first
};

using WorldPointer = std::shared_ptr<const World>;

}  // namespace praxis::tamp
