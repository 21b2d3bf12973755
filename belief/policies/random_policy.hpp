// Acting at random.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "belief/policies/policy.hpp"
#include "search/engines/random.hpp"

namespace praxis::belief {

class RandomPolicy : public Policy {
  public:
    /// `any`: among all actions; otherwise among those that are known to be possible.
    RandomPolicy(const PolicyContext& context, bool any) : random_(context.seed), any_(any) {}

    Decision next(Belief& belief, const Budget& budget) override;
    bool tries_anything() const override { return any_; }

  private:
    Random random_;
    bool any_;
    std::vector<std::uint32_t> possible_;
};

}  // namespace praxis::belief
