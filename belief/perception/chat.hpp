// Conversations with a model that reads text and images. `VisionModel` asks one over HTTP, `RecordedModel`
// remembers what another one said; a robot with a model of its own implements `ChatModel` itself.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "belief/perception/errors.hpp"

namespace praxis::belief {

enum class Role : std::uint8_t { system, user, assistant };

std::string_view to_string(Role role);

struct Message {
    Role role = Role::user;
    std::string text;                 ///< UTF-8
    std::vector<std::string> images;  ///< the bytes of PNG or JPEG files; only in messages of the user
};

struct ChatAnswer {
    std::string text;
    bool cut_off = false;  ///< the model reached its limit of tokens
    std::int64_t prompt_tokens = 0;
    std::int64_t completion_tokens = 0;
};

class ChatModel {
  public:
    virtual ~ChatModel() = default;
    /// Names the model; the same questions to models of different names are different questions.
    virtual std::string name() const = 0;
    /// The model's next message. Throws PerceptionError if there is none, StoppedError if `stop` asks.
    virtual ChatAnswer ask(const std::vector<Message>& messages, std::stop_token stop) = 0;
};

}  // namespace praxis::belief
