#include "practice/policies/feature_selection.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace praxis::practice {

namespace {

constexpr std::size_t kFolds = 4;
constexpr std::size_t kFewest = 2 * kFolds;  // examples of an outcome
constexpr int kShuffles = 3;                 // of a column in a fold

/// Sum over the examples of -log p(outcome).
double loss(const Classifier& classifier, const std::vector<float>& rows, const Examples& examples) {
    std::vector<float> probabilities(examples.size());
    classifier.probabilities(rows, probabilities);
    double sum = 0;
    for (std::size_t i = 0; i < examples.size(); ++i) {
        const double p = std::clamp(double{probabilities[i]}, 1e-3, 1 - 1e-3);
        sum -= std::log(examples.success[i] != 0 ? p : 1 - p);
    }
    return sum;
}

/// By example, a fold; each outcome is spread evenly.
std::vector<std::size_t> folds(const Examples& examples, Random& random) {
    std::vector<std::size_t> result(examples.size());
    for (const bool outcome : {false, true}) {
        std::vector<std::size_t> rows;
        for (std::size_t i = 0; i < examples.size(); ++i)
            if ((examples.success[i] != 0) == outcome) rows.push_back(i);
        random.shuffle(rows);
        for (std::size_t k = 0; k < rows.size(); ++k) result[rows[k]] = k % kFolds;
    }
    return result;
}

struct Split {
    Examples train, test;
};

Split split(const Examples& examples, const std::vector<std::size_t>& fold, std::size_t held_out) {
    Split result;
    for (Examples* part : {&result.train, &result.test}) part->width = examples.width;
    for (std::size_t i = 0; i < examples.size(); ++i) {
        Examples& part = fold[i] == held_out ? result.test : result.train;
        const auto row = examples.rows.begin() + static_cast<std::ptrdiff_t>(i * examples.width);
        part.rows.insert(part.rows.end(), row, row + static_cast<std::ptrdiff_t>(examples.width));
        part.success.push_back(examples.success[i]);
    }
    return result;
}

std::vector<float> with_shuffled(const Examples& examples, std::size_t column, Random& random) {
    std::vector<std::size_t> order(examples.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    random.shuffle(order);
    std::vector<float> rows = examples.rows;
    for (std::size_t i = 0; i < order.size(); ++i)
        rows[i * examples.width + column] = examples.rows[order[i] * examples.width + column];
    return rows;
}

struct Importances {
    double loss = 0;              // held out, all folds
    std::vector<bool> important;  // by column of the candidates
};

Importances importances(const Examples& examples, std::size_t candidates,
                        const std::vector<std::size_t>& fold, const ClassifierOptions& options,
                        Random& random) {
    Importances result;
    std::vector<std::array<double, kFolds>> rise(candidates);
    const auto classifier = make_classifier(examples.width, options);
    for (std::size_t f = 0; f < kFolds; ++f) {
        const Split parts = split(examples, fold, f);
        classifier->fit(parts.train, random);
        const double before = loss(*classifier, parts.test.rows, parts.test);
        result.loss += before;
        for (std::size_t column = 0; column < candidates; ++column) {
            rise[column][f] = -before;
            for (int shuffle = 0; shuffle < kShuffles; ++shuffle)
                rise[column][f] +=
                    loss(*classifier, with_shuffled(parts.test, column, random), parts.test) / kShuffles;
        }
    }
    for (const auto& rises : rise) {
        double mean = 0;
        double squares = 0;
        for (const double value : rises) mean += value / kFolds;
        for (const double value : rises) squares += (value - mean) * (value - mean);
        result.important.push_back(mean > std::sqrt(squares / (kFolds * (kFolds - 1))));
    }
    return result;
}

}  // namespace

Examples with_columns(const Examples& examples, const std::vector<std::size_t>& columns) {
    Examples result;
    result.width = columns.size();
    result.success = examples.success;
    result.rows.reserve(examples.size() * columns.size());
    for (std::size_t i = 0; i < examples.size(); ++i)
        for (const std::size_t column : columns)
            result.rows.push_back(examples.rows[i * examples.width + column]);
    return result;
}

std::vector<std::size_t> select_features(const Examples& examples, std::size_t candidates,
                                         const ClassifierOptions& options, Random& random) {
    std::vector<std::size_t> kept(examples.width);
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = i;
    const auto successes =
        static_cast<std::size_t>(std::count_if(examples.success.begin(), examples.success.end(),
                                               [](unsigned char success) { return success != 0; }));
    if (std::min(successes, examples.size() - successes) < kFewest) return kept;

    const std::vector<std::size_t> fold = folds(examples, random);
    Importances best = importances(examples, candidates, fold, options, random);
    while (true) {
        std::vector<std::size_t> fewer;
        std::size_t left = 0;  // of the candidates
        for (std::size_t i = 0; i < kept.size(); ++i) {
            const bool candidate = kept[i] < candidates;
            if (candidate && !best.important[i]) continue;
            fewer.push_back(kept[i]);
            left += candidate ? 1 : 0;
        }
        if (fewer.size() == kept.size() || fewer.empty()) return kept;
        Importances reduced = importances(with_columns(examples, fewer), left, fold, options, random);
        if (reduced.loss > best.loss) return kept;
        kept = std::move(fewer);
        best = std::move(reduced);
    }
}

}  // namespace praxis::practice
