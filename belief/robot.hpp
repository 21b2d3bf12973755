// The interfaces that a robot's program implements: skills act (`search/skills.hpp`), observers look.
//
// The loop (`Agent`) calls `Skills::execute` for each action of its plan, without parameters, and then
// `Observer::observe`. An action that is refused ends the run, unless a failure before explains it. A
// simulated world is both (`SimulatedWorld`); a camera with a vision-language model is an observer
// (`VisionObserver`). Neither ever learns which outcome of a sensing action was hoped for.
#pragma once

#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "belief/percept.hpp"
#include "search/skills.hpp"

namespace praxis::belief {

using praxis::ActionName, praxis::Execution, praxis::Skills;

/// What an observer is asked after an action (or, with no action, before the first one). After one that
/// failed, the questions are also about all that it may have changed.
struct ObservationRequest {
    const ActionName* action = nullptr;    ///< the action just executed, or failed; null at the start
    std::span<const AtomName> questions;   ///< atoms that this moment may tell about
    std::span<const std::string> objects;  ///< the objects known so far
};

/// Reads the world.
class Observer {
  public:
    virtual ~Observer() = default;
    /// Readings of any atoms (those asked, and others seen by the way), and detections. Atoms without a
    /// reading are not told about. Throws std::runtime_error if the observer is out of order.
    virtual Percept observe(const ObservationRequest& request, std::stop_token stop) = 0;
};

}  // namespace praxis::belief
