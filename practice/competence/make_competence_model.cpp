#include <stdexcept>

#include "practice/competence/beta_model.hpp"
#include "practice/competence/latent_model.hpp"
#include "practice/competence/optimistic_model.hpp"

namespace praxis::practice {

namespace {

using ModelPointer = std::unique_ptr<CompetenceModel>;

struct Entry {
    const char* name;
    const char* description;
    ModelPointer (*make)(const CompetenceOptions& options);
};

constexpr Entry kEntries[] = {
    {"beta", "the mean over all outcomes; practice is expected to add a fixed bonus",
     [](const CompetenceOptions& o) -> ModelPointer {
         return std::make_unique<BetaModel>(o.prior, o.bonus);
     }},
    {"optimistic", "the mean over the last cycles; practice is expected to repeat the largest recent growth",
     [](const CompetenceOptions& o) -> ModelPointer {
         return std::make_unique<OptimisticModel>(o.prior, o.window, o.recency, o.bonus);
     }},
    {"latent", "a learning curve of the number of outcomes, fitted by expectation maximisation",
     [](const CompetenceOptions& o) -> ModelPointer {
         return std::make_unique<LatentModel>(o.prior, o.bonus);
     }},
};

}  // namespace

std::vector<Component> competence_models() {
    std::vector<Component> result;
    for (const Entry& entry : kEntries) result.push_back({entry.name, entry.description});
    return result;
}

std::unique_ptr<CompetenceModel> make_competence_model(const CompetenceOptions& options) {
    check(options.prior);
    if (!(options.bonus >= 0 && options.bonus <= 1))
        throw std::invalid_argument("the bonus must be between 0 and 1");
    if (options.window < 1 || options.recency < 1)
        throw std::invalid_argument("window and recency must be at least one cycle");
    std::string names;
    for (const Entry& entry : kEntries) {
        if (options.model == entry.name) return entry.make(options);
        names += (names.empty() ? "" : ", ") + std::string(entry.name);
    }
    throw std::invalid_argument("there is no competence model '" + options.model + "'; there are: " + names);
}

}  // namespace praxis::practice
