// Short runs of practice for tests: small settings, and what of two runs must be equal.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "practice/loop/journal.hpp"
#include "practice/loop/practice_loop.hpp"
#include "practice/loop/run_practice.hpp"
#include "practice/loop/settings_text.hpp"
#include "practice/loop/simulated_world.hpp"

namespace praxis::practice::test {

/// Options with which a cycle takes milliseconds.
inline PracticeOptions quick(const std::string& method = "ees", std::uint64_t seed = 1) {
    PracticeOptions options;
    options.method = method;
    options.seed = seed;
    options.cycles = 3;
    options.cycle_steps = 20;
    options.learn_every = 7;
    options.test_tasks = 3;
    options.competence.model = "beta";
    options.policy.candidates = 10;
    options.policy.classifier.kind = "knn";
    return options;
}

/// All that is not time.
inline void expect_same(const RunResult& one, const RunResult& other) {
    EXPECT_EQ(one.environment, other.environment);
    EXPECT_EQ(one.method, other.method);
    EXPECT_EQ(one.seed, other.seed);
    EXPECT_EQ(one.curve, other.curve);
    EXPECT_EQ(one.choices, other.choices);
}

/// A simulated world that keeps a record of what happens in it.
class RecordingWorld : public SimulatedWorld {
  public:
    using SimulatedWorld::SimulatedWorld;
    std::vector<GroundAtom> next_task() override {
        auto goal = SimulatedWorld::next_task();
        task_states.push_back(observe());
        return goal;
    }
    void execute(const GroundSkill& skill, std::span<const double> parameters) override {
        SimulatedWorld::execute(skill, parameters);
        steps.push_back({skill, {parameters.begin(), parameters.end()}, observe()});
    }
    std::vector<JournalStep> steps;
    std::vector<State> task_states;
};

/// A file of its own for a test, gone afterwards.
class TestFile {
  public:
    TestFile()
        : path_((std::filesystem::path(::testing::TempDir()) /
                 ("practice-" + std::to_string(::getpid()) + "-" + std::to_string(counter()++)))
                    .string()) {
        std::filesystem::remove(path_);
    }
    ~TestFile() { std::filesystem::remove(path_); }
    TestFile(const TestFile&) = delete;
    TestFile& operator=(const TestFile&) = delete;

    const std::string& path() const { return path_; }
    std::string text() const {
        std::ifstream file(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    void write(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }

  private:
    static int& counter() {
        static int count = 0;
        return count;
    }
    std::string path_;
};

}  // namespace praxis::practice::test
