// Observable atoms: those of predicates of which an `:obs-variable` has atoms. They are no part of the state;
// sensing models say what they are in it.
#pragma once

#include <vector>

#include "parser/contingent.hpp"

namespace praxis::belief {

struct Observables {
    std::vector<bool> all;  ///< by predicate
    std::vector<bool>
        asked;  ///< by predicate: observable, and in the condition of something else than a model
};

/// Throws UnsupportedError where an effect, a model's condition or the initial description speaks of
/// observable atoms.
Observables find_observables(const ContingentTask& task);

}  // namespace praxis::belief
