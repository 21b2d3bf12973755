// A server on this machine that speaks the chat protocol, well or badly, as a test tells it to.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace praxis::test {

/// What the server does with a request.
struct Reaction {
    unsigned status = 200;
    std::string body;
    std::map<std::string, std::string> headers;
    std::chrono::milliseconds delay{0};    ///< before the first byte
    std::optional<std::size_t> cut_at;     ///< close the connection after so many bytes of the response
    std::chrono::milliseconds trickle{0};  ///< a pause after each byte
    std::optional<std::string> raw;        ///< sent instead of a response
};

struct ReceivedRequest {
    std::string target;
    std::map<std::string, std::string> headers;  ///< names in lower case
    std::string body;
};

class ChatServer {
  public:
    using Handler = std::function<Reaction(const ReceivedRequest&, std::size_t number)>;

    /// Listens on a free port of 127.0.0.1. With `secure`, TLS with a certificate of its own for
    /// `certified_host`.
    explicit ChatServer(Handler handler, bool secure = false,
                        const std::string& certified_host = "localhost");
    ~ChatServer();

    /// "http://127.0.0.1:PORT/v1", or "https://localhost:PORT/v1".
    std::string base() const;
    std::string certificate() const;  ///< PEM; of a secure server
    std::vector<ReceivedRequest> requests() const;

  private:
    class Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// A successful response that says `text`.
inline Reaction says(const std::string& text, int prompt_tokens = 100, int completion_tokens = 20) {
    const nlohmann::json body = {
        {"id", "chat-1"},
        {"object", "chat.completion"},
        {"choices",
         {{{"index", 0},
           {"finish_reason", "stop"},
           {"message", {{"role", "assistant"}, {"content", text}}}}}},
        {"usage", {{"prompt_tokens", prompt_tokens}, {"completion_tokens", completion_tokens}}}};
    Reaction reaction;
    reaction.body = body.dump();
    return reaction;
}

inline Reaction fails(unsigned status, const std::string& body,
                      std::map<std::string, std::string> headers = {}) {
    Reaction reaction;
    reaction.status = status;
    reaction.body = body;
    reaction.headers = std::move(headers);
    return reaction;
}

/// A port on which nothing listens.
std::uint16_t closed_port();

}  // namespace praxis::test
