#include "learned/training/trainer.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <numeric>
#include <stdexcept>

#include "learned/training/parallel.hpp"
#include "search/engines/random.hpp"

namespace praxis::learned {
namespace {

constexpr std::size_t kShard = 8;  // maps

void check(const MapSet& maps, const TrainingOptions& options) {
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw std::invalid_argument(what);
    };
    require(!maps.problems.empty(), "training needs maps");
    require(options.epochs >= 0 && options.batch >= 1 && options.threads >= 1,
            "training needs batches of at least one map and at least one thread");
    require(options.rate > 0 && options.final_rate >= 0, "learning rates must be positive");
}

double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

struct Trainer::Shard {
    std::vector<float> gradient;
    double loss = 0;
};

Trainer::Trainer(Planner<float>& planner, const MapSet& maps, TrainingOptions options)
    : planner_(planner),
      maps_(maps),
      options_(options),
      optimizer_(options.optimizer, planner.parameters().size()) {
    check(maps, options);
    for (int thread = 0; thread < options.threads; ++thread)
        traces_.push_back(planner.trace(maps.height, maps.width));
    gradient_.resize(planner.parameters().size());
}

Trainer::~Trainer() = default;

double Trainer::rate_now() const {
    const double steps_an_epoch = std::ceil(static_cast<double>(maps_.problems.size()) / options_.batch);
    const double part =
        std::min(1.0, static_cast<double>(optimizer_.steps()) / (steps_an_epoch * options_.epochs));
    return options_.final_rate +
           (options_.rate - options_.final_rate) * (1 + std::cos(std::numbers::pi * part)) / 2;
}

double Trainer::batch(std::span<const std::size_t> chosen) {
    shards_.resize((chosen.size() + kShard - 1) / kShard);
    const int threads = options_.threads;
    run_parallel(threads, [&](int thread) {
        Trace<float>& trace = *traces_[static_cast<std::size_t>(thread)];
        for (std::size_t s = static_cast<std::size_t>(thread); s < shards_.size();
             s += static_cast<std::size_t>(threads)) {
            Shard& shard = shards_[s];
            shard.gradient.assign(gradient_.size(), 0);
            shard.loss = 0;
            for (const std::size_t k :
                 chosen.subspan(s * kShard, std::min(kShard, chosen.size() - s * kShard))) {
                draw(maps_.problems[k], trace);
                planner_.record(trace);
                shard.loss +=
                    static_cast<double>(policy_loss(options_.loss, maps_.problems[k], trace.policy,
                                                    1 / static_cast<float>(chosen.size()), trace.of_policy));
                planner_.differentiate(trace, shard.gradient);
            }
        }
    });
    std::ranges::fill(gradient_, 0.0f);
    double loss = 0;
    for (const Shard& shard : shards_) {
        for (std::size_t i = 0; i < gradient_.size(); ++i) gradient_[i] += shard.gradient[i];
        loss += shard.loss;
    }
    if (!optimizer_.step(planner_.parameters(), gradient_, rate_now())) ++refused_;
    planner_.update();
    return loss;
}

EpochReport Trainer::epoch() {
    std::vector<std::size_t> order(maps_.problems.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Random random(options_.seed * 1000003 + static_cast<std::uint64_t>(epochs_done_));
    random.shuffle(order);
    const double start = processor_seconds();
    refused_ = 0;
    double loss = 0;
    const std::size_t size = static_cast<std::size_t>(options_.batch);
    for (std::size_t first = 0; first < order.size(); first += size)
        loss +=
            batch(std::span<const std::size_t>(order).subspan(first, std::min(size, order.size() - first)));
    ++epochs_done_;
    return {epochs_done_, loss / static_cast<double>(order.size()), refused_, processor_seconds() - start};
}

void Trainer::run(const std::function<bool(const EpochReport&)>& report) {
    while (!done())
        if (!report(epoch())) return;
}

}  // namespace praxis::learned
