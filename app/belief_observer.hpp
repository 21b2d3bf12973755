// `--observer FILE`: an observer that looks at pictures of the simulated world, in place of the world's own
// answers. Where the command was built without perception there is none.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>

#include "belief/simulated_world.hpp"

namespace praxis::app {

/// The observer is out of order; what() says why.
class ObserverError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class BeliefObserver {
  public:
    /// Reads the file. Throws std::invalid_argument if it is wrong, or if there is no perception.
    explicit BeliefObserver(const std::string& file, std::function<void(const std::string&)> warn);
    BeliefObserver(const BeliefObserver&) = delete;
    BeliefObserver& operator=(const BeliefObserver&) = delete;
    ~BeliefObserver();

    /// The world as a robot has it that sees only pictures of it. Refers to the world; its `observe` throws
    /// ObserverError. Throws std::invalid_argument if the file speaks of atoms that the task does not have.
    std::unique_ptr<belief::Environment> environment(std::shared_ptr<const belief::BeliefTask> task,
                                                     belief::SimulatedWorld& world) const;
    /// What the service has used up.
    std::string summary() const;

  private:
    struct Parts;
    std::string file_;
    std::unique_ptr<Parts> parts_;
};

}  // namespace praxis::app
