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
        points_.resize(static_cast<std::size_t>(mixed_) * size);
        images_.resize(points_.size());
        double of_b = 0;
        for (const T value : u) of_b += static_cast<double>(value) * static_cast<double>(value);
        AdjointResult result;
        if (of_b == 0) return result;
        for (int k = 0; k < iterations_; ++k) {
            const std::span<T> point = slot(points_, k % mixed_, size),
                               image = slot(images_, k % mixed_, size);
            std::ranges::copy(u, point.begin());
            apply(std::span<const T>(point), image);
            result.iterations = k + 1;
            double squares = 0;
            for (std::size_t i = 0; i < size; ++i) {
                const double change = static_cast<double>(image[i]) - static_cast<double>(point[i]);
                squares += change * change;
            }
            result.residual = std::sqrt(squares / of_b);
            mix(u, std::min(k + 1, mixed_), k % mixed_, size);
            if (result.residual <= tolerance_) break;
        }
        return result;
    }

  private:
    static std::span<T> slot(std::vector<T>& values, int index, std::size_t size) {
        return std::span<T>(values).subspan(static_cast<std::size_t>(index) * size, size);
    }

    // u = sum of weights * images, the weights summing to one and minimising the combined residual.
    void mix(std::span<T> u, int count, int newest, std::size_t size) {
        std::array<double, kMaxMixed> weights{};
        if (count == 1)
            weights[static_cast<std::size_t>(newest)] = 1;
        else
            find_weights(weights, count, size);
        std::ranges::fill(u, T(0));
        for (int j = 0; j < count; ++j) {
            const std::span<T> image = slot(images_, j, size);
            const T weight = static_cast<T>(weights[static_cast<std::size_t>(j)]);
            for (std::size_t i = 0; i < size; ++i) u[i] += weight * image[i];
        }
    }

    void find_weights(std::array<double, kMaxMixed>& weights, int count, std::size_t size) {
        std::array<std::array<double, kMaxMixed>, kMaxMixed> gram{};
        double trace = 0;
        for (std::size_t a = 0; a < static_cast<std::size_t>(count); ++a)
            for (std::size_t b = 0; b <= a; ++b) {
                const T *pa = &points_[a * size], *ia = &images_[a * size], *pb = &points_[b * size],
                        *ib = &images_[b * size];
                double sum = 0;
                for (std::size_t i = 0; i < size; ++i)
                    sum += static_cast<double>(ia[i] - pa[i]) * static_cast<double>(ib[i] - pb[i]);
                gram[a][b] = gram[b][a] = sum;
                if (a == b) trace += sum;
            }
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

    int mixed_, iterations_;
    double tolerance_;
    std::vector<T> points_, images_;
};

}  // namespace praxis::learned
