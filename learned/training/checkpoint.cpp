#include "learned/training/checkpoint.hpp"

#include <algorithm>

#include "learned/weights/planner_json.hpp"
#include "learned/weights/weights_file.hpp"
#include "parser/diagnostic.hpp"

namespace praxis::learned {
namespace {

// All that decides how a run goes on; the number of threads does not.
nlohmann::json identity(const TrainingOptions& options) {
    return {{"epochs", options.epochs},
            {"batch", options.batch},
            {"rate", options.rate},
            {"final_rate", options.final_rate},
            {"method", options.optimizer.method == Method::adam ? "adam" : "rmsprop"},
            {"clip", options.optimizer.clip},
            {"smoothing", options.optimizer.smoothing},
            {"epsilon", options.optimizer.epsilon},
            {"loss", options.loss == Loss::all_optimal ? "all optimal" : "one label"},
            {"seed", options.seed}};
}

}  // namespace

void write_checkpoint(const std::string& file, Trainer& trainer) {
    nlohmann::json origin = identity(trainer.options());
    ArrayFile contents = planner_contents(trainer.planner(), origin);
    contents.header["training"] = {{"options", std::move(origin)},
                                   {"epochs_done", trainer.epochs_done()},
                                   {"steps", trainer.optimizer().steps()}};
    contents.arrays.emplace_back("optimizer.mean", trainer.optimizer().mean());
    contents.arrays.emplace_back("optimizer.square", trainer.optimizer().square());
    write_array_file(file, contents);
}

void read_checkpoint(const std::string& file, Trainer& trainer) {
    const auto fail = [&](const std::string& what) { throw InputError(file + ": error: " + what + "\n"); };
    const ArrayFile contents = read_array_file(file);
    const ReadPlanner read = parse_planner(contents, file);
    if (read.planner->options() != trainer.planner().options())
        fail("this is a checkpoint of another planner");
    const nlohmann::json training = contents.header.value("training", nlohmann::json());
    if (!training.is_object() || !training.contains("options") || !training.contains("epochs_done") ||
        !training.contains("steps"))
        fail("these are weights, but not a checkpoint");
    if (training["options"] != identity(trainer.options()))
        fail("this checkpoint was made with other training options: " + training["options"].dump());
    const auto &epochs = training["epochs_done"], &steps = training["steps"];
    if (!epochs.is_number_unsigned() ||
        epochs.get<std::uint64_t>() > static_cast<std::uint64_t>(trainer.options().epochs) ||
        !steps.is_number_unsigned())
        fail("how far training had got is no number, or too far");
    const auto &mean = contents.array("optimizer.mean", file),
               &square = contents.array("optimizer.square", file);
    if (mean.size() != trainer.optimizer().mean().size() ||
        square.size() != trainer.optimizer().square().size())
        fail("the optimiser's state has another size");
    std::ranges::copy(read.planner->parameters(), trainer.planner().parameters().begin());
    trainer.planner().update();
    trainer.optimizer().mean() = mean;
    trainer.optimizer().square() = square;
    trainer.optimizer().set_steps(steps.get<std::uint64_t>());
    trainer.set_epochs_done(epochs.get<int>());
}

}  // namespace praxis::learned
