// What a run of the practice loop leaves: learning curve, and for each cycle what was chosen and why.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace praxis::practice {

/// One evaluation on test tasks, after a cycle (cycle 0: before any practice).
struct CurvePoint {
    int cycle = 0;
    std::int64_t transitions = 0;  ///< skills executed in practice so far
    double solved = 0;             ///< the fraction of test tasks solved, in [0, 1]
    bool operator==(const CurvePoint&) const = default;
};

/// A candidate as it stood when a skill to practise was chosen.
struct CandidateScore {
    std::string skill;      ///< "(place ring table)"
    double score = 0;       ///< the higher, the sooner; minus infinity: not to be practised
    double competence = 0;  ///< now
    double predicted = 0;   ///< after more practice
    double cost =
        0;  ///< expected plan cost over the tasks with the predicted competence (only methods that plan)
    int tries = 0, successes = 0;
    bool operator==(const CandidateScore&) const = default;
};

/// A moment of choice.
struct PracticeChoice {
    int cycle = 0;  ///< 1: the first
    std::int64_t transitions = 0;
    std::string chosen;  ///< empty: no candidate could be reached, a random skill was executed
    std::vector<CandidateScore> candidates;  ///< best first
    bool operator==(const PracticeChoice&) const = default;
};

struct RunResult {
    std::string environment, method;
    std::uint64_t seed = 0;
    std::vector<CurvePoint> curve;
    std::vector<PracticeChoice> choices;  ///< the first of each cycle
    double processor_seconds = 0;         ///< of the practice and learning, without evaluations
    double evaluation_seconds = 0;
    bool operator==(const RunResult&) const = default;
};

}  // namespace praxis::practice
