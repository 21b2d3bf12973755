// The words of the chat protocol: requests and answers as JSON texts.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "belief/perception/chat.hpp"
#include "belief/perception/vision_model.hpp"

namespace praxis::belief {

/// The body of a request. Throws PerceptionError if an image is none, or `options.more` is no JSON object.
std::string write_chat_request(const VisionModelOptions& options, const std::vector<Message>& messages);

/// The answer in a successful response; nothing if it is not of the protocol, with the reason in `why`.
/// Throws PerceptionError if the model refuses to answer.
std::optional<ChatAnswer> read_chat_response(const std::string& body, std::string& why);

/// What a server says about a failure: the message in its JSON, or the beginning of its text.
std::string error_message(const std::string& body);

/// The value of Retry-After, seconds or a date, from `now` on; nothing if it is neither.
std::optional<std::chrono::milliseconds> read_retry_after(const std::string& value,
                                                          std::chrono::system_clock::time_point now);

}  // namespace praxis::belief
