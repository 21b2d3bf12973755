#include "belief/policies/policy.hpp"

#include <stdexcept>

#include "belief/policies/prepared_policy.hpp"
#include "belief/policies/random_policy.hpp"
#include "belief/policies/sense_first_policy.hpp"

namespace praxis::belief {
namespace {

/// Leaves everything to the loop.
class PlanPolicy : public Policy {
  public:
    Decision next(Belief&, const Budget&) override { return {Decision::Kind::plan}; }
};

constexpr PolicyKind kKinds[] = {
    {"best",
     "follows the best plan for all readings where one was made beforehand, and does as 'plan' otherwise",
     [](const PolicyContext& context) -> std::unique_ptr<Policy> {
         if (context.prepared) return std::make_unique<PreparedPolicy>(context.prepared);
         return std::make_unique<PlanPolicy>();
     }},
    {"plan", "follows a plan that assumes the readings it needs, and plans anew when they are otherwise",
     [](const PolicyContext&) -> std::unique_ptr<Policy> { return std::make_unique<PlanPolicy>(); }},
    {"random", "chooses among the actions that are known to be possible, all equally likely",
     [](const PolicyContext& context) -> std::unique_ptr<Policy> {
         return std::make_unique<RandomPolicy>(context, false);
     }},
    {"random-any", "chooses among all ground actions; impossible ones do nothing but count",
     [](const PolicyContext& context) -> std::unique_ptr<Policy> {
         return std::make_unique<RandomPolicy>(context, true);
     }},
    {"sense-first", "reads everything that can be read, the nearest first, and plans then",
     [](const PolicyContext& context) -> std::unique_ptr<Policy> {
         return std::make_unique<SenseFirstPolicy>(context);
     }},
};

}  // namespace

std::span<const PolicyKind> policy_kinds() {
    return kKinds;
}

std::unique_ptr<Policy> make_policy(const std::string& name, const PolicyContext& context) {
    std::string names;
    for (const PolicyKind& kind : kKinds) {
        if (name == kind.name) return kind.make(context);
        names += (names.empty() ? "" : ", ") + std::string(kind.name);
    }
    throw std::invalid_argument("there is no policy '" + name + "'; there are: " + names);
}

}  // namespace praxis::belief
