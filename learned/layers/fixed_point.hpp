// Solving u = A u + b for a contraction A that is known only by what it does to a vector.
//
// This is the way back through a fixed point: A is the transposed Jacobian of one iteration, b the gradient
// of its result (Bai et al., Deep equilibrium models, NeurIPS 2019). Plain iteration, or Anderson's method of
// type II (Walker and Ni, SIAM J. Numer. Anal. 2011) with its Gram matrix regularised relative to its trace.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace praxis::learned {

struct AdjointResult {
    int iterations = 0;
    double residual = 0;  ///< |A u + b - u| / |b| before the last step
};

template <class T>
class AdjointSolver {
  public:
    static constexpr int kMaxMixed = 8;

    /// Mixes up to `mixed` <= kMaxMixed steps; 0 or 1 is plain iteration. Stops after `iterations`, or when
    /// the residual is at most `tolerance`.
    AdjointSolver(int mixed, int iterations, double tolerance)
        : mixed_(std::clamp(mixed, 1, kMaxMixed)), iterations_(iterations), tolerance_(tolerance) {}

    /// apply(u, result) sets result = A u + b; u starts as b and ends as the solution.
    template <class Apply>
    AdjointResult solve(std::span<T> u, const Apply& apply) {
        const std::size_t size = u.size();
        images_.resize(static_cast<std::size_t>(mixed_) * size);
        changes_.resize(images_.size());
        const double of_b = dot(u, u);
        AdjointResult result;
        if (of_b == 0) return result;
        for (int k = 0; k < iterations_; ++k) {
            const int newest = k % mixed_, count = std::min(k + 1, mixed_);
            const std::span<T> image = slot(images_, newest, size), change = slot(changes_, newest, size);
            apply(std::span<const T>(u), image);
            for (std::size_t i = 0; i < size; ++i) change[i] = image[i] - u[i];
            for (int j = 0; j < count; ++j)
                gram_[at(newest)][at(j)] = gram_[at(j)][at(newest)] = dot(change, slot(changes_, j, size));
            result.iterations = k + 1;
            result.residual = std::sqrt(gram_[at(newest)][at(newest)] / of_b);
            mix(u, count, newest, size);
            if (result.residual <= tolerance_) break;
        }
        return result;
    }

  private:
    static std::span<T> slot(std::vector<T>& values, int index, std::size_t size) {
        return std::span<T>(values).subspan(static_cast<std::size_t>(index) * size, size);
    }

    static std::size_t at(int index) { return static_cast<std::size_t>(index); }

    // In double, as several sums side by side that the compiler may keep in vectors.
    static double dot(std::span<const T> a, std::span<const T> b) {
        constexpr std::size_t kSums = 8;
        std::array<double, kSums> sums{};
        std::size_t i = 0;
        for (; i + kSums <= a.size(); i += kSums)
            for (std::size_t k = 0; k < kSums; ++k)
                sums[k] += static_cast<double>(a[i + k]) * static_cast<double>(b[i + k]);
        double total = 0;
        for (const double sum : sums) total += sum;
        for (; i < a.size(); ++i) total += static_cast<double>(a[i]) * static_cast<double>(b[i]);
        return total;
    }

    // u = sum of weights * images, the weights summing to one and minimising the combined change.
    void mix(std::span<T> u, int count, int newest, std::size_t size) {
        std::array<double, kMaxMixed> weights{};
        if (count == 1)
            weights[at(newest)] = 1;
        else
            find_weights(weights, count);
        std::ranges::fill(u, T(0));
        for (int j = 0; j < count; ++j) {
            const std::span<T> image = slot(images_, j, size);
            const T weight = static_cast<T>(weights[at(j)]);
            for (std::size_t i = 0; i < size; ++i) u[i] += weight * image[i];
        }
    }

    void find_weights(std::array<double, kMaxMixed>& weights, int count) const {
        Matrix gram = gram_;
        double trace = 0;
        for (int a = 0; a < count; ++a) trace += gram[at(a)][at(a)];
        constexpr double kRegular = 1e-10;
        const std::size_t n = static_cast<std::size_t>(count);
        for (std::size_t a = 0; a < n; ++a) {
            gram[a][a] += kRegular * trace + 1e-300;
            weights[a] = 1;
        }
        // Gauss elimination without pivots: the matrix is positive definite.
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = a + 1; b < n; ++b) {
                const double factor = gram[b][a] / gram[a][a];
                for (std::size_t c = a; c < n; ++c) gram[b][c] -= factor * gram[a][c];
                weights[b] -= factor * weights[a];
            }
        double total = 0;
        for (std::size_t a = n; a-- > 0;) {
            for (std::size_t c = a + 1; c < n; ++c) weights[a] -= gram[a][c] * weights[c];
            weights[a] /= gram[a][a];
            total += weights[a];
        }
        for (std::size_t a = 0; a < n; ++a) weights[a] /= total;
    }

    using Matrix = std::array<std::array<double, kMaxMixed>, kMaxMixed>;

    int mixed_, iterations_;
    double tolerance_;
    std::vector<T> images_, changes_;  // A u + b, and how much it differs from u, of the last steps
    Matrix gram_{};                    // products of the changes
};

}  // namespace praxis::learned
