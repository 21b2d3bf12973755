#include "belief/perception/vision_model.hpp"

#include <algorithm>
#include <condition_variable>
#include <cstdlib>

#include "belief/perception/protocol.hpp"

namespace praxis::belief {
namespace {

using std::chrono::milliseconds;

std::string key_from(const std::string& variable) {
    if (variable.empty()) return {};
    const char* value = std::getenv(variable.c_str());
    if (value == nullptr || *value == '\0') {
        throw PerceptionError("no key: set the environment variable " + variable);
    }
    const std::string key = value;
    if (std::ranges::any_of(key, [](char c) { return c <= ' ' || c >= '\x7f'; })) {
        throw PerceptionError("the key in " + variable + " has a blank or an unprintable character");
    }
    return key;
}

void check(const VisionModelOptions& options) {
    if (options.model.empty()) throw PerceptionError("name the model");
    if (options.attempts < 1) throw PerceptionError("a model needs at least one attempt");
    if (options.limits.timeout <= milliseconds(0)) throw PerceptionError("a time-out must be positive");
    if (options.first_pause < milliseconds(0) || options.longest_pause < milliseconds(0)) {
        throw PerceptionError("a pause cannot be negative");
    }
    write_chat_request(options, {});  // are the further members JSON?
}

/// A server may repeat the key in what it complains about.
std::string without(std::string text, const std::string& key) {
    for (std::size_t at = 0; !key.empty() && (at = text.find(key, at)) != std::string::npos;) {
        text.replace(at, key.size(), "***");
    }
    return text;
}

bool worth_another_attempt(unsigned status) {
    return status == 408 || status == 429 || status >= 500;
}

}  // namespace

VisionModel::VisionModel(VisionModelOptions options)
    : options_(std::move(options)),
      base_(Url::parse(options_.base)),
      key_(key_from(options_.key_variable)),
      random_(options_.seed) {
    check(options_);
}

VisionModelCounters VisionModel::counters() const {
    const std::lock_guard lock(mutex_);
    return counters_;
}

HttpRequest VisionModel::request_for(const std::vector<Message>& messages) const {
    HttpRequest request{base_, "/chat/completions", {}, write_chat_request(options_, messages)};
    request.headers = {
        {"Content-Type", "application/json"}, {"Accept", "application/json"}, {"User-Agent", "praxis"}};
    if (!key_.empty()) request.headers.emplace_back("Authorization", "Bearer " + key_);
    return request;
}

void VisionModel::check_cost() const {
    const double cost = counters().cost;
    if (!options_.cost_limit || cost < *options_.cost_limit) return;
    throw PerceptionError("the answers have cost " + std::to_string(cost) + ", and the limit is " +
                          std::to_string(*options_.cost_limit));
}

ChatAnswer VisionModel::ask(const std::vector<Message>& messages, std::stop_token stop) {
    check_cost();
    const auto begin = std::chrono::steady_clock::now();
    const auto count_time = [&] {
        counters_.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    try {
        const ChatAnswer answer = ask_again_and_again(request_for(messages), stop);
        const std::lock_guard lock(mutex_);
        ++counters_.answers;
        counters_.prompt_tokens += answer.prompt_tokens;
        counters_.completion_tokens += answer.completion_tokens;
        counters_.cost += (static_cast<double>(answer.prompt_tokens) * options_.prompt_price +
                           static_cast<double>(answer.completion_tokens) * options_.completion_price) *
                          1e-6;
        count_time();
        return answer;
    } catch (...) {
        const std::lock_guard lock(mutex_);
        count_time();
        throw;
    }
}

ChatAnswer VisionModel::ask_again_and_again(const HttpRequest& request, const std::stop_token& stop) {
    for (int attempt = 1;; ++attempt) {
        {
            const std::lock_guard lock(mutex_);
            ++counters_.requests;
            if (attempt > 1) ++counters_.retries;
        }
        std::string why;
        std::string retry_after;
        try {
            const HttpResponse response = http_post(request, options_.limits, stop);
            if (response.status == 200) {
                if (auto answer = read_chat_response(response.body, why)) return *answer;
            } else {
                why = base_.authority() + " answers with status " + std::to_string(response.status) + ": " +
                      without(error_message(response.body), key_);
                if (!worth_another_attempt(response.status)) throw PerceptionError(why);
                retry_after = response.retry_after;
            }
        } catch (const HttpError& error) {
            if (!error.transient()) throw;
            why = error.what();
        }
        pause(attempt, retry_after, why, stop);
    }
}

void VisionModel::pause(int attempt, const std::string& retry_after, const std::string& why,
                        const std::stop_token& stop) {
    if (attempt >= options_.attempts) {
        throw PerceptionError(why + " (after " + std::to_string(attempt) +
                              (attempt == 1 ? " attempt)" : " attempts)"));
    }
    auto length = options_.longest_pause;
    if (const auto asked = read_retry_after(retry_after, std::chrono::system_clock::now())) {
        if (*asked > options_.longest_pause) {
            throw PerceptionError(why + " (it asks for a pause of " + std::to_string(asked->count() / 1000) +
                                  " s, longer than allowed)");
        }
        length = *asked;
    } else {
        // Between three and five quarters of the growing pause, so that many robots do not ask in step.
        const std::lock_guard lock(mutex_);
        const double share = std::uniform_real_distribution<double>(0.75, 1.25)(random_);
        const double growth = static_cast<double>(std::uint64_t{1} << std::min(attempt - 1, 30));
        const double wanted = static_cast<double>(options_.first_pause.count()) * growth * share;
        if (wanted < static_cast<double>(length.count()))
            length = milliseconds(static_cast<std::int64_t>(wanted));
    }
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    never.wait_for(lock, stop, length, [] { return false; });
    if (stop.stop_requested()) throw StoppedError();
}

}  // namespace praxis::belief
