#include "practice/competence/beta.hpp"

#include <cmath>
#include <stdexcept>

namespace praxis::practice {

void check(const Beta& beta) {
    const bool valid = beta.successes > 0 && beta.failures > 0 && std::isfinite(beta.strength());
    if (!valid) throw std::invalid_argument("the counts of a Beta distribution must be positive and finite");
}

}  // namespace praxis::practice
