// The state of a training run in a file, so that it can go on where it stopped.
//
// A checkpoint is also a file of weights: read_planner reads the planner as it was then.
#pragma once

#include <string>

#include "learned/training/trainer.hpp"

namespace praxis::learned {

/// Weights, the optimiser's state, and how far training has got. InputError if it cannot be written.
void write_checkpoint(const std::string& file, Trainer& trainer);
/// Brings a new trainer to the state of the checkpoint. InputError if the file is bad (see read_planner) or
/// is of another planner or other training options: going on would not be the same run.
void read_checkpoint(const std::string& file, Trainer& trainer);

}  // namespace praxis::learned
