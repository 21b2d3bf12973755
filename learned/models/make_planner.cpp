#include <stdexcept>

#include "learned/layers/fixed_point.hpp"
#include "learned/models/gated_network.hpp"
#include "learned/models/lstm_network.hpp"
#include "learned/models/value_iteration_network.hpp"

namespace praxis::learned {
namespace {

void require(bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument("learned planner: " + what);
}

void check(const PlannerOptions& options) {
    const auto known = [&](std::initializer_list<const char*> names) {
        for (const char* name : names)
            if (options.model == name) return true;
        return false;
    };
    require(known({"vin", "gru", "lstm"}), "unknown model '" + options.model + "' (known: vin, gru, lstm)");
    require(options.model != "lstm" || options.differentiation == Differentiation::unrolled,
            "an lstm has no implicit form: its cell states need not settle");
    require(options.fields >= 1 && options.fields <= 255, "fields must be 1 to 255");
    require(options.iterations >= 1 && options.iterations <= 100'000, "iterations must be 1 to 100000");
    require(options.radius == 1 || options.radius == 2, "radius must be 1 or 2");
    require(options.input_radius == 1 || options.input_radius == 2, "input_radius must be 1 or 2");
    require(options.contraction >= 0 && options.contraction <= 1, "contraction must be 0 (none) to 1");
    require(options.tolerance > 0, "tolerance must be positive");
    require(options.backward_iterations >= 1 && options.backward_iterations <= 100'000,
            "backward_iterations must be 1 to 100000");
    require(options.anderson >= 0 && options.anderson <= AdjointSolver<float>::kMaxMixed,
            "anderson must be 0 to " + std::to_string(AdjointSolver<float>::kMaxMixed));
}

}  // namespace

std::size_t parameter_count(const PlannerOptions& options) {
    check(options);
    const auto taps = [](int radius) {
        return static_cast<std::size_t>((2 * radius + 1) * (2 * radius + 1));
    };
    const std::size_t fields = static_cast<std::size_t>(options.fields),
                      order = static_cast<std::size_t>(Group(options.group).order()),
                      lifted = fields * (kInputs * taps(options.input_radius) + 1), head = 4 * fields,
                      one = fields * order;  // of a matrix between one regular field and all
    if (options.model == "gru") return 4 * lifted + 3 * fields * one * taps(options.radius) + head;
    if (options.model == "lstm")
        return 2 * lifted + one * taps(options.radius) + 1 + 4 * (one + fields + fields * one) + head;
    return lifted + one * taps(options.radius) + head;
}

template <class T>
std::unique_ptr<Planner<T>> make_planner(const PlannerOptions& options, std::uint64_t seed) {
    check(options);
    if (options.model == "gru") return std::make_unique<GatedNetwork<T>>(options, seed);
    if (options.model == "lstm") return std::make_unique<LstmNetwork<T>>(options, seed);
    return std::make_unique<ValueIterationNetwork<T>>(options, seed);
}

template std::unique_ptr<Planner<float>> make_planner(const PlannerOptions&, std::uint64_t);
template std::unique_ptr<Planner<double>> make_planner(const PlannerOptions&, std::uint64_t);

}  // namespace praxis::learned
