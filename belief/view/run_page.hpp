// A run as one self-contained page: what was done, read and planned, and what was known, step by step.
//
// Nothing is loaded from elsewhere. A slider or the arrow keys go over the steps; atoms that changed in a
// step are marked. Of each step only the changes are kept, so that long runs stay small.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "belief/agent.hpp"

namespace praxis::belief {

/// Takes in the events of one run as they come; its `tell` is meant for the callback of `Agent::run`.
class RunRecorder {
  public:
    /// `start`: what is known before anything is read. Refers to nothing afterwards.
    explicit RunRecorder(const Belief& start);

    void tell(const Event& event, const Belief& belief);

    /// The page of what was told so far. `title`: its heading. `summary`: a line below it.
    std::string page(const std::string& title, const std::string& summary) const;

  private:
    /// A variable of the physical task and its known value, or BeliefTask::kUnknown.
    using Change = std::pair<std::int32_t, std::int32_t>;
    struct Plan {
        std::string reason;
        std::vector<std::string> actions;
    };
    /// An action with what was read after it; the first step has none.
    struct Step {
        std::string action;
        std::string failure;  ///< why the action did not run to its end
        bool failed = false;
        std::vector<std::string> read;
        std::vector<Plan> plans;      ///< made after it
        std::string end;              ///< how the run ended
        std::vector<Change> changes;  ///< what became of the knowledge during this step
    };
    struct Row;

    /// From the end of the step before to now.
    std::vector<Change> differences() const;
    std::string readable(const std::string& fact) const;
    void look(const Belief& belief);
    std::vector<Row> rows() const;

    std::shared_ptr<const BeliefTask> task_;
    /// By the name that events have for a fact ("Atom in(b1)"): "(in b1)".
    std::unordered_map<std::string, std::string> names_;
    std::vector<std::int32_t> first_;   ///< by physical variable: before anything was read
    std::vector<std::int32_t> before_;  ///< at the end of the step before
    std::vector<std::int32_t> now_;
    std::vector<Step> steps_;
};

}  // namespace praxis::belief
