// Trains a planner network on the published 15x15 mazes, or on mazes of its own, and prints its learning
// curve:
//
//     learned_training [OPTION=VALUE]...
//
// Options: data=FOLDER (train.bin, valid.bin, test.bin; or a size, 15, 28, 50: mazes of our own), model,
// group, fields, iterations, radius, input_radius, contraction, implicit=1, epochs, batch, rate, final_rate,
// method=adam|rmsprop, clip, loss=all|one, seed, threads, limit (training maps), every (epochs between looks
// at the validation maps), test=1 (look at the test maps at the end).
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include "learned/maps/maze_file.hpp"
#include "learned/maps/navigation.hpp"
#include "learned/training/trainer.hpp"

namespace praxis::learned {
namespace {

class Settings {
  public:
    Settings(int count, char** words) {
        for (int i = 1; i < count; ++i) {
            const std::string word = words[i];
            const std::size_t at = word.find('=');
            if (at == std::string::npos) throw std::invalid_argument("not OPTION=VALUE: " + word);
            values_[word.substr(0, at)] = word.substr(at + 1);
        }
    }
    std::string text(const std::string& name, const std::string& otherwise) {
        const auto found = values_.find(name);
        return found == values_.end() ? otherwise : found->second;
    }
    double number(const std::string& name, double otherwise) {
        const auto found = values_.find(name);
        return found == values_.end() ? otherwise : std::stod(found->second);
    }
    int integer(const std::string& name, int otherwise) { return static_cast<int>(number(name, otherwise)); }

  private:
    std::map<std::string, std::string> values_;
};

MapSet maps(Settings& settings, const std::string& part, std::size_t count, std::size_t limit) {
    const std::string data = settings.text("data", "15");
    if (data.find('/') != std::string::npos) return read_mazes(data + "/" + part + ".bin", 15, limit);
    const std::uint64_t seed = part == "train" ? 1 : part == "valid" ? 2 : 3;
    return navigation_set(std::stoi(data), limit ? limit : count, seed);
}

void print(const char* what, const Score& score) {
    std::printf("  %s: success %.2f %%, optimal %.2f %%, SPL %.2f %%", what, 100 * score.success,
                100 * score.optimal, 100 * score.spl);
}

void run(Settings& settings) {
    PlannerOptions options;
    options.model = settings.text("model", "vin");
    options.group = settings.text("group", "c1");
    options.fields = settings.integer("fields", 40);
    options.iterations = settings.integer("iterations", 30);
    options.radius = settings.integer("radius", 1);
    options.input_radius = settings.integer("input_radius", 1);
    options.contraction = settings.number("contraction", options.contraction);
    if (settings.integer("implicit", 0)) options.differentiation = Differentiation::implicit;
    TrainingOptions training;
    training.epochs = settings.integer("epochs", 30);
    training.batch = settings.integer("batch", 32);
    training.rate = settings.number("rate", training.rate);
    training.final_rate = settings.number("final_rate", training.final_rate);
    training.optimizer.method = settings.text("method", "adam") == "adam" ? Method::adam : Method::rmsprop;
    training.optimizer.clip = settings.number("clip", 5);
    training.loss = settings.text("loss", "all") == "all" ? Loss::all_optimal : Loss::one_label;
    training.seed = static_cast<std::uint64_t>(settings.integer("seed", 1));
    training.threads = settings.integer("threads", 1);

    const MapSet train =
        maps(settings, "train", 10'000, static_cast<std::size_t>(settings.integer("limit", 0)));
    const MapSet valid = maps(settings, "valid", 2'000, 500);
    const auto planner = make_planner<float>(options, training.seed);
    std::printf("%zu parameters, kernels: %s\n", planner->parameters().size(), kernels<float>().name);
    Trainer trainer(*planner, train, training);
    double seconds = 0;
    const int every = settings.integer("every", 1);
    trainer.run([&](const EpochReport& report) {
        seconds += report.seconds;
        std::printf("epoch %2d  loss %.4f  %.1f s", report.epoch, report.loss, seconds);
        if (report.refused_steps) std::printf("  (%d steps refused)", report.refused_steps);
        if (report.epoch % every == 0 || trainer.done())
            print("valid", evaluate(*planner, valid, training.threads));
        std::printf("\n");
        std::fflush(stdout);
        return true;
    });
    if (settings.integer("test", 0)) {
        print("test", evaluate(*planner, maps(settings, "test", 2'000, 0), training.threads));
        std::printf("\n");
    }
}

}  // namespace
}  // namespace praxis::learned

int main(int count, char** words) {
    try {
        praxis::learned::Settings settings(count, words);
        praxis::learned::run(settings);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "learned_training: %s\n", error.what());
        return 2;
    }
}
