#include <stdexcept>

#include "practice/competence/beta_model.hpp"
#include "practice/competence/latent_model.hpp"
#include "practice/competence/optimistic_model.hpp"

namespace praxis::practice {

std::unique_ptr<CompetenceModel> make_competence_model(const CompetenceOptions& options) {
    check(options.prior);
    if (!(options.bonus >= 0 && options.bonus <= 1))
        throw std::invalid_argument("the bonus must be between 0 and 1");
    if (options.window < 1 || options.recency < 1)
        throw std::invalid_argument("window and recency must be at least one cycle");
    if (options.model == "beta") return std::make_unique<BetaModel>(options.prior, options.bonus);
    if (options.model == "optimistic")
        return std::make_unique<OptimisticModel>(options.prior, options.window, options.recency,
                                                 options.bonus);
    if (options.model == "latent") return std::make_unique<LatentModel>(options.prior, options.bonus);
    throw std::invalid_argument("there is no competence model '" + options.model +
                                "'; there are: beta, optimistic, latent");
}

}  // namespace praxis::practice
