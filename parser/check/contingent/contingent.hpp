// From syntax trees to a checked contingent task.
#pragma once

#include <vector>

#include "parser/contingent.hpp"
#include "parser/reporter.hpp"
#include "parser/syntax/tree.hpp"

namespace praxis::check {

/// As `check`, for a partially observable task and world files. The lifted task comes back beside the
/// contingent one, which does not refer to it yet.
struct CheckedContingentTask {
    LiftedTask lifted;
    ContingentTask contingent;
};

CheckedContingentTask check_contingent(const syntax::Tree& domain, const syntax::Tree& problem,
                                       const std::vector<syntax::Tree>& worlds,
                                       const syntax::SymbolTable& symbols, Reporter& reporter);

}  // namespace praxis::check
