// The quantifiers and conditions around a literal while nested effects (or sensing models) are flattened.
#pragma once

#include <cstdint>
#include <vector>

#include "parser/check/conditions.hpp"
#include "parser/check/scope.hpp"

namespace praxis::check {

class Guards {
  public:
    explicit Guards(ScopeBuilder& scope) : scope_(scope) {}

    /// Calls inside(body) for a node `forall`, with its variables visible.
    template <class Inside>
    void universal(syntax::NodeIndex index, Inside inside) {
        const std::size_t outer = scope_.visible();
        const std::size_t outer_variables = variables_.size();
        const std::vector<std::uint32_t> bound = scope_.bind_quantified(scope_.tree().nodes[index].variables);
        variables_.insert(variables_.end(), bound.begin(), bound.end());
        inside(index + 1);
        variables_.resize(outer_variables);
        scope_.unbind(outer);
    }

    /// Calls inside(body) for a node `when`, under its condition.
    template <class Inside>
    void conditional(syntax::NodeIndex index, Inside inside) {
        conditions_.push_back(check_condition(scope_, index + 1));
        const std::size_t size = count_formulas(conditions_.back());
        size_ += size;
        inside(scope_.tree().nodes[index + 1].end);
        size_ -= size;
        conditions_.pop_back();
    }

    bool empty() const { return conditions_.empty() && variables_.empty(); }
    const std::vector<std::uint32_t>& variables() const { return variables_; }

    /// The conjunction of the conditions; truth, placed at `where`, if there are none. All copies together
    /// are limited; beyond, an error is reported.
    Formula condition(Location where);

  private:
    static std::size_t count_formulas(const Formula& formula);

    ScopeBuilder& scope_;
    std::vector<std::uint32_t> variables_;
    std::vector<Formula> conditions_;
    std::size_t size_ = 0;
    bool too_large_ = false;
};

}  // namespace praxis::check
