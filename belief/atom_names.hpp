// Atoms and actions by their names, and what they are in one ground task. Robots speak in names; ids change
// when a task grows.
#pragma once

#include <optional>
#include <string>
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
    std::optional<Fact> fact(const GroundLiteral& literal) const;  ///< whatever its sign
    /// The atom in terms of the source; nothing if there is no such predicate of so many objects.
    std::optional<GroundLiteral> literal(const AtomName& atom) const;
    /// What the fact says, in terms of the source; nothing for "none of those" and for atoms of the
    /// grounder's own.
    std::optional<GroundLiteral> literal(Fact fact) const;

    static AtomName name(const FiniteDomainTask& task, Fact fact);
    static ActionName name(const FiniteDomainTask& task, std::uint32_t action);

  private:
    const BeliefTask* task_;
    std::unordered_map<std::string, std::size_t> predicates_, objects_;
};

class ActionNames {
  public:
    explicit ActionNames(const FiniteDomainTask& task);

    std::optional<std::uint32_t> action(const ActionName& name) const;

  private:
    std::unordered_map<std::string, std::uint32_t> actions_;  ///< by words joined by blanks
};

}  // namespace praxis::belief
