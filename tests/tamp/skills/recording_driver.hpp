// A simulated robot that keeps what it is told, and can be told to misbehave.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "tamp/skills/simulated_driver.hpp"

namespace praxis::tamp::test {

class RecordingDriver : public SimulatedDriver {
  public:
    using SimulatedDriver::SimulatedDriver;

    Execution command(const RobotCommand& command) override {
        if (commands.size() == refuse_from) return {Execution::Status::failed, "the motors are off"};
        commands.push_back(command);
        times.push_back(seconds());
        if (on_command) on_command();
        return SimulatedDriver::command(command);
    }
    Configuration positions() override {
        Configuration measured = SimulatedDriver::positions();
        measured[0] += push;
        return measured;
    }
    void open() override { ++opened; }

    std::vector<RobotCommand> commands = {};
    std::vector<double> times = {};  ///< at which each command began
    std::function<void()> on_command = {};
    std::size_t refuse_from = static_cast<std::size_t>(-1);
    double push = 0;  ///< somebody pushes the first variable
    int opened = 0;
};

}  // namespace praxis::tamp::test
