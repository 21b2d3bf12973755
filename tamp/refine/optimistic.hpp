// The symbolic task of a stream task: streams are believed, and placeholders stand for what they will make.
//
// An *instance* is a stream with inputs. Its outputs are *placeholders*, new objects; several *copies* of an
// instance have placeholders of their own, for plans that need two values of the same kind. Where a stream is
// *materialised*, its instances are called until they are exhausted and every sample becomes an object: then
// the task says about it nothing but the truth.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "parser/streams.hpp"
#include "tamp/refine/samples.hpp"
#include "tamp/refine/tuple_map.hpp"

namespace praxis::tamp {

struct StreamInstance {
    StreamId stream;
    std::vector<ObjectId> inputs;
    std::vector<ObjectId> outputs;
};

struct OptimisticTask {
    static constexpr std::uint32_t kNone = 0xffffffff;

    Task task;  ///< with the new objects and what is certified of them
    std::vector<StreamInstance> instances;
    std::vector<std::uint32_t> producer;  ///< by object: instance; kNone where the value is known
    std::vector<ValueNumber> value;       ///< by object; kNone for placeholders
    TupleMap<std::uint32_t>
        certified_by;          ///< by certified atom that is not known to hold (predicate, objects): instance
    bool complete = true;      ///< every instance is there
    bool materialised = true;  ///< and every one that was to be called is exhausted, definitely
};

struct Instantiation {
    std::uint32_t copies = 1;
    std::uint32_t max_level = 6;
    std::uint32_t max_instances = 200'000;
    /// Call instances whose inputs are known, where the stream takes no fluents and costs at most this, in
    /// microseconds; 0: none.
    double materialise_effort = 0;
    std::uint32_t max_values = 20'000;  ///< of materialised samples
};

/// The task so instantiated. The samples' callbacks are called only where something is materialised and for
/// costs of known values. If the budget runs out, what is there so far (not complete).
OptimisticTask instantiate(const StreamTask& task, Samples& samples, const Instantiation& options,
                           const Budget& budget);

}  // namespace praxis::tamp
