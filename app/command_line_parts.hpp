// What the command lines of all commands share: help pages, checks of values, how wrong usage is told.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/common_options.hpp"

namespace praxis::app {

/// Sets the usage lines above the options of a help page and what stands below them.
void set_usage(CLI::App& app, const std::string& usage, const std::string& footer);

/// Checks for CLI11: empty if the text is fine, else what is wrong. A finite number above zero (CLI11's own
/// check lets "nan" pass).
std::string positive_number(const std::string& text);
std::string non_negative_integer(const std::string& text);

void add_common_options(CLI::App& app, CommonOptions& options);

/// Says what is wrong; `hint` is the command whose help page tells more.
Done usage_error(const std::string& message, const char* hint);

/// Parses and answers for help, version and wrong usage; nothing if the options are ready to use.
std::optional<Done> parse(CLI::App& app, std::vector<std::string> arguments, const char* hint);

}  // namespace praxis::app
