// One HTTP(S) request, with limits. The protocol is Boost.Beast's, TLS is OpenSSL's; what is here is the
// time-out, the stop token and the limits on what may come back.
#pragma once

#include <chrono>
#include <cstddef>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "belief/perception/errors.hpp"

namespace praxis::belief {

/// "https://host:8080/v1" in its parts.
struct Url {
    bool secure = false;  ///< https
    std::string host;     ///< without the brackets of an IPv6 address
    std::string port;     ///< "80" or "443" where none is written
    std::string path;     ///< "" or "/v1": no final slash

    /// Throws PerceptionError, naming the text, unless it is http:// or https:// with a host, and a port from
    /// 1 to 65535 if any. User names, queries and fragments are refused.
    static Url parse(std::string_view text);

    /// The host as the Host header has it.
    std::string authority() const;
};

struct HttpRequest {
    Url url;           ///< of the service
    std::string path;  ///< appended to that of the service
    std::vector<std::pair<std::string, std::string>> headers;
    std::string body;
};

struct HttpLimits {
    std::chrono::milliseconds timeout{60000};  ///< from looking up the host to the last byte of the answer
    std::size_t answer_bytes = 8U << 20U;      ///< of the body
    std::string certificates;                  ///< a PEM file of authorities trusted besides the system's
};

struct HttpResponse {
    unsigned status = 0;
    std::string retry_after;  ///< the header's value; empty if there is none
    std::string body;
};

/// There was no answer.
class HttpError : public PerceptionError {
  public:
    HttpError(const std::string& message, bool transient) : PerceptionError(message), transient_(transient) {}
    /// Asking again may help: the connection failed, was cut off, or took too long.
    bool transient() const { return transient_; }

  private:
    bool transient_;
};

/// POSTs and waits for the answer. Connections are not kept. Throws HttpError, or StoppedError as soon as
/// `stop` asks (in milliseconds, whatever the network does).
HttpResponse http_post(const HttpRequest& request, const HttpLimits& limits, const std::stop_token& stop);

}  // namespace praxis::belief
