#include "tamp/collision/body_checker.hpp"

#include <algorithm>
#include <stdexcept>

#include "tamp/collision/standing_bodies.hpp"

namespace praxis::tamp {

BodyChecker::BodyChecker(WorldPointer world, std::shared_ptr<SolidCache> cache) : world_(std::move(world)) {
    if (!world_) throw std::invalid_argument("a body checker needs a world");
    if (!cache) cache = std::make_shared<SolidCache>();
    standing_ = std::make_unique<const StandingBodies>(*world_, *cache);
    solids_.reserve(world_->size());
    for (const BodyState& body : world_->bodies()) solids_.push_back(cache->make(body.model->shapes));
}

BodyChecker::~BodyChecker() = default;
BodyChecker::BodyChecker(BodyChecker&&) noexcept = default;
BodyChecker& BodyChecker::operator=(BodyChecker&&) noexcept = default;

/// Calls `report` with each body that is touched until it returns true; may repeat one.
template <class Report>
void BodyChecker::each_contact(int body, const Pose& pose, Report&& report) const {
    if (body < 0 || static_cast<std::size_t>(body) >= world_->size()) {
        throw std::invalid_argument("there is no body number " + std::to_string(body));
    }
    if (!is_finite(pose)) throw std::invalid_argument("the pose of a body is not finite");
    const Participant self = {Participant::Kind::body, body};
    for (const Solid& solid : solids_[static_cast<std::size_t>(body)]) {
        const Pose placed = pose * solid.pose;
        const bool stopped = standing_->tree().any_of(moved(solid.extent, placed), [&](std::size_t index) {
            const StandingBodies::Part& part = (*standing_)[index];
            return part.body != body && !world_->allowed(self, {Participant::Kind::body, part.body}) &&
                   touch(solid, placed, part.solid, part.pose) && report(part.body);
        });
        if (stopped) return;
    }
}

bool BodyChecker::is_free(int body, const Pose& pose, std::span<const int> ignored) const {
    bool free = true;
    each_contact(body, pose, [&](int other) {
        if (std::ranges::find(ignored, other) == ignored.end()) free = false;
        return !free;
    });
    return free;
}

std::vector<int> BodyChecker::contacts(int body, const Pose& pose) const {
    std::vector<int> touched;
    each_contact(body, pose, [&](int other) {
        touched.push_back(other);
        return false;
    });
    std::ranges::sort(touched);
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    return touched;
}

}  // namespace praxis::tamp
