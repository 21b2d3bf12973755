// Atoms and actions by their names, and what they are in one ground task. Robots speak in names; ids change
// when a task grows.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "belief/belief_task.hpp"
#include "belief/percept.hpp"
#include "belief/robot.hpp"

namespace praxis::belief {

class AtomNames {
  public:
    /// Refers to the task.
    explicit AtomNames(const BeliefTask& task);

    /// The fact that says that the atom holds; nothing for atoms that are not variables of the ground task.
    std::optional<Fact> fact(const AtomName& atom) const;
    std::optional<std::uint32_t> action(const ActionName& action) const;
    bool has_object(const std::string& name) const { return objects_.contains(name); }

    static AtomName name(const FiniteDomainTask& task, Fact fact);
    static ActionName name(const FiniteDomainTask& task, std::uint32_t action);

  private:
    const BeliefTask* task_;
    std::unordered_map<std::string, std::size_t> predicates_, objects_;
    std::unordered_map<std::string, std::uint32_t> actions_;  ///< by words joined by blanks
};

}  // namespace praxis::belief
