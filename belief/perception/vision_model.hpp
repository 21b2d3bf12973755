// A vision-language model behind an OpenAI-compatible endpoint: POST {base}/chat/completions.
//
// Hosted services and local servers (vLLM, llama.cpp, Ollama, ...) speak this protocol. Requests that fail
// for a while (429, 5xx, broken connections, time-outs, answers that are not of the protocol) are sent again
// after a growing pause, or after the one that the server asks for; other failures are told at once, with the
// server's own words. Keys are taken from the environment and appear in no message and no record.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <random>
#include <string>

#include "belief/perception/chat.hpp"
#include "belief/perception/http.hpp"

namespace praxis::belief {

struct VisionModelOptions {
    std::string base = "http://127.0.0.1:8000/v1";  ///< of the service; https:// where it has a certificate
    std::string model;                              ///< the service's name for it
    std::string key_variable;  ///< the environment variable that holds the key; empty: none is sent
    HttpLimits limits;         ///< of each request; `limits.timeout` counts anew for each attempt
    int attempts = 4;          ///< requests for one question, all told
    std::chrono::milliseconds first_pause{
        500};  ///< before the second attempt; doubled before each further one
    std::chrono::milliseconds longest_pause{30000};  ///< a server that asks for a longer one is given up
    std::optional<double> temperature = 0;
    bool json = true;  ///< ask the service for JSON (`response_format`)
    /// Further members of the request, as the text of a JSON object: {"max_completion_tokens": 4000}, say.
    std::string more;
    double prompt_price = 0;  ///< per million tokens, in any currency
    double completion_price = 0;
    /// Nothing is asked any more once the answers have cost this much.
    std::optional<double> cost_limit;
    std::uint64_t seed = 0;  ///< of the pauses' jitter
};

/// What a model has used up so far.
struct VisionModelCounters {
    std::int64_t requests = 0;  ///< attempts, answered or not
    std::int64_t retries = 0;   ///< those among them that were not the first
    std::int64_t answers = 0;
    std::int64_t prompt_tokens = 0;
    std::int64_t completion_tokens = 0;
    double cost = 0;
    double seconds = 0;  ///< from question to answer, pauses included
};

class VisionModel : public ChatModel {
  public:
    /// Throws PerceptionError if an option makes no sense or the key is not in the environment.
    explicit VisionModel(VisionModelOptions options);

    std::string name() const override { return options_.model; }
    /// May be called from several threads.
    ChatAnswer ask(const std::vector<Message>& messages, std::stop_token stop) override;

    VisionModelCounters counters() const;

  private:
    void check_cost() const;
    ChatAnswer ask_again_and_again(const HttpRequest& request, const std::stop_token& stop);
    void pause(int attempt, const std::string& retry_after, const std::string& why,
               const std::stop_token& stop);
    HttpRequest request_for(const std::vector<Message>& messages) const;

    VisionModelOptions options_;
    Url base_;
    std::string key_;
    mutable std::mutex mutex_;  ///< guards what follows
    VisionModelCounters counters_;
    std::mt19937_64 random_;
};

}  // namespace praxis::belief
