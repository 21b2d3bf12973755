#include "tamp/scenes/distance_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace praxis::tamp {

namespace {

constexpr int kLongestSide = 1024;
constexpr float kInfinite = DistanceGrid::kInfinite;
constexpr std::size_t kLanes = 16;  ///< neighbouring columns that are read and written together

/// One line of the transform: the lower envelope of parabolas.
class Line {
  public:
    explicit Line(std::size_t length)
        : values(length), results(length), spread_(length), roots_(length), borders_(length + 1) {}

    std::vector<float> values;
    std::vector<float> results;

    /// results[q] = the least of values[v] + max(|q - v| - 1, 0)^2 over all v.
    void transform() {
        const std::size_t length = values.size();
        for (std::size_t q = 0; q < length; ++q) {
            spread_[q] = std::min({values[q > 0 ? q - 1 : q], values[q], values[q + 1 < length ? q + 1 : q]});
        }
        std::size_t count = 0;
        for (std::size_t q = 0; q < length; ++q) {
            if (spread_[q] == kInfinite) continue;
            const auto place = static_cast<float>(q);
            const float height = spread_[q] + place * place;
            float border = -kInfinite;
            while (count > 0) {
                const auto other = static_cast<float>(roots_[count - 1]);
                border = (height - spread_[roots_[count - 1]] - other * other) / (2 * (place - other));
                if (border > borders_[count - 1]) break;
                border = -kInfinite;
                --count;
            }
            roots_[count] = q;
            borders_[count] = border;
            ++count;
        }
        if (count == 0) {
            std::ranges::fill(results, kInfinite);
            return;
        }
        borders_[count] = kInfinite;
        std::size_t at = 0;
        for (std::size_t q = 0; q < length; ++q) {
            while (borders_[at + 1] < static_cast<float>(q)) ++at;
            const float away = static_cast<float>(q) - static_cast<float>(roots_[at]);
            results[q] = away * away + spread_[roots_[at]];
        }
    }

  private:
    std::vector<float> spread_;
    std::vector<std::size_t> roots_;
    std::vector<float> borders_;
};

void check_size(const VoxelGrid& grid, std::size_t cells) {
    for (const int side : grid.cells) {
        if (side < 1 || side > kLongestSide) {
            throw std::invalid_argument("a distance grid needs sides of 1 to 1024 cells, not " +
                                        std::to_string(side));
        }
    }
    if (!(grid.edge > 0) || !std::isfinite(grid.edge)) {
        throw std::invalid_argument("the cells of a distance grid need an edge above 0");
    }
    if (cells != grid.size()) {
        throw std::invalid_argument("the grid has " + std::to_string(grid.size()) + " cells, the set " +
                                    std::to_string(cells));
    }
}

}  // namespace

DistanceGrid::DistanceGrid(const VoxelSet& voxels, double reach)
    : grid_(voxels.grid), reach_(static_cast<float>(reach)) {
    check_size(grid_, voxels.filled.size());
    if (!(reach > 0)) throw std::invalid_argument("the reach of a distance grid must be above 0");
    squared_reach_ = static_cast<float>(std::min(reach * reach / (grid_.edge * grid_.edge), 1e9));
    by_x_.resize(grid_.size());
    by_xy_.resize(grid_.size());
    distances_.resize(grid_.size());
    const CellBox all = {{0, 0, 0}, grid_.cells};
    along_x(voxels.filled, all);
    along_y(all, nullptr);
    const std::vector<std::uint8_t> columns(grid_.index(0, 0, 1), 1);
    along_z(columns);
}

void DistanceGrid::update(std::span<const std::uint8_t> filled, const CellBox& changed) {
    check_size(grid_, filled.size());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (changed.lower[axis] < 0 || changed.upper[axis] > grid_.cells[axis] ||
            changed.lower[axis] > changed.upper[axis]) {
            throw std::invalid_argument("the changed box is not within the distance grid");
        }
    }
    std::vector<std::uint8_t> columns(grid_.index(0, 0, 1), 0);
    along_x(filled, changed);
    along_y(changed, &columns);
    along_z(columns);
}

void DistanceGrid::along_x(std::span<const std::uint8_t> filled, const CellBox& lines) {
    const auto length = static_cast<std::size_t>(grid_.cells[0]);
    constexpr float kFar = 2 * kLongestSide;
    for (int k = lines.lower[2]; k < lines.upper[2]; ++k) {
        for (int j = lines.lower[1]; j < lines.upper[1]; ++j) {
            const std::uint8_t* in = &filled[grid_.index(0, j, k)];
            float* out = &by_x_[grid_.index(0, j, k)];
            float away = kFar;
            for (std::size_t i = 0; i < length; ++i) {
                away = in[i] != 0 ? 0 : away + 1;
                out[i] = away;
            }
            away = kFar;
            for (std::size_t i = length; i-- > 0;) {
                away = in[i] != 0 ? 0 : away + 1;
                const float nearer = std::max(std::min(away, out[i]) - 1, 0.0F);
                out[i] = nearer < kFar && nearer * nearer <= squared_reach_ ? nearer * nearer : kInfinite;
            }
        }
    }
}

void DistanceGrid::along_y(const CellBox& lines, std::vector<std::uint8_t>* changed_columns) {
    const auto width = static_cast<std::size_t>(grid_.cells[0]);
    const auto length = static_cast<std::size_t>(grid_.cells[1]);
    Line line(length);
    for (int k = lines.lower[2]; k < lines.upper[2]; ++k) {
        const float* in = &by_x_[grid_.index(0, 0, k)];
        float* out = &by_xy_[grid_.index(0, 0, k)];
        for (std::size_t i = 0; i < width; ++i) {
            for (std::size_t j = 0; j < length; ++j) line.values[j] = in[j * width + i];
            line.transform();
            for (std::size_t j = 0; j < length; ++j) {
                const float result = line.results[j] <= squared_reach_ ? line.results[j] : kInfinite;
                float& old = out[j * width + i];
                if (changed_columns != nullptr && old != result) (*changed_columns)[j * width + i] = 1;
                old = result;
            }
        }
    }
}

void DistanceGrid::along_z(std::span<const std::uint8_t> columns) {
    const std::size_t plane = columns.size();
    const auto length = static_cast<std::size_t>(grid_.cells[2]);
    const auto edge = static_cast<float>(grid_.edge * (1 - 1e-6));
    Line line(length);
    std::vector<float> block(length * kLanes);
    for (std::size_t first = 0; first < plane; first += kLanes) {
        const std::size_t lanes = std::min(kLanes, plane - first);
        const auto wanted = columns.subspan(first, lanes);
        if (std::ranges::all_of(wanted, [](std::uint8_t flag) { return flag == 0; })) continue;
        for (std::size_t k = 0; k < length; ++k) {
            std::copy_n(&by_xy_[k * plane + first], lanes, &block[k * kLanes]);
        }
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            for (std::size_t k = 0; k < length; ++k) line.values[k] = block[k * kLanes + lane];
            line.transform();
            for (std::size_t k = 0; k < length; ++k) block[k * kLanes + lane] = line.results[k];
        }
        for (float& value : block) value = std::min(edge * std::sqrt(value), reach_);
        for (std::size_t k = 0; k < length; ++k) {
            std::copy_n(&block[k * kLanes], lanes, &distances_[k * plane + first]);
        }
    }
}

}  // namespace praxis::tamp
