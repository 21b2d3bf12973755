#include "parser/check/guards.hpp"

namespace praxis::check {
namespace {

constexpr std::size_t kMaxCopiedFormulas = 5'000'000;

}  // namespace

Formula Guards::condition(Location where) {
    if (conditions_.empty()) {
        Formula truth;
        truth.where = where;
        return truth;
    }
    Context& context = scope_.context();
    context.copied_formulas += size_;
    if (context.copied_formulas > kMaxCopiedFormulas) {
        if (!too_large_) context.reporter.error(where, "conditional effects too large");
        too_large_ = true;
        return {};
    }
    if (conditions_.size() == 1) return conditions_.front();
    Formula all;
    all.kind = Connective::conjunction;
    all.children = conditions_;
    all.where = conditions_.back().where;
    return all;
}

std::size_t Guards::count_formulas(const Formula& formula) {
    std::size_t count = 1;
    for (const Formula& child : formula.children) count += count_formulas(child);
    return count;
}

}  // namespace praxis::check
