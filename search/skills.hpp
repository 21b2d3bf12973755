// Skills: what a robot can do, as planners speak of it. The one interface between plans and motion.
//
// A skill is an *option* (I, pi, beta, phi): where it can start (I, the initiation), how it acts (pi, the
// policy), when it ends (beta, the termination), and numbers that its name leaves open (phi, the parameters:
// a grasp, an offset, a force). A planner knows a skill by its name and what it should bring about; the rest
// is behind `Skills::execute`: called outside I it refuses (`illegal`), otherwise it runs pi until beta.
//
// Three layers meet here. The loop of belief (`belief/agent.hpp`) executes names, looks, and plans again; the
// loop of practice (`practice/loop/skill_world.hpp`) executes names with parameters that it learns; steps of
// task and motion plans (`tamp/skills/refined_skills.hpp`) are such skills. A robot's program implements
// `Skills` once for all of them.
//
// Source: Sutton, Precup and Singh, "Between MDPs and semi-MDPs", Artificial Intelligence 112, 1999; with
// parameters and contracts: Zhao's thesis (2025), section 2.2.2.
#pragma once

#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace praxis {

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
        illegal,  ///< refused: it cannot start here, and nothing has changed
    };
    Status status = Status::done;
    std::string message;  ///< why not
};

/// Executes actions.
class Skills {
  public:
    virtual ~Skills() = default;
    /// Runs the skill to its end, or until it is told to stop (then it has failed). `parameters`: the numbers
    /// that the name leaves open, in an order that the skill defines; none: it chooses them itself.
    virtual Execution execute(const ActionName& action, std::span<const double> parameters,
                              std::stop_token stop) = 0;
};

}  // namespace praxis
