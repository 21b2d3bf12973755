#include "app/watcher.hpp"

#include <csignal>
#include <ctime>

namespace praxis::app {

Watcher::Watcher(std::optional<Clock::time_point> deadline, Hooks hooks)
    : deadline_(deadline), hooks_(std::move(hooks)) {
    sigemptyset(&signals_);
    for (int number : {SIGINT, SIGTERM, SIGXCPU}) sigaddset(&signals_, number);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
    pthread_attr_setstacksize(&attributes, std::size_t{512} * 1024);
    pthread_t thread{};
    // Without a thread (address space too small, say) signals kill as they do anywhere.
    if (pthread_create(&thread, &attributes, &Watcher::run, this) != 0)
        pthread_sigmask(SIG_UNBLOCK, &signals_, nullptr);
    pthread_attr_destroy(&attributes);
}

void* Watcher::run(void* self) {
    static_cast<Watcher*>(self)->watch();
    return nullptr;
}

void Watcher::take(int number) {
    int none = 0;
    if (signal_.compare_exchange_strong(none, number)) {
        source_.request_stop();
        const auto now = Clock::now();
        if (!deadline_ || now < *deadline_) deadline_ = now;
        return;
    }
    if (number == SIGXCPU) return;
    std::signal(number, SIG_DFL);
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, number);
    pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
    raise(number);
}

void Watcher::watch() {
    while (true) {
        auto wait = hooks_.on_tick ? hooks_.tick : std::chrono::milliseconds(std::chrono::hours(1));
        if (deadline_ && !finished_.load(std::memory_order_acquire)) {
            const auto left =
                std::chrono::ceil<std::chrono::milliseconds>(*deadline_ + kGrace - Clock::now());
            wait = std::max(std::chrono::milliseconds(0), std::min(wait, left));
        }
        const timespec timeout{wait.count() / 1000, static_cast<long>(wait.count() % 1000) * 1'000'000};
        const int number = sigtimedwait(&signals_, nullptr, &timeout);
        if (number > 0) take(number);
        if (finished_.load(std::memory_order_acquire)) continue;
        if (deadline_ && Clock::now() >= *deadline_ + kGrace) {
            const int first = signal();
            hooks_.on_overrun(first != 0 && first != SIGXCPU ? Stop::interrupted : Stop::time);
        } else if (hooks_.on_tick) {
            hooks_.on_tick();
        }
    }
}

}  // namespace praxis::app
