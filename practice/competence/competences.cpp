#include "practice/competence/competences.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "practice/competence/shared_prior.hpp"

namespace praxis::practice {

Competences::Competences(std::span<const std::int32_t> schemas, const CompetenceOptions& options,
                         bool sharing)
    : options_(options), sharing_(sharing) {
    make_competence_model(options);
    std::size_t count = 0;
    skills_.reserve(schemas.size());
    for (const std::int32_t schema : schemas) {
        if (schema < 0) throw std::invalid_argument("the number of a skill's schema must not be negative");
        count = std::max(count, static_cast<std::size_t>(schema) + 1);
        skills_.push_back({schema});
    }
    schemas_.resize(count);
    for (Schema& schema : schemas_) {
        schema.prior = options.prior;
        schema.untried = make_model(options.prior);
    }
}

std::unique_ptr<CompetenceModel> Competences::make_model(const Beta& prior) const {
    CompetenceOptions options = options_;
    options.prior = prior;
    return make_competence_model(options);
}

const Competences::Skill& Competences::skill(std::size_t number) const {
    if (number >= skills_.size())
        throw std::invalid_argument("there is no skill " + std::to_string(number) + "; there are " +
                                    std::to_string(skills_.size()));
    return skills_[number];
}

const CompetenceModel& Competences::model(std::size_t number) const {
    const Skill& one = skill(number);
    if (one.record < 0) return *schemas_[static_cast<std::size_t>(one.schema)].untried;
    return *records_[static_cast<std::size_t>(one.record)].model;
}

void Competences::observe(std::size_t number, bool success, bool greedy) {
    if (skill(number).record < 0) {
        Skill& one = skills_[number];
        Schema& schema = schemas_[static_cast<std::size_t>(one.schema)];
        one.record = static_cast<std::int32_t>(records_.size());
        schema.records.push_back(records_.size());
        records_.push_back({{}, make_model(schema.prior)});
        tried_.push_back(number);
    }
    Record& record = records_[static_cast<std::size_t>(skills_[number].record)];
    record.outcomes.add(success);
    ++tries_;
    if (greedy) record.model->observe(success);
}

void Competences::advance_cycle() {
    if (sharing_)
        for (Schema& schema : schemas_)
            if (!schema.records.empty()) share(schema);
    for (Record& record : records_) record.model->advance_cycle();
}

void Competences::share(Schema& schema) {
    std::vector<Counts> evidence;
    evidence.reserve(schema.records.size());
    for (const std::size_t record : schema.records) evidence.push_back(records_[record].model->evidence());
    const SharedPrior shared(evidence, options_.prior);
    for (std::size_t i = 0; i < evidence.size(); ++i)
        records_[schema.records[i]].model->set_prior(shared.without(evidence[i]));
    schema.prior = shared.prior();
    schema.untried->set_prior(schema.prior);
}

double Competences::predict(std::size_t number, int outcomes, int cycles) const {
    if (outcomes < 0 || cycles < 0)
        throw std::invalid_argument("outcomes and cycles to come must not be negative");
    return model(number).predict(outcomes, cycles);
}

Counts Competences::outcomes(std::size_t number) const {
    const std::int32_t record = skill(number).record;
    return record < 0 ? Counts{} : records_[static_cast<std::size_t>(record)].outcomes;
}

}  // namespace praxis::practice
