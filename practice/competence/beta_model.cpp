#include "practice/competence/beta_model.hpp"

namespace praxis::practice {

void BetaModel::set_prior(Beta prior) {
    check(prior);
    prior_ = prior;
}

double BetaModel::predict(int /*outcomes*/, int /*cycles*/) const {
    return clip(competence() + bonus_);
}

}  // namespace praxis::practice
