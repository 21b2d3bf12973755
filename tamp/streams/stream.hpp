// Streams: what makes the values that actions need, in C++.
//
// A stream is declared in a PDDL file (docs/stream-language.md): what it takes (inputs), what must hold of
// them (domain), what it makes (outputs) and what it certifies. The work is done by a callback that is bound
// to its name:
//
//     StreamLibrary library;
//     library.bind("sample-pose", [](StreamCall& call) {
//         const Region& region = call.inputs[1].get<Region>();
//         return StreamResult::sample({Value::of(region.random_point(call.random))});
//     });
//     library.bind("cfree", [](StreamCall& call) {
//         return apart(call.inputs[0].get<double>(), call.inputs[1].get<double>())
//                    ? StreamResult::pass()
//                    : StreamResult::reject({.reason = Reason::collision, .message = "too close"});
//     });
//
// A *call* asks for one more tuple of outputs for given inputs; a stream without outputs is a *test*. A call
// ends in one of three ways: a *sample*; a *rejection* (this attempt failed: of a test, for good; of a
// generator, ask again); or *exhaustion* (there is no further sample for these inputs). A stream with
// `:fluents` also gets the atoms of these predicates that hold where the action starts, and must say which of
// them are to blame for a rejection.
//
// What is said here decides what the planner may conclude: it claims that a problem is infeasible only from
// streams that end in exhaustion, and from rejections that are `definite`. So a motion planner that gives up
// after a while sets `definite = false`.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "search/budget.hpp"
#include "search/engines/random.hpp"
#include "tamp/streams/value.hpp"

namespace praxis::tamp {

/// A ground atom of the symbolic state. Objects of the problem without a value have only their name.
struct FluentAtom {
    std::string_view predicate;
    std::span<const Value> arguments;
};

struct StreamCall {
    std::string_view stream;
    std::span<const Value> inputs;
    std::uint32_t attempt = 0;  ///< 0, 1, ...: how often these inputs (and fluents) were asked before
    std::span<const FluentAtom> fluents;
    /// Seeded by the planner's seed, the stream, the inputs' names and the attempt: what it gives does not
    /// depend on the order in which streams are called.
    Random random;
    const Budget& budget;  ///< long work asks it
};

/// Why something failed.
enum class Reason : std::uint8_t { collision, kinematics, no_path, other };
std::string_view to_string(Reason reason);

/// What is to blame for a rejection.
struct Blame {
    Reason reason = Reason::other;
    std::string message = {};
    /// Indices into `StreamCall::fluents`: with these inputs the call fails wherever these atoms hold. Empty:
    /// it fails whatever holds.
    std::vector<std::uint32_t> fluents = {};
    /// Each of these fluents alone is enough to make it fail (bodies in the way of the goal itself, say);
    /// otherwise they may be needed together. Much more is learned from it: say so where it is true.
    bool each = false;
    /// Indices of inputs: with these values it fails, whatever the others are. Empty: all inputs.
    std::vector<std::uint32_t> inputs = {};
    /// False: another try with the same inputs might succeed (a search was cut off, say). A definite
    /// rejection is for good of a test, and of a stream that has one sample at most; of other streams, it is
    /// about this sample.
    bool definite = true;
    /// For pictures of what failed; the planner hands it on (`Attempt::picture`).
    Value picture = {};
};

struct StreamResult {
    enum class Kind : std::uint8_t { sample, rejection, exhaustion };
    Kind kind = Kind::rejection;
    std::vector<Value> outputs = {};  ///< of a sample, in the order of the declaration
    Blame blame = {};                 ///< of a rejection; of an exhaustion, where nothing was ever found

    static StreamResult sample(std::vector<Value> outputs) { return {Kind::sample, std::move(outputs), {}}; }
    /// A test that holds.
    static StreamResult pass() { return {Kind::sample, {}, {}}; }
    static StreamResult reject(Blame blame = {}) { return {Kind::rejection, {}, std::move(blame)}; }
    static StreamResult exhausted(Blame blame = {}) { return {Kind::exhaustion, {}, std::move(blame)}; }
};

using StreamCallback = std::function<StreamResult(StreamCall&)>;
/// A cost for values of all parameters; finite and not negative.
using FunctionCallback = std::function<double(std::span<const Value>)>;

/// What the planner should know of a stream to use it well.
struct StreamInfo {
    /// What a call costs, in microseconds, roughly: the cheap are called first.
    double effort = 1;
    /// Samples a tuple of inputs has at most (the discretisation): no call is made for more. A stream that
    /// computes a function of its inputs has 1.
    std::uint32_t max_samples = std::numeric_limits<std::uint32_t>::max();
    /// Calls after which a tuple of inputs counts as exhausted, though the stream did not say so. Then
    /// failures are not definite, unless the stream said so.
    std::uint32_t max_attempts = 4096;
};

/// Callbacks by the names that the stream file declares. Names ignore case, as in PDDL.
class StreamLibrary {
  public:
    struct BoundStream {
        StreamCallback callback;
        StreamInfo info;
    };
    struct BoundFunction {
        FunctionCallback callback;
        double lower_bound = 0;  ///< what values that are not known yet cost at least
    };

    /// Replaces what was bound to the name. Throws std::invalid_argument for an empty callback or numbers
    /// that make no sense.
    void bind(std::string_view stream, StreamCallback callback, const StreamInfo& info = {});
    void bind_function(std::string_view function, FunctionCallback callback, double lower_bound = 0);

    /// Null if nothing is bound.
    const BoundStream* find(std::string_view stream) const;
    const BoundFunction* find_function(std::string_view function) const;
    std::vector<std::string> stream_names() const;

  private:
    std::map<std::string, BoundStream, std::less<>> streams_;
    std::map<std::string, BoundFunction, std::less<>> functions_;
};

/// A callback broke the rules: it threw, gave the wrong number of outputs, or a cost that is no cost. The
/// message names the stream and its inputs.
class StreamError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace praxis::tamp
