// Places spread at random that keep a distance from one another.
#pragma once

#include <optional>
#include <vector>

#include "search/engines/random.hpp"
#include "tamp/problems/problem_text.hpp"

namespace praxis::tamp {

struct ScatterBox {
    Place lower = {};
    Place upper = {};
};

/// A place in the box at least `distance` metres from all of `taken`; nothing after a few thousand tries.
std::optional<Place> scatter_one(Random& random, const ScatterBox& box, const std::vector<Place>& taken,
                                 double distance);

/// `count` places in the box, all at least `distance` metres from one another and from `taken`, or less
/// where there is no room for that: the distance shrinks, but not below `least`. Throws std::logic_error if
/// they do not fit even so.
std::vector<Place> scatter(Random& random, const ScatterBox& box, int count, double distance, double least,
                           std::vector<Place> taken = {});

}  // namespace praxis::tamp
