#include "tamp/problems/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tamp/problems/families.hpp"

namespace praxis::tamp {

std::optional<Place> scatter_one(Random& random, const ScatterBox& box, const std::vector<Place>& taken,
                                 double distance) {
    constexpr int kTries = 4000;
    for (int i = 0; i < kTries; ++i) {
        const Place place = {uniform(random, box.lower[0], box.upper[0]),
                             uniform(random, box.lower[1], box.upper[1])};
        if (std::ranges::all_of(taken, [&](const Place& other) {
                return std::hypot(place[0] - other[0], place[1] - other[1]) >= distance;
            })) {
            return place;
        }
    }
    return std::nullopt;
}

std::vector<Place> scatter(Random& random, const ScatterBox& box, int count, double distance, double least,
                           std::vector<Place> taken) {
    constexpr double kShrink = 0.95;
    std::vector<Place> places;
    for (int i = 0; i < count; ++i) {
        std::optional<Place> place = scatter_one(random, box, taken, distance);
        while (!place && distance > least) {
            distance = std::max(least, kShrink * distance);
            place = scatter_one(random, box, taken, distance);
        }
        if (!place) throw std::logic_error("the things of a generated problem do not fit");
        taken.push_back(*place);
        places.push_back(*place);
    }
    return places;
}

}  // namespace praxis::tamp
