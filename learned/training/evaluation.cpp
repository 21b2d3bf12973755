#include "learned/training/evaluation.hpp"

#include <algorithm>

#include "learned/training/parallel.hpp"

namespace praxis::learned {

Score score(const MapProblem& problem, std::span<const std::uint8_t> policy) {
    constexpr int kUnknown = -1, kLost = -2, kOpen = -3;
    const std::size_t cells = problem.free.size();
    std::vector<int> length(cells, kUnknown), path;
    length[static_cast<std::size_t>(problem.goal)] = 0;
    Score result;
    int counted = 0;
    for (std::size_t start = 0; start < cells; ++start) {
        if (!problem.optimal[start]) continue;
        int cell = static_cast<int>(start);
        path.clear();
        while (cell >= 0 && length[static_cast<std::size_t>(cell)] == kUnknown) {
            length[static_cast<std::size_t>(cell)] = kOpen;
            path.push_back(cell);
            cell = problem.neighbour(cell, policy[static_cast<std::size_t>(cell)]);
        }
        int reached = cell < 0 ? kLost : length[static_cast<std::size_t>(cell)];
        if (reached == kOpen) reached = kLost;
        for (; !path.empty(); path.pop_back()) {
            if (reached >= 0) ++reached;
            length[static_cast<std::size_t>(path.back())] = reached;
        }
        ++counted;
        if (length[start] < 0) continue;
        result.success += 1;
        result.optimal += length[start] == problem.distance[start];
        result.spl += static_cast<double>(problem.distance[start]) / length[start];
    }
    if (counted == 0) return {1, 1, 1};
    return {result.success / counted, result.optimal / counted, result.spl / counted};
}

template <class T>
std::vector<std::uint8_t> best_moves(const Planes<T>& policy) {
    std::vector<std::uint8_t> moves;
    moves.reserve(static_cast<std::size_t>(policy.height() * policy.width()));
    for (int row = 0; row < policy.height(); ++row)
        for (int column = 0; column < policy.width(); ++column) {
            int best = 0;
            for (int m = 1; m < policy.channels(); ++m)
                if (policy.at(m, row, column) > policy.at(best, row, column)) best = m;
            moves.push_back(static_cast<std::uint8_t>(best));
        }
    return moves;
}

template <class T>
Score evaluate(const Planner<T>& planner, const MapSet& maps, int threads) {
    std::vector<Score> scores(maps.problems.size());
    run_parallel(threads, [&](int thread) {
        const auto trace = planner.trace(maps.height, maps.width);
        for (std::size_t k = static_cast<std::size_t>(thread); k < scores.size();
             k += static_cast<std::size_t>(threads)) {
            draw(maps.problems[k], *trace);
            planner.plan(*trace);
            scores[k] = score(maps.problems[k], best_moves(trace->policy));
        }
    });
    Score mean;
    for (const Score& one : scores) {
        mean.success += one.success / static_cast<double>(scores.size());
        mean.optimal += one.optimal / static_cast<double>(scores.size());
        mean.spl += one.spl / static_cast<double>(scores.size());
    }
    return mean;
}

template std::vector<std::uint8_t> best_moves(const Planes<float>&);
template std::vector<std::uint8_t> best_moves(const Planes<double>&);
template Score evaluate(const Planner<float>&, const MapSet&, int);
template Score evaluate(const Planner<double>&, const MapSet&, int);

}  // namespace praxis::learned
