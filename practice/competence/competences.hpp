// The competences of all ground skills of a task.
//
// Skills are numbered 0, 1, ... . A skill costs nothing until its first outcome: then it gets a model of its
// own, and until then the answers are those of a fresh model, one a schema. With sharing, each cycle ends by
// fitting a prior a schema to its skills' outcomes (`SharedPrior`), so that an untried skill starts where its
// siblings are.
//
// Outcomes with parameters drawn at random for the sake of exploration say nothing about the parameter
// policy: they are counted (`outcomes`), and the models do not see them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "practice/competence/competence_model.hpp"

namespace praxis::practice {

class Competences {
  public:
    /// `schemas`: each skill's schema, not negative. Throws std::invalid_argument for a negative one, or as
    /// `make_competence_model` does.
    Competences(std::span<const std::int32_t> schemas, const CompetenceOptions& options, bool sharing);

    std::size_t size() const { return skills_.size(); }

    /// `greedy`: the parameters were the policy's choice. Throws std::invalid_argument, as all below, for a
    /// skill that there is not.
    void observe(std::size_t skill, bool success, bool greedy = true);
    /// The parameter policies have been learned anew.
    void advance_cycle();

    /// As those of `CompetenceModel`.
    double competence(std::size_t skill) const { return model(skill).competence(); }
    Beta posterior(std::size_t skill) const { return model(skill).posterior(); }
    /// Throws std::invalid_argument for negative numbers.
    double predict(std::size_t skill, int outcomes, int cycles) const;

    /// Everything observed, greedy or not.
    Counts outcomes(std::size_t skill) const;
    std::int64_t tries(std::size_t skill) const { return outcomes(skill).total(); }
    std::int64_t successes(std::size_t skill) const { return outcomes(skill).successes; }
    std::int64_t tries() const { return tries_; }  ///< of all skills
    /// Those with outcomes, in the order of their first.
    std::span<const std::size_t> tried() const { return tried_; }

  private:
    struct Skill {
        std::int32_t schema = 0;
        std::int32_t record = -1;  ///< in `records_`; -1: untried
    };
    struct Record {
        Counts outcomes;
        std::unique_ptr<CompetenceModel> model;
    };
    struct Schema {
        Beta prior;
        std::unique_ptr<CompetenceModel> untried;
        std::vector<std::size_t> records;
    };

    const Skill& skill(std::size_t number) const;
    const CompetenceModel& model(std::size_t skill) const;
    std::unique_ptr<CompetenceModel> make_model(const Beta& prior) const;
    void share(Schema& schema);

    CompetenceOptions options_;
    bool sharing_;
    std::vector<Skill> skills_;
    std::vector<Schema> schemas_;
    std::vector<Record> records_;
    std::vector<std::size_t> tried_;
    std::int64_t tries_ = 0;
};

}  // namespace praxis::practice
