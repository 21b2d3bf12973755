// The interfaces that a robot's program implements: skills act, observers look.
//
// The loop (`Agent`) calls `Skills::execute` for each action of its plan and then `Observer::observe`. A
// simulated world is both (`SimulatedWorld`); a camera with a vision-language model is an observer
// (`VisionObserver`). Neither ever learns which outcome of a sensing action was hoped for.
#pragma once

#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "belief/percept.hpp"

namespace praxis::belief {

/// A ground action by names: words[0] is the schema, the others are objects.
struct ActionName {
    std::vector<std::string> words;
    friend auto operator<=>(const ActionName&, const ActionName&) = default;
};

/// How the execution of an action ended, as far as the robot itself can tell.
struct Execution {
    enum class Status {
        done,     ///< the skill ran to its end
        failed,   ///< it did not; it is not known whether the action has happened all the same
        illegal,  ///< the world refuses, and has not changed; the run is over, unless a failure explains it
    };
    Status status = Status::done;
    std::string message;  ///< why not
};

/// Executes actions.
class Skills {
  public:
    virtual ~Skills() = default;
    virtual Execution execute(const ActionName& action, std::stop_token stop) = 0;
};

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
