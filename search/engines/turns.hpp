// Turns of several engines that run on threads of their own.
//
// At most `at_once` of them run at any time; the others wait in a queue. A search counts what it does and,
// when its turn is over, goes to the end of the queue; each of its turns is twice as long as the one before,
// up to a limit. Nothing is lost by waiting: a search goes on where it stood. With one turn at a time, who
// runs when depends on counted work alone, so that a run can be repeated.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <vector>

namespace praxis {

class Turns {
  public:
    /// `engines` of them, to begin in their order.
    Turns(std::size_t engines, std::size_t at_once);
    Turns(const Turns&) = delete;
    Turns& operator=(const Turns&) = delete;

    /// Waits for the first turn of an engine.
    void enter(std::size_t engine);
    /// Gives the turn to whoever has waited longest, if anybody waits, and waits for the next one.
    void pass(std::size_t engine);
    /// The engine will never run again.
    void leave(std::size_t engine);

  private:
    void next();

    std::mutex mutex_;
    std::vector<std::condition_variable> woken_;  ///< by engine
    std::vector<char> running_;                   ///< by engine
    std::deque<std::size_t> waiting_;
};

/// An engine's place among others, and the length of its turns.
class Seat {
  public:
    /// `work`: of the first turn; see `SearchMonitor` for how searches count it.
    Seat(Turns& turns, std::size_t engine, std::uint64_t work)
        : turns_(&turns), engine_(engine), turn_(work), longest_(work * kLongest) {}

    /// How much work a turn that begins now may do.
    std::uint64_t work() const { return turn_; }
    void pass() {
        turns_->pass(engine_);
        turn_ = turn_ * 2 < longest_ ? turn_ * 2 : longest_;
    }

  private:
    static constexpr std::uint64_t kLongest = 8;  ///< times the first turn

    Turns* turns_;
    std::size_t engine_;
    std::uint64_t turn_;
    std::uint64_t longest_;
};

}  // namespace praxis
