#include "parser/reporter.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace praxis {
namespace {

bool same_place_and_text(const Diagnostic& a, const Diagnostic& b) {
    return a.where.file == b.where.file && a.where.offset == b.where.offset && a.severity == b.severity &&
           a.message == b.message;
}

}  // namespace

void Reporter::add(Severity severity, Location where, std::string message, std::string hint) {
    std::size_t& count = severity == Severity::warning ? warnings_
                         : severity == Severity::error ? errors_
                                                       : unsupported_;
    if (++count > kKept) return;
    diagnostics_.push_back({severity, where, true, std::move(message), std::move(hint)});
}

void Reporter::error(Location where, std::string message, std::string hint) {
    add(Severity::error, where, std::move(message), std::move(hint));
}

void Reporter::warning(Location where, std::string message, std::string hint) {
    add(Severity::warning, where, std::move(message), std::move(hint));
}

void Reporter::unsupported(Location where, const std::string& construct, std::string hint) {
    add(Severity::unsupported, where, construct + " are not supported", std::move(hint));
}

std::vector<Diagnostic> Reporter::finish(const Sources& sources) {
    std::stable_sort(diagnostics_.begin(), diagnostics_.end(), [](const Diagnostic& a, const Diagnostic& b) {
        return std::tie(a.where.file, a.where.offset) < std::tie(b.where.file, b.where.offset);
    });
    diagnostics_.erase(std::unique(diagnostics_.begin(), diagnostics_.end(), same_place_and_text),
                       diagnostics_.end());
    if (errors_ + unsupported_ == 0) {
        if (diagnostics_.size() > kShown) diagnostics_.resize(kShown);
        return std::exchange(diagnostics_, {});
    }
    std::string text;
    std::vector<Diagnostic> shown;
    std::size_t shown_warnings = 0;
    for (const Diagnostic& diagnostic : diagnostics_) {
        const bool is_warning = diagnostic.severity == Severity::warning;
        if (is_warning ? shown_warnings++ >= kShown
                       : shown.size() - std::min(shown_warnings, kShown) >= kShown) {
            continue;
        }
        text += to_string(diagnostic, sources);
        shown.push_back(diagnostic);
    }
    const auto wrong = static_cast<std::size_t>(
        std::count_if(diagnostics_.begin(), diagnostics_.end(),
                      [](const Diagnostic& d) { return d.severity != Severity::warning; }));
    const std::size_t beyond =
        (errors_ > kKept ? errors_ - kKept : 0) + (unsupported_ > kKept ? unsupported_ - kKept : 0);
    if (wrong + beyond > kShown) text += "... and " + std::to_string(wrong + beyond - kShown) + " more\n";
    if (errors_ > 0) throw InputError(std::move(text), std::move(shown));
    throw UnsupportedError(std::move(text), std::move(shown));
}

}  // namespace praxis
