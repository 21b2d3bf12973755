#include "learned/layers/loss.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace praxis::learned {
namespace {

unsigned targets(Loss loss, const MapProblem& problem, std::size_t cell) {
    return loss == Loss::all_optimal ? problem.optimal[cell] : 1u << problem.label[cell];
}

}  // namespace

template <class T>
T policy_loss(Loss loss, const MapProblem& problem, const Planes<T>& policy, T weight, Planes<T>& of_policy) {
    constexpr int kCount = 4;
    of_policy.clear();
    int counted = 0;
    for (std::size_t cell = 0; cell < problem.free.size(); ++cell)
        counted += targets(loss, problem, cell) != 0;
    if (counted == 0) return 0;
    const T share = T(1) / static_cast<T>(counted);
    T total = 0;
    for (int row = 0; row < problem.height; ++row)
        for (int column = 0; column < problem.width; ++column) {
            const unsigned wanted =
                targets(loss, problem, static_cast<std::size_t>(row * problem.width + column));
            if (wanted == 0) continue;
            std::array<T, kCount> exponential{};
            T largest = policy.at(0, row, column);
            for (int m = 1; m < kCount; ++m) largest = std::max(largest, policy.at(m, row, column));
            T sum = 0, of_wanted = 0;
            for (int m = 0; m < kCount; ++m) {
                const T e = std::exp(policy.at(m, row, column) - largest);
                exponential[static_cast<std::size_t>(m)] = e;
                sum += e;
                if (wanted >> m & 1) of_wanted += e;
            }
            constexpr T kSmallest = T(1e-30);
            of_wanted = std::max(of_wanted, kSmallest);
            total -= std::log(of_wanted / sum);
            for (int m = 0; m < kCount; ++m) {
                const T e = exponential[static_cast<std::size_t>(m)];
                of_policy.at(m, row, column) =
                    weight * share * (e / sum - (wanted >> m & 1 ? e / of_wanted : T(0)));
            }
        }
    return total * share;
}

template float policy_loss(Loss, const MapProblem&, const Planes<float>&, float, Planes<float>&);
template double policy_loss(Loss, const MapProblem&, const Planes<double>&, double, Planes<double>&);

}  // namespace praxis::learned
