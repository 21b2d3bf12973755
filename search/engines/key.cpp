#include "search/engines/key.hpp"

namespace praxis {

namespace {

std::int64_t add_product(std::int64_t sum, std::int64_t a, std::int64_t b) {
    std::int64_t product = 0, result = 0;
    if (__builtin_mul_overflow(a, b, &product) || __builtin_add_overflow(sum, product, &result) ||
        result == kInfiniteKey) {
        return kInfiniteKey - 1;
    }
    return result;
}

}  // namespace

Key Key::heuristic(std::size_t number) {
    Key key;
    key.terms_.push_back({number, 1});
    return key;
}

Key Key::cost_so_far() {
    Key key;
    key.g_weight_ = 1;
    return key;
}

Key Key::constant(std::int64_t value) {
    Key key;
    key.constant_ = value;
    return key;
}

Key Key::sum(const std::vector<Key>& parts) {
    Key key;
    for (const Key& part : parts) {
        key.constant_ = add_product(key.constant_, part.constant_, 1);
        key.g_weight_ = add_product(key.g_weight_, part.g_weight_, 1);
        key.terms_.insert(key.terms_.end(), part.terms_.begin(), part.terms_.end());
        key.maxima_.insert(key.maxima_.end(), part.maxima_.begin(), part.maxima_.end());
    }
    return key;
}

Key Key::maximum(std::vector<Key> parts) {
    Key key;
    key.maxima_.push_back({std::move(parts), 1});
    return key;
}

Key Key::weighted(Key part, std::int64_t weight) {
    if (weight == 0) return {};
    part.constant_ = add_product(0, part.constant_, weight);
    part.g_weight_ = add_product(0, part.g_weight_, weight);
    for (Term& term : part.terms_) term.weight = add_product(0, term.weight, weight);
    for (Maximum& maximum : part.maxima_) maximum.weight = add_product(0, maximum.weight, weight);
    return part;
}

std::int64_t Key::value(const Evaluated& state) const {
    std::int64_t sum = g_weight_ == 0 ? constant_ : add_product(constant_, g_weight_, state.g);
    for (const Term& term : terms_) {
        const Estimate estimate = state.estimates[term.heuristic];
        if (estimate == kDeadEnd) return kInfiniteKey;
        sum = add_product(sum, term.weight, estimate);
    }
    for (const Maximum& maximum : maxima_) {
        std::int64_t largest = 0;
        for (const Key& part : maximum.parts) {
            const std::int64_t value = part.value(state);
            if (value == kInfiniteKey) return kInfiniteKey;
            largest = std::max(largest, value);
        }
        sum = add_product(sum, maximum.weight, largest);
    }
    return sum;
}

bool Key::uses_g() const {
    return g_weight_ != 0 || std::any_of(maxima_.begin(), maxima_.end(), [](const Maximum& maximum) {
               return std::any_of(maximum.parts.begin(), maximum.parts.end(),
                                  [](const Key& part) { return part.uses_g(); });
           });
}

void Key::collect_heuristics(std::vector<std::size_t>& numbers) const {
    for (const Term& term : terms_) numbers.push_back(term.heuristic);
    for (const Maximum& maximum : maxima_) {
        for (const Key& part : maximum.parts) part.collect_heuristics(numbers);
    }
}

bool Key::admissible(const std::vector<bool>& heuristic_admissible) const {
    if (g_weight_ != 0 || constant_ > 0) return false;
    std::int64_t weights = 0;
    for (const Term& term : terms_) {
        weights = add_product(weights, term.weight, 1);
        if (!heuristic_admissible[term.heuristic]) return false;
    }
    for (const Maximum& maximum : maxima_) {
        weights = add_product(weights, maximum.weight, 1);
        for (const Key& part : maximum.parts) {
            if (!part.admissible(heuristic_admissible)) return false;
        }
    }
    return weights <= 1;
}

}  // namespace praxis
