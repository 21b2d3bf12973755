#include "search/engines/turns.hpp"

#include <algorithm>

namespace praxis {

Turns::Turns(std::size_t engines, std::size_t at_once) : woken_(engines), running_(engines, 0) {
    for (std::size_t engine = 0; engine < engines; ++engine) {
        if (engine < at_once) {
            running_[engine] = 1;
        } else {
            waiting_.push_back(engine);
        }
    }
}

void Turns::enter(std::size_t engine) {
    std::unique_lock lock(mutex_);
    woken_[engine].wait(lock, [&] { return running_[engine] != 0; });
}

void Turns::pass(std::size_t engine) {
    std::unique_lock lock(mutex_);
    if (waiting_.empty()) return;
    running_[engine] = 0;
    waiting_.push_back(engine);
    next();
    woken_[engine].wait(lock, [&] { return running_[engine] != 0; });
}

void Turns::leave(std::size_t engine) {
    const std::scoped_lock lock(mutex_);
    if (running_[engine] == 0) {  // it never began
        std::erase(waiting_, engine);
        return;
    }
    running_[engine] = 0;
    if (!waiting_.empty()) next();
}

void Turns::next() {
    const std::size_t engine = waiting_.front();
    waiting_.pop_front();
    running_[engine] = 1;
    woken_[engine].notify_one();
}

}  // namespace praxis
