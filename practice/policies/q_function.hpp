// The value of executing a ground skill with parameters in a state: what MAPLE-Q acts by.
//
// Source: Nasiriany et al., "Augmenting Reinforcement Learning with Behavior Primitives", ICRA 2022, reduced
// to one network for skills and parameters as in the baseline of Kumar et al., RSS 2024: a perceptron of the
// state's features, the ground skill (one-hot) and its parameters, fitted to
//
//   Q(s, a) = reward + discount * max over some sampled a' that can start in s' of Q'(s', a')
//
// where Q' is a copy that stays while one iteration lasts. The network goes on from where it was the last
// time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "practice/policies/mlp.hpp"
#include "practice/policies/standardisation.hpp"

namespace praxis::practice {

struct QOptions {
    std::vector<std::size_t> hidden = {32, 32};
    double discount = 0.8;         ///< in [0, 1)
    std::size_t replay = 100'000;  ///< transitions kept; the oldest makes room for a new one
    int iterations = 5;            ///< of one `learn`, each with a new copy Q'
    int steps = 50;                ///< of training in an iteration
    std::size_t batch = 32;        ///< transitions a step
    double learning_rate = 3e-3;   ///< Adam
};

class QFunction {
  public:
    /// A ground skill by its number, with parameters: as many as it has, at most the largest dimension.
    struct Action {
        std::size_t skill = 0;
        std::vector<double> parameters;
    };
    struct Transition {
        std::vector<double> features;
        Action action;
        double reward = 0;
        std::vector<double> next_features;
        /// What can start next, each ground skill with some sampled parameters; none is like `terminal`.
        std::vector<Action> next_actions;
        bool terminal = false;
    };

    /// `features`: of a state; `skills`: ground ones; `parameters`: the largest dimension. Throws
    /// std::invalid_argument for options out of range.
    QFunction(std::size_t features, std::size_t skills, std::size_t parameters, QOptions options = {});

    /// Throws std::invalid_argument for sizes that do not fit, or numbers that are not finite.
    void add(const Transition& transition);
    std::size_t transitions() const { return replay_.size(); }
    /// Fits to the transitions; nothing if there are none. The same transitions, calls and seed give the same
    /// function.
    void learn(Random& random);

    /// 0 before `learn`.
    double value(std::span<const double> features, const Action& action) const;
    /// The values of several actions in one state.
    void values(std::span<const double> features, std::span<const Action> actions,
                std::span<double> result) const;

  private:
    struct FlatAction {
        std::size_t skill;
        std::vector<float> parameters;  // padded with 0
    };
    struct Stored {
        std::vector<float> features, next_features;
        FlatAction action;
        std::vector<FlatAction> next_actions;  // none: terminal
        float reward;
    };

    std::vector<float> finite_features(std::span<const double> features) const;
    FlatAction flat(const Action& action) const;
    void write_row(const std::vector<float>& features, const FlatAction& action, float* row) const;
    void standardise();
    /// reward + discount * the best next value, of each transition.
    void targets(const std::vector<std::size_t>& transitions, const Mlp& network,
                 std::vector<float>& result) const;

    std::size_t features_, skills_, parameters_;
    QOptions options_;
    std::vector<Stored> replay_;
    std::size_t oldest_ = 0;
    std::vector<Standardisation> standard_;  // of features, then parameters
    Mlp network_;
    bool learned_ = false;
};

}  // namespace praxis::practice
