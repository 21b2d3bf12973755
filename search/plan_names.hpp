// From ground operators to plan steps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/plan.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// Knows the schema or object behind every symbol in the operators' names. Refers to the ground task.
class PlanNames {
  public:
    PlanNames(const LiftedTask& lifted, const FiniteDomainTask& ground);

    Plan plan(std::span<const OperatorId> operators, std::int64_t cost) const;

  private:
    const FiniteDomainTask& ground_;
    std::vector<std::uint32_t> schemas_;  ///< by symbol
    std::vector<std::uint32_t> objects_;
};

}  // namespace praxis
