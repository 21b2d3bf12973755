// A finished run as JSON text, and back.
//
//     {"format": "praxis-practice-run", "version": 1, "fingerprint": "tasks=100 ...",
//      "environment": "ball-ring", "method": "ees", "seed": 456,
//      "processor_seconds": 0.4, "evaluation_seconds": 0.2,
//      "curve": [[cycle, transitions, solved], ...],
//      "skills": ["(pick ring table)", ...],
//      "choices": [{"cycle": 0, "transitions": 17, "chosen": "(place ring table)",
//                   "candidates": [[skill, score, competence, predicted, cost, tries, successes], ...]},
//                   ...]}
//
// `skill` is a place in "skills", so that long runs stay small. JSON has no infinite numbers: they are the
// strings "inf" and "-inf". Numbers read back exactly.
#pragma once

#include <string>

#include "parser/source.hpp"
#include "practice/experiment/results.hpp"

namespace praxis::practice {

/// A run with the settings it was made with.
struct StoredRun {
    RunResult run;
    std::string fingerprint;
    bool operator==(const StoredRun&) const = default;
};

/// Throws std::invalid_argument for texts that are not UTF-8, and for numbers that `read_run` would refuse.
std::string run_to_json(const StoredRun& stored);

/// Throws InputError, naming the file and the place in it, for anything that `run_to_json` would not write;
/// other members are skipped.
StoredRun read_run(const Source& source);

}  // namespace praxis::practice
