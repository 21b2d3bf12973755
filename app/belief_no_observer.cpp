// The command without perception (PRAXIS_BUILD_PERCEPTION is off).
#include <utility>

#include "app/belief_observer.hpp"

namespace praxis::app {

struct BeliefObserver::Parts {};

BeliefObserver::BeliefObserver(const std::string& file, std::function<void(const std::string&)>)
    : file_(file) {
    throw std::invalid_argument(
        "--observer needs a 'plan' that was built with perception: cmake "
        "-DPRAXIS_BUILD_PERCEPTION=ON");
}

BeliefObserver::~BeliefObserver() = default;

std::unique_ptr<belief::Environment> BeliefObserver::environment(std::shared_ptr<const belief::BeliefTask>,
                                                                 belief::SimulatedWorld&) const {
    return nullptr;
}

std::string BeliefObserver::summary() const {
    return {};
}

}  // namespace praxis::app
