#include "app/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "app/report.hpp"

namespace praxis::app {

Progress::Progress(bool shown) : shown_(shown), terminal_(shown && isatty(STDERR_FILENO) == 1) {}

std::chrono::milliseconds Progress::interval() const {
    return std::chrono::milliseconds(terminal_ ? 250 : 1000);
}

void Progress::set_statistics(const SearchStatistics& statistics) {
    statistics_ = statistics;
    searching_ = true;
}

void Progress::set_share(double done, std::string text) {
    share_ = std::clamp(done, 0.0, 1.0);
    share_text_ = std::move(text);
}

std::string Progress::share_line() const {
    constexpr std::size_t kWidth = 24;
    std::string text = phase_;
    if (terminal_) {
        std::string bar(static_cast<std::size_t>(*share_ * kWidth), '#');
        bar.resize(kWidth, '.');
        text += " [" + bar + "]";
    }
    return text + ": " + share_text_;
}

std::string Progress::line() const {
    char head[48];
    std::snprintf(head, sizeof head, "[%6.1f s, %s] ", elapsed_seconds(),
                  bytes_text(resident_memory()).c_str());
    std::string text = head;
    if (share_) return text + share_line();
    if (!detail_.empty()) return text + phase_ + ": " + detail_;
    if (!searching_) return text + phase_;
    text += phase_;
    text +=
        ": expanded " + count_text(statistics_.expanded) + ", evaluated " + count_text(statistics_.evaluated);
    text += ", states " + count_text(statistics_.registered_states);
    if (statistics_.best_estimate) text += ", best estimate " + std::to_string(*statistics_.best_estimate);
    return text;
}

void Progress::show() {
    if (!shown_ || elapsed_seconds() < next_) return;
    if (terminal_) {
        std::fprintf(stderr, "\r%s\033[K", line().c_str());
        visible_ = true;
        return;
    }
    // Plain lines come less and less often: 1, 2, 4, ... up to every 60 seconds.
    std::fprintf(stderr, "%s\n", line().c_str());
    next_ = elapsed_seconds() + step_;
    step_ = std::min(60.0, step_ * 2);
}

void Progress::clear() {
    if (visible_) std::fputs("\r\033[K", stderr);
    visible_ = false;
}

void Progress::print(const std::string& line) {
    clear();
    std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace praxis::app
