// `plan refine` is a program of its own, `plan-refine`, so that `plan` stays small and starts at once: it
// alone needs the libraries of geometry and motion.
#pragma once

namespace praxis::app {

/// Becomes `plan-refine`, which lies beside this program, with the arguments behind "refine". Returns (an
/// exit code) only if that fails.
int launch_refine(int argc, char** argv);

}  // namespace praxis::app
