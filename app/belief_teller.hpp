// Tells the events of runs: for people, or as lines of JSON.
#pragma once

#include <cstddef>
#include <string>

#include "belief/agent.hpp"

namespace praxis::app {

class BeliefTeller {
  public:
    /// What is wanted.
    BeliefTeller(bool text, bool trace) : wants_text_(text), wants_trace_(trace) {}

    /// The events that follow are of this world.
    void begin(std::size_t world) { world_ = world; }
    void tell(const belief::Event& event, const belief::Belief& belief);

    const std::string& text() const { return text_; }
    const std::string& trace() const { return trace_; }

  private:
    void tell_json(const belief::Event& event, const std::string& action, const belief::Belief& belief);

    bool wants_text_, wants_trace_;
    std::size_t world_ = 0;
    std::string text_;
    std::string trace_;
};

}  // namespace praxis::app
