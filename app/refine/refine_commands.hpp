// What `plan refine` does. Each returns the exit code.
#pragma once

#include "app/refine/refine_options.hpp"

namespace praxis::app {

int run_refine(const RefineCommandOptions& options);
int run_generate(const GenerateOptions& options);
int run_family_list(const FamilyListOptions& options);

}  // namespace praxis::app
