#include "practice/policies/q_function.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "practice/policies/adam.hpp"

namespace praxis::practice {

namespace {

constexpr float kFarthest = 100;  // standard deviations that an input may be away

void check(const QOptions& options, std::size_t skills) {
    const auto require = [](bool condition, const char* message) {
        if (!condition) throw std::invalid_argument(message);
    };
    require(skills >= 1, "a Q function needs at least one skill");
    require(options.discount >= 0 && options.discount < 1, "a Q function's discount must be in [0, 1)");
    require(options.replay >= 1, "a Q function's replay must hold at least one transition");
    require(options.iterations >= 1 && options.steps >= 1 && options.batch >= 1,
            "a Q function's iterations, steps and batch must be at least 1");
    require(options.learning_rate > 0 && options.learning_rate <= 1,
            "a Q function's learning rate must be positive and at most 1");
}

float finite(double value) {
    const auto result = static_cast<float>(value);
    if (!std::isfinite(result))
        throw std::invalid_argument("a Q function is given a number that is not finite: " +
                                    std::to_string(value));
    return result;
}

}  // namespace

QFunction::QFunction(std::size_t features, std::size_t skills, std::size_t parameters, QOptions options)
    : features_(features),
      skills_(skills),
      parameters_(parameters),
      options_(std::move(options)),
      standard_(features + parameters),
      network_(features + skills + parameters, options_.hidden, 1) {
    check(options_, skills);
}

std::vector<float> QFunction::finite_features(std::span<const double> features) const {
    if (features.size() != features_)
        throw std::invalid_argument("a Q function of " + std::to_string(features_) + " features is given " +
                                    std::to_string(features.size()));
    std::vector<float> result;
    for (const double value : features) result.push_back(finite(value));
    return result;
}

QFunction::FlatAction QFunction::flat(const Action& action) const {
    if (action.skill >= skills_)
        throw std::invalid_argument("a Q function of " + std::to_string(skills_) + " skills is given skill " +
                                    std::to_string(action.skill));
    if (action.parameters.size() > parameters_)
        throw std::invalid_argument("a Q function of at most " + std::to_string(parameters_) +
                                    " parameters is given " + std::to_string(action.parameters.size()));
    FlatAction result{action.skill, std::vector<float>(parameters_)};
    std::transform(action.parameters.begin(), action.parameters.end(), result.parameters.begin(), finite);
    return result;
}

void QFunction::add(const Transition& transition) {
    Stored stored{
        finite_features(transition.features), {}, flat(transition.action), {}, finite(transition.reward)};
    if (!transition.terminal) {
        stored.next_features = finite_features(transition.next_features);
        for (const Action& action : transition.next_actions) stored.next_actions.push_back(flat(action));
    }
    if (replay_.size() < options_.replay) {
        replay_.push_back(std::move(stored));
    } else {
        replay_[oldest_] = std::move(stored);
        oldest_ = (oldest_ + 1) % replay_.size();
    }
}

void QFunction::write_row(const std::vector<float>& features, const FlatAction& action, float* row) const {
    const auto standard = [&](std::size_t column, float value) {
        return std::clamp(standard_[column](double{value}), -kFarthest, kFarthest);
    };
    for (std::size_t i = 0; i < features_; ++i) row[i] = standard(i, features[i]);
    std::fill_n(row + features_, skills_, 0.0f);
    row[features_ + action.skill] = 1;
    for (std::size_t p = 0; p < parameters_; ++p)
        row[features_ + skills_ + p] = standard(features_ + p, action.parameters[p]);
}

void QFunction::standardise() {
    for (std::size_t column = 0; column < standard_.size(); ++column) {
        const auto at = [&](std::size_t row) -> double {
            return column < features_ ? replay_[row].features[column]
                                      : replay_[row].action.parameters[column - features_];
        };
        double magnitude = 0;
        for (std::size_t row = 0; row < replay_.size(); ++row)
            magnitude = std::max(magnitude, std::abs(at(row)));
        standard_[column] = standardisation(replay_.size(), magnitude, at);
    }
}

void QFunction::targets(const std::vector<std::size_t>& transitions, const Mlp& network,
                        std::vector<float>& result) const {
    const std::size_t width = network.width();
    std::vector<float> rows;
    std::vector<float> next;
    for (std::size_t i = 0; i < transitions.size(); ++i) {
        const Stored& stored = replay_[transitions[i]];
        result[i] = stored.reward;
        if (stored.next_actions.empty()) continue;
        rows.resize(stored.next_actions.size() * width);
        next.resize(stored.next_actions.size());
        for (std::size_t a = 0; a < next.size(); ++a)
            write_row(stored.next_features, stored.next_actions[a], rows.data() + a * width);
        network.evaluate(rows, next);
        result[i] += static_cast<float>(options_.discount) * *std::max_element(next.begin(), next.end());
    }
}

void QFunction::learn(Random& random) {
    if (replay_.empty()) return;
    if (!learned_) network_.initialise(random);
    learned_ = true;
    standardise();

    const std::size_t width = network_.width();
    const std::size_t batch = options_.batch;
    std::vector<std::size_t> drawn(batch * static_cast<std::size_t>(options_.steps));
    std::vector<float> target(drawn.size());
    std::vector<float> rows(batch * width);
    std::vector<float> error(batch);
    std::vector<float> gradient(network_.weights().size());
    Mlp::Workspace workspace(network_, batch);
    Adam adam(gradient.size());
    for (int iteration = 0; iteration < options_.iterations; ++iteration) {
        for (std::size_t& transition : drawn) transition = random.below(replay_.size());
        targets(drawn, network_, target);
        for (std::size_t first = 0; first < drawn.size(); first += batch) {
            for (std::size_t b = 0; b < batch; ++b) {
                const Stored& stored = replay_[drawn[first + b]];
                write_row(stored.features, stored.action, rows.data() + b * width);
            }
            const std::span<const float> outputs = network_.forward(rows, workspace);
            for (std::size_t b = 0; b < batch; ++b)
                error[b] = (outputs[b] - target[first + b]) / static_cast<float>(batch);
            network_.backward(rows, error, workspace, gradient);
            adam.step(network_.weights(), gradient, static_cast<float>(options_.learning_rate), 0);
        }
    }
}

double QFunction::value(std::span<const double> features, const Action& action) const {
    double result = 0;
    values(features, {&action, 1}, {&result, 1});
    return result;
}

void QFunction::values(std::span<const double> features, std::span<const Action> actions,
                       std::span<double> result) const {
    const std::vector<float> state = finite_features(features);
    std::vector<float> rows(actions.size() * network_.width());
    for (std::size_t a = 0; a < actions.size(); ++a)
        write_row(state, flat(actions[a]), rows.data() + a * network_.width());
    std::vector<float> outputs(actions.size());
    network_.evaluate(rows, outputs);
    std::copy(outputs.begin(), outputs.end(), result.begin());
}

}  // namespace praxis::practice
