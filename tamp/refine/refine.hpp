// Task and motion planning: a PDDL task whose actions need values (poses, grasps, trajectories) that streams
// make.
//
//     StreamTask task = load_streams("domain.pddl", "problem.pddl", "streams.pddl");
//     RefinementProblem problem{.task = &task, .library = &library, .values = {{"p0",
//     Value::of(Pose(...))}}}; Refinement refinement = refine(problem, budget); if (refinement.status ==
//     RefineStatus::solved) ...
//
// How it works. Streams are first believed: each makes *placeholders* ("#p1") for what it will make later, so
// that there is a symbolic task, which is ground once. A plan of it is a *skeleton*: ground actions with
// placeholders. Then the streams that the skeleton needs are called, the cheap ones first, and backjumped
// over by what they blame. A failure that no other sample can mend teaches the symbolic task: "never a where
// p and q hold" (a *nogood*; see search/task/restrict.hpp), and the next search, on the same ground task,
// goes round it. Failures that more samples might mend do so for a while only.
//
// If nothing is left and all streams are finite, the planner starts over with the samples themselves as
// objects. There every nogood is a fact about the problem, so that a search without a plan proves that there
// is none at this discretisation. It never claims so where time, attempts or a rejection that is not definite
// have cut something off.
//
// Sources: optimistic streams: Garrett, Lozano-Perez and Kaelbling, ICAPS 2020 (PDDLStream); failures as
// preconditions: Chitnis et al. 2021 (predicators), Vu et al. 2024 (COAST); backjumping: Prosser 1993.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parser/streams.hpp"
#include "search/budget.hpp"
#include "search/plan.hpp"
#include "tamp/streams/stream.hpp"

namespace praxis::tamp {

struct RefineOptions {
    std::uint64_t seed = 0;
    /// The search for skeletons, as for `praxis::configuration`.
    std::string search =
        "lazy(alt([single(ff()),single(ff(),pref_only=true),type_based([ff(),g()])],boost=1000),"
        "preferred=[ff()],cost_type=one)";
    /// Learn from what rejections blame. Off (to compare): everything that a failed call was given is to
    /// blame, so that a failure rules out little more than itself.
    bool nogoods = true;
    /// Jump back to what is to blame. Off: to the last choice (chronological backtracking).
    bool backjumping = true;
    /// Start over with samples as objects where that can prove infeasibility (or find what shared
    /// placeholders hide).
    bool prove_infeasible = true;
    /// Streams that build on placeholders of other streams, at most so deep.
    std::uint32_t max_level = 6;
    /// Instances of streams in one ground task, at most.
    std::uint32_t max_instances = 200'000;
    /// Calls that a skeleton gets when it is first tried; doubled with every further try.
    std::uint32_t first_calls = 64;
};

struct RefinementProblem {
    const StreamTask* task = nullptr;
    const StreamLibrary* library = nullptr;
    /// Values of the problem's objects, by name; others have none.
    std::map<std::string, Value, std::less<>> values = {};
    RefineOptions options = {};
};

/// One action of a refined plan.
struct RefinedStep {
    std::string name;              ///< of the schema
    std::vector<Value> arguments;  ///< named by object or placeholder
};

/// What a stream has made, or found to hold, of values that a plan rests on.
struct StreamFact {
    StreamId stream;
    std::vector<Value> inputs;
    std::vector<Value> outputs;
};

struct RefinedPlan {
    std::vector<RefinedStep> steps;
    /// All that the conditions of the steps need; `validate/refinement_validator.hpp` checks that it is.
    std::vector<StreamFact> facts;
    double cost = 0;  ///< by the task's metric, with the real values of the functions

    /// "(pick a #g1 #q2)": step i.
    std::string action(std::size_t i) const;
};

/// What was tried in vain; equal ones are counted together.
struct Attempt {
    std::string action;  ///< that wanted it; "(pick can4 #g1)"; empty: all samples were enumerated
    std::string stream;
    Reason reason = Reason::other;
    std::string message;
    bool definite = true;
    Value picture;  ///< of the last such failure
    std::uint64_t count = 0;
};

enum class RefineStatus : std::uint8_t {
    solved,
    infeasible,     ///< proved: no plan at the streams' discretisation
    out_of_budget,  ///< nothing found, nothing proved
    cancelled,      ///< by the stop token
};
std::string_view to_string(RefineStatus status);

struct RefineStatistics {
    std::uint64_t searches = 0, groundings = 0;
    std::uint64_t evaluated = 0;               ///< states, in all searches
    std::uint64_t skeletons = 0;               ///< different plans that were tried
    std::uint64_t stream_calls = 0;            ///< of callbacks
    std::uint64_t samples = 0;                 ///< of these, with success
    std::uint64_t nogoods = 0;                 ///< definite ones
    std::uint64_t soft_nogoods = 0;            ///< for a while
    std::uint64_t objects = 0, operators = 0;  ///< of the last ground task
    double search_seconds = 0, sample_seconds = 0, ground_seconds = 0;
    std::map<std::string, std::uint64_t> rejections = {};  ///< by stream
    bool exact = false;                                    ///< the last ground task had samples as objects
};

struct Refinement {
    RefineStatus status = RefineStatus::out_of_budget;
    std::optional<RefinedPlan> plan;
    std::vector<Attempt> attempts;  ///< most frequent first
    /// Why not, in words: one line a cause; empty where solved.
    std::vector<std::string> reasons;
    RefineStatistics statistics;
};

struct RefineCallbacks {
    std::function<void(const RefineStatistics&)> on_progress;  ///< after each skeleton
};

/// Plans and refines. Throws std::invalid_argument for streams or functions without a callback, unknown
/// objects in `values` and wrong options; StreamError for callbacks that break the rules; UnsupportedError as
/// `ground` does. The same problem and seed give the same plan, if the clock ends nothing.
Refinement refine(const RefinementProblem& problem, const Budget& budget = {},
                  const RefineCallbacks& callbacks = {});

}  // namespace praxis::tamp
