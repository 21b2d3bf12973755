#include "app/command_line_parts.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>

#include "app/exit_code.hpp"

namespace praxis::app {
namespace {

/// Seconds or MiB; what is above cannot be told from no limit.
constexpr double kLargestLimit = 1e9;

/// Help pages with the usage lines of ours in place of a generated one.
class UsageFormatter : public CLI::Formatter {
  public:
    explicit UsageFormatter(std::string usage) : usage_(std::move(usage)) { column_width(28); }
    std::string make_usage(const CLI::App*, std::string) const override { return usage_ + "\n"; }
    std::string make_option_opts(const CLI::Option* option) const override {
        if (option->get_type_size() == 0) return {};
        return " " + option->get_type_name();
    }

  private:
    std::string usage_;
};

}  // namespace

void set_usage(CLI::App& app, const std::string& usage, const std::string& footer) {
    app.formatter(std::make_shared<UsageFormatter>(usage));
    app.footer(footer);
    app.set_help_flag("-h,--help", "Show this page");
}

std::string positive_number(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    if (end != text.c_str() && *end == '\0' && number > 0 && number <= kLargestLimit) return {};
    return "'" + text + "' is not a positive number";
}

std::string non_negative_integer(const std::string& text) {
    if (!text.empty() && text.find_first_not_of("0123456789") == std::string::npos) return {};
    return "'" + text + "' is not a non-negative integer";
}

void add_common_options(CLI::App& app, CommonOptions& options) {
    auto* quiet = app.add_flag("-q,--quiet", options.quiet, "Nothing on standard error but errors");
    app.add_flag("-v,--verbose", options.verbose, "Phases and statistics on standard error")->excludes(quiet);
    app.add_option("--json", options.json, "Write a report as JSON; '-': to standard output")
        ->type_name("FILE");
    app.add_option("-t,--time-limit", options.time_limit, "Wall seconds for everything")
        ->type_name("S")
        ->check(positive_number);
    app.add_option("-m,--memory-limit", options.memory_limit_mb, "Resident memory in MiB")
        ->type_name("MB")
        ->check(positive_number);
}

Done usage_error(const std::string& message, const char* hint) {
    std::fprintf(stderr, "plan: error: %s\nTry '%s --help'.\n", message.c_str(), hint);
    return Done{kInputError};
}

std::optional<Done> parse(CLI::App& app, std::vector<std::string> arguments, const char* hint) {
    try {
        app.parse(std::move(arguments));
        return std::nullopt;
    } catch (const CLI::CallForHelp&) {
        std::fputs(app.help().c_str(), stdout);
        return Done{std::fflush(stdout) == 0 ? kSolved : kOutputError};
    } catch (const CLI::CallForVersion& version) {
        std::printf("%s\n", version.what());
        return Done{std::fflush(stdout) == 0 ? kSolved : kOutputError};
    } catch (const CLI::ParseError& error) {
        // Errors about positional arguments begin with their empty option name.
        const std::string message = error.what();
        return usage_error(message.substr(message.starts_with(": ") ? 2 : 0), hint);
    }
}

}  // namespace praxis::app
