// How well, and at what cost, classifiers choose a skill's parameters: for each problem, method and number of
// examples the success of the likeliest of 100 candidates, and the processor time of a fit. Optional
// argument: how many sets of examples are drawn (10); each is tried in 200 new situations.
//
// "published" is the perceptron of Kumar et al. as its code trains it (up to 100,000 steps of Adam on all
// examples with rate 0.001, until 5,000 bring no smaller loss), measured only with a second argument, as it
// takes minutes.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>

#include "practice/policies/adam.hpp"
#include "practice/policies/input_map.hpp"
#include "practice/policies/mlp.hpp"
#include "tests/practice/policies/skill_problems.hpp"

namespace {

using namespace praxis;
using namespace praxis::practice;

class Published final : public Classifier {
  public:
    void fit(const Examples& examples, Random& random) override {
        inputs_ = InputMap(examples, false);
        network_ = Mlp(inputs_.size(), {32, 32}, 1);
        network_.initialise(random);
        std::vector<float> inputs(examples.size() * inputs_.size());
        inputs_.apply(examples.rows, inputs);
        Mlp::Workspace workspace(network_, examples.size());
        Adam adam(network_.weights().size());
        std::vector<float> gradient(network_.weights().size());
        std::vector<float> error(examples.size());
        double best = std::numeric_limits<double>::infinity();
        for (int step = 0, since = 0; step < 100'000 && since < 5'000; ++step, ++since) {
            const auto outputs = network_.forward(inputs, workspace);
            double loss = 0;
            for (std::size_t i = 0; i < error.size(); ++i) {
                const double p = 1 / (1 + std::exp(-double{outputs[i]}));
                const double outcome = examples.success[i];
                loss -= std::log(std::max(1e-12, outcome > 0 ? p : 1 - p));
                error[i] = static_cast<float>((p - outcome) / static_cast<double>(error.size()));
            }
            if (loss < best) {
                best = loss;
                since = 0;
            }
            network_.backward(inputs, error, workspace, gradient);
            adam.step(network_.weights(), gradient, 1e-3f, 0);
        }
    }
    void probabilities(std::span<const float> rows, std::span<float> result) const override {
        std::vector<float> inputs(result.size() * inputs_.size());
        inputs_.apply(rows, inputs);
        network_.evaluate(inputs, result);
    }
    void uncertainties(std::span<const float> rows, std::span<float> result) const override {
        probabilities(rows, result);
    }

  private:
    InputMap inputs_;
    Mlp network_{1, {}, 1};
};

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

using Maker = std::unique_ptr<Classifier> (*)(std::size_t width);

template <bool kDifferences>
std::unique_ptr<Classifier> make(std::size_t width, const char* kind) {
    ClassifierOptions options;
    options.kind = kind;
    options.differences = kDifferences;
    return make_classifier(width, options);
}

void measure(const test::SkillProblem& problem, const char* name, Maker maker, std::size_t count, int sets) {
    double success = 0;
    double seconds = 0;
    for (int set = 0; set < sets; ++set) {
        Random random(1000 + static_cast<std::uint64_t>(set));
        const Examples examples = test::examples(problem, count, random);
        const auto classifier = maker(problem.width);
        const double start = processor_seconds();
        classifier->fit(examples, random);
        seconds += processor_seconds() - start;
        success += test::success_of_best(problem, *classifier, 200, random);
    }
    std::printf("%-20s %-22s %5zu %7.1f %% %10.2f ms\n", problem.name.c_str(), name, count,
                100 * success / sets, 1e3 * seconds / sets);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const int sets = argc > 1 ? std::max(1, std::atoi(argv[1])) : 10;
    struct Method {
        const char* name;
        Maker maker;
    };
    std::vector<Method> methods = {
        {"mlp", [](std::size_t width) { return make<true>(width, "mlp"); }},
        {"mlp, no differences", [](std::size_t width) { return make<false>(width, "mlp"); }},
        {"ensemble", [](std::size_t width) { return make<true>(width, "ensemble"); }},
        {"knn", [](std::size_t width) { return make<true>(width, "knn"); }},
        {"knn, no differences", [](std::size_t width) { return make<false>(width, "knn"); }}};
    if (argc > 2)
        methods.push_back({"published", [](std::size_t) -> std::unique_ptr<Classifier> {
                               return std::make_unique<Published>();
                           }});
    const std::vector<std::pair<test::SkillProblem, std::vector<std::size_t>>> problems = {
        {test::relative_placing(), {60, 120, 250}},
        {test::raw_placing(), {120, 250, 500}},
        {test::dimming(), {50, 100, 200}}};
    std::printf("%-20s %-22s %5s %9s %13s\n", "problem", "method", "rows", "success", "fit");
    for (const auto& [problem, counts] : problems)
        for (const auto& [name, maker] : methods)
            for (const std::size_t count : counts) measure(problem, name, maker, count, sets);
}
