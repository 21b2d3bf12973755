// Plans and their text form.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/diagnostic.hpp"
#include "parser/rational.hpp"
#include "parser/task.hpp"

namespace praxis {

/// One ground action of a plan.
struct PlanStep {
    SchemaId schema;
    std::vector<ObjectId> arguments;
    Location where;  ///< in the plan file, if it was read from one

    friend bool operator==(const PlanStep& a, const PlanStep& b) {
        return a.schema == b.schema && a.arguments == b.arguments;
    }
};

struct Plan {
    std::vector<PlanStep> steps;
    Rational cost;  ///< by the task's metric; the number of steps without one
};

/// IPC format: one "(schema object ...)" a line, then "; cost = N (unit cost|general cost)" and "; Cost: N".
std::string to_string(const Plan& plan, const LiftedTask& task);

/// Reads IPC format; comments and case are free. The cost is what the file claims (`cost_claimed`), or zero.
struct ParsedPlan {
    Plan plan;
    bool cost_claimed = false;
};
/// Throws InputError with places for malformed lines, unknown actions or objects, wrong numbers or types of
/// arguments.
ParsedPlan parse_plan(const Source& source, const LiftedTask& task);

}  // namespace praxis
