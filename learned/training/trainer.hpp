// Training a planner on maps with known optimal moves.
//
// A batch is cut into shards of a fixed size, each with a gradient of its own; the shards are added in order.
// So the result depends on seed and options but not on the number of threads. One call of epoch() is one pass
// over the training maps in an order that depends on the seed and on the number of the epoch alone: a trainer
// that was restored from a checkpoint (checkpoint.hpp) goes on exactly as if it had never stopped.
#pragma once

#include <functional>
#include <memory>

#include "learned/layers/loss.hpp"
#include "learned/maps/map_problem.hpp"
#include "learned/models/planner.hpp"
#include "learned/training/evaluation.hpp"
#include "learned/training/optimizer.hpp"

namespace praxis::learned {

struct TrainingOptions {
    int epochs = 30;
    int batch = 32;
    double rate = 5e-3;        ///< at the start
    double final_rate = 1e-4;  ///< at the end; in between, half a cosine
    OptimizerOptions optimizer;
    Loss loss = Loss::all_optimal;
    std::uint64_t seed = 1;
    int threads = 1;
};

/// A point of the learning curve.
struct EpochReport {
    int epoch = 0;          ///< from 1
    double loss = 0;        ///< mean over the epoch
    int refused_steps = 0;  ///< steps whose gradient was not finite
    double seconds = 0;     ///< processor time of the whole process spent in this epoch
};

class Trainer {
  public:
    /// Planner and maps must outlive the trainer. std::invalid_argument for options out of range or no maps.
    Trainer(Planner<float>& planner, const MapSet& maps, TrainingOptions options);
    ~Trainer();

    const TrainingOptions& options() const { return options_; }
    int epochs_done() const { return epochs_done_; }
    bool done() const { return epochs_done_ >= options_.epochs; }
    EpochReport epoch();
    /// All epochs that are left; `report` is told of each and may stop by returning false.
    void run(const std::function<bool(const EpochReport&)>& report);

    Planner<float>& planner() { return planner_; }
    Optimizer<float>& optimizer() { return optimizer_; }
    void set_epochs_done(int epochs) { epochs_done_ = epochs; }

  private:
    struct Shard;

    double batch(std::span<const std::size_t> chosen);
    double rate_now() const;

    Planner<float>& planner_;
    const MapSet& maps_;
    TrainingOptions options_;
    Optimizer<float> optimizer_;
    std::vector<std::unique_ptr<Trace<float>>> traces_;  // of each thread
    std::vector<Shard> shards_;
    std::vector<float> gradient_;
    int epochs_done_ = 0;
    int refused_ = 0;
};

}  // namespace praxis::learned
