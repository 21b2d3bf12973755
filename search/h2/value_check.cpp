#include "search/h2/value_check.hpp"

namespace praxis {

ValueCheck::ValueCheck(const FiniteDomainTask& task)
    : task_(task), last_((task.fact_count() + 63) / 64, 0), rest_(last_) {
    for (std::uint32_t v = 0; v < task.variable_count(); ++v) {
        if (task.axiom_layers[v] >= 0) continue;
        const std::uint32_t first = task.first_fact[v];
        const std::uint32_t last = task.first_fact[v + 1] - 1;
        if (first / 64 != last / 64) {
            wide_.push_back(v);
            continue;
        }
        for (std::uint32_t fact = first; fact < last; ++fact) insert(rest_, fact);
        insert(last_, last);
    }
}

}  // namespace praxis
