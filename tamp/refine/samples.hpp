// Values and what streams have made of them: every call of a callback goes through here, and its answer is
// kept for all skeletons that ask the same.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "tamp/refine/refine.hpp"
#include "tamp/refine/tuple_map.hpp"

namespace praxis::tamp {

/// A value by number: first the problem's objects in their order, then samples as they come.
using ValueNumber = std::uint32_t;

/// A ground atom with values for arguments: predicate, values.
using ValueAtom = Tuple;

/// What a stream has answered so far to one tuple of inputs (and fluents).
struct SampleList {
    std::vector<ValueNumber> outputs;  ///< sample after sample
    std::uint32_t count = 0;           ///< samples
    std::uint32_t attempts = 0;
    bool finished = false;  ///< no further call will be made
    bool definite = true;   ///< and it is proved that nothing else could come
    /// To blame for the rejections so far: positions among the fluents of the call, and of the inputs.
    std::vector<bool> fluents;
    std::vector<bool> inputs;
    /// Fluents that each explain all rejections so far, alone; empty: none does.
    std::vector<std::uint32_t> each;
};

/// Whoever asks: for the attempts that are reported.
class ActionText {
  public:
    virtual ~ActionText() = default;
    virtual std::string text() const = 0;
};

class Samples {
  public:
    /// Keeps references to all three. Throws std::invalid_argument as `refine` does.
    Samples(const RefinementProblem& problem, const Budget& budget, RefineStatistics& statistics);

    const StreamInfo& info(StreamId stream) const { return streams_[stream.index()]->info; }
    const Value& value(ValueNumber number) const { return values_[number]; }

    /// The answers for these inputs; `fluents` sorted. The reference stays valid.
    SampleList& list(StreamId stream, std::span<const ValueNumber> inputs,
                     std::span<const ValueAtom> fluents);
    /// Calls the callback once more, unless the list is finished. True: there is a further sample.
    bool extend(SampleList& list, StreamId stream, std::span<const ValueNumber> inputs,
                std::span<const ValueAtom> fluents, const ActionText& action);

    /// Throws StreamError if the callback gives no cost.
    double cost(std::size_t function, std::span<const ValueNumber> arguments) const;
    double lower_bound(std::size_t function) const { return functions_[function]->lower_bound; }

    std::vector<Attempt> attempts() const;
    /// Adds what streams without fluents have said of these values and of those that they were made of.
    void add_facts(std::vector<ValueNumber> values, std::vector<StreamFact>& facts) const;
    /// What the calls have cost so far, by `StreamInfo::effort`, in microseconds.
    double effort() const { return effort_; }

  private:
    void reject(SampleList& list, StreamId stream, const StreamResult& result, const ActionText& action);
    static void blame_fluents(SampleList& list, const Blame& blame);
    void accept(SampleList& list, StreamId stream, StreamResult result, std::uint64_t fingerprint);
    StreamResult call(StreamId stream, StreamCall& call) const;
    std::string describe(StreamId stream, std::span<const Value> inputs) const;

    const RefinementProblem& problem_;
    const Budget& budget_;
    RefineStatistics& statistics_;
    std::vector<const StreamLibrary::BoundStream*> streams_;
    std::vector<const StreamLibrary::BoundFunction*> functions_;
    std::vector<Value> values_;
    std::vector<std::uint64_t> fingerprints_;  ///< by value: the same whatever the order of calls
    TupleMap<SampleList> lists_;
    Tuple key_;  ///< scratch
    std::map<std::tuple<std::string, std::string, Reason, std::string>, Attempt> attempts_;
    double effort_ = 0;
};

}  // namespace praxis::tamp
