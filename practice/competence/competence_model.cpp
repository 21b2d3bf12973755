#include "practice/competence/competence_model.hpp"

#include <algorithm>

namespace praxis::practice {

double CompetenceModel::competence() const {
    return std::clamp(posterior().mean(), 1e-6, 1.0);
}

}  // namespace praxis::practice
