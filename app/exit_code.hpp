// How the command ends, in the numbers that users of Fast Downward know.
#pragma once

namespace praxis::app {

enum ExitCode : int {
    kSolved = 0,            ///< a plan was found (or the plan is valid, the task ground, the list printed)
    kInvalidPlan = 1,       ///< `plan validate`: the plan is not valid
    kUnsolvableEarly = 10,  ///< proved unsolvable before the search
    kUnsolvable = 11,       ///< proved unsolvable by the search
    kFailed = 12,           ///< searched in vain, without a proof
    kOutOfMemory = 22,
    kOutOfTime = 23,
    kInternalError = 30,  ///< a fault of Praxis
    kInputError = 31,     ///< the command line, a file or the plan is wrong
    kUnsupported = 34,    ///< the task uses what Praxis does not plan for
    kOutputError = 35,    ///< the result could not be written
    kSignalBase = 128,    ///< ended by signal N without a plan: 128 + N
};

}  // namespace praxis::app
