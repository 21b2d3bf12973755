#include "practice/competence/competence_model.hpp"

#include <algorithm>

namespace praxis::practice {

double CompetenceModel::clip(double probability) {
    return std::clamp(probability, 1e-6, 1.0);
}

double CompetenceModel::competence() const {
    return clip(posterior().mean());
}

}  // namespace praxis::practice
