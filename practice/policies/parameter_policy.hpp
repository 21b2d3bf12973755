// How a skill's parameters are chosen: candidates from the base sampler, scored by a classifier of success.
//
// A policy belongs to a skill schema and so serves all its ground skills. It keeps every outcome ever seen.
// Until both a success and a failure are among them, a candidate is chosen at random.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "practice/policies/classifier.hpp"

namespace praxis::practice {

struct PolicyOptions {
    ClassifierOptions classifier = {};
    int candidates = 100;
    /// How parameters are explored while practising: "epsilon-greedy" (random with probability `epsilon`,
    /// else the best), "uncertain" (the candidate that the classifier is least sure of with probability
    /// `epsilon`, else the best).
    std::string exploration = "epsilon-greedy";
    double epsilon = 0.5;
    /// Which features the classifier sees: "all", "relevant" (see SkillSchema::relevant_features), or
    /// "selected" (those that data say matter).
    std::string features = "relevant";
};

class ParameterPolicy {
  public:
    /// `features`: how many a state has; `relevant`: which of them matter; `parameters`: the dimension.
    /// Throws std::invalid_argument for options out of range.
    ParameterPolicy(std::size_t features, std::vector<std::size_t> relevant, std::size_t parameters,
                    const PolicyOptions& options);
    ~ParameterPolicy();
    ParameterPolicy(ParameterPolicy&&) noexcept;
    ParameterPolicy& operator=(ParameterPolicy&&) noexcept;

    /// The number of the candidate that most likely succeeds; `candidates` holds their parameters, one after
    /// the other.
    std::size_t best(std::span<const double> features, std::span<const double> candidates,
                     Random& random) const;
    struct Choice {
        std::size_t candidate = 0;
        bool greedy = true;  ///< it was the best, so that its outcome tells about the policy's competence
    };
    /// The same for practice.
    Choice explore(std::span<const double> features, std::span<const double> candidates,
                   Random& random) const;

    void observe(std::span<const double> features, std::span<const double> parameters, bool success);
    /// Learns from all outcomes; cheap if there are none since the last time.
    void learn(Random& random);
    std::size_t outcomes() const;
    /// The probability of success that the classifier gives; 0.5 before it has learned.
    double probability(std::span<const double> features, std::span<const double> parameters) const;

  private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace praxis::practice
