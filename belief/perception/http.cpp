#include <utility>  // boost 1.74's asio forgets it

#include "belief/perception/http.hpp"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/host_name_verification.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <functional>

#include "belief/perception/resolve.hpp"

namespace praxis::belief {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using asio::ip::tcp;
using boost::system::error_code;

/// Runs one asynchronous step after the other, each until it ends, time is up or a stop is asked for. Streams
/// that use `context` must be destroyed before it: a step that was given up is then dropped with its handler.
class Steps {
  public:
    Steps(std::chrono::milliseconds timeout, const std::stop_token& stop)
        : deadline_(std::chrono::steady_clock::now() + timeout),
          stop_(stop),
          interrupt_(stop, [this] { context.stop(); }) {}

    asio::io_context context{1};

    std::chrono::steady_clock::time_point deadline() const { return deadline_; }

    /// `start` is given the handler to pass to an asynchronous operation.
    template <class Start>
    error_code run(Start start) {
        bool done = false;
        error_code result;
        start([&](const error_code& error, auto&&...) {
            result = error;
            done = true;
        });
        while (!done) {
            if (stop_.stop_requested()) throw StoppedError();
            if (std::chrono::steady_clock::now() >= deadline_) throw HttpError("no answer in time", true);
            context.run_one_until(deadline_);
        }
        return result;
    }

  private:
    std::chrono::steady_clock::time_point deadline_;
    std::stop_token stop_;
    asio::executor_work_guard<asio::io_context::executor_type> work_{context.get_executor()};
    std::stop_callback<std::function<void()>> interrupt_;
};

void require(const error_code& error, const HttpRequest& request, const char* what, bool transient = true) {
    if (!error) return;
    throw HttpError(std::string(what) + " '" + request.url.authority() + "' failed: " + error.message(),
                    transient);
}

void connect(Steps& steps, tcp::socket& socket, const HttpRequest& request, const std::stop_token& stop) {
    error_code error = asio::error::host_not_found;
    for (const tcp::endpoint& endpoint :
         resolve(request.url.host, request.url.port, steps.deadline(), stop)) {
        error_code ignored;
        socket.close(ignored);
        error = steps.run([&](auto handler) { socket.async_connect(endpoint, handler); });
        if (!error) break;
    }
    require(error, request, "connecting to");
    error_code ignored;
    socket.set_option(tcp::no_delay(true), ignored);
}

template <class Stream>
HttpResponse exchange(Steps& steps, Stream& stream, const HttpRequest& request, const HttpLimits& limits) {
    http::request<http::string_body> message(http::verb::post, request.url.path + request.path, 11);
    message.set(http::field::host, request.url.authority());
    message.set(http::field::connection, "close");
    for (const auto& [name, value] : request.headers) message.set(name, value);
    message.body() = request.body;
    message.prepare_payload();
    // A server may refuse a request before it has read all of it: what it says counts more than the broken
    // pipe.
    const error_code sent = steps.run([&](auto handler) { http::async_write(stream, message, handler); });

    boost::beast::flat_buffer buffer;
    http::response_parser<http::string_body> parser;
    parser.body_limit(limits.answer_bytes);
    // The header first: Beast 1.74 forgets to compare the length with the limit where it reads both in one
    // go.
    error_code received =
        steps.run([&](auto handler) { http::async_read_header(stream, buffer, parser, handler); });
    if (!received)
        received = steps.run([&](auto handler) { http::async_read(stream, buffer, parser, handler); });
    if (received == http::error::body_limit || received == http::error::header_limit) {
        throw HttpError("the answer of '" + request.url.authority() + "' is larger than " +
                            std::to_string(limits.answer_bytes) + " bytes",
                        false);
    }
    if (received) require(sent, request, "sending to");
    require(received, request, "reading from");

    HttpResponse response;
    response.status = parser.get().result_int();
    const auto retry_after = parser.get()[http::field::retry_after];
    response.retry_after.assign(retry_after.data(), retry_after.size());
    response.body = std::move(parser.get().body());
    return response;
}

HttpResponse exchange_securely(Steps& steps, const HttpRequest& request, const HttpLimits& limits,
                               const std::stop_token& stop) {
    asio::ssl::context security(asio::ssl::context::tls_client);
    error_code error;
    security.set_default_verify_paths(error);
    if (!limits.certificates.empty()) {
        security.load_verify_file(limits.certificates, error);
        if (error) {
            throw PerceptionError("cannot read the certificates '" + limits.certificates +
                                  "': " + error.message());
        }
    }
    SSL_CTX_set_min_proto_version(security.native_handle(), TLS1_2_VERSION);
    asio::ssl::stream<tcp::socket> stream(steps.context, security);
    stream.set_verify_mode(asio::ssl::verify_peer);
    stream.set_verify_callback(asio::ssl::host_name_verification(request.url.host));
    error_code not_an_address;
    asio::ip::make_address(request.url.host, not_an_address);
    if (not_an_address) {
        SSL_ctrl(stream.native_handle(), SSL_CTRL_SET_TLSEXT_HOSTNAME, TLSEXT_NAMETYPE_host_name,
                 const_cast<char*>(request.url.host.c_str()));
    }
    connect(steps, stream.next_layer(), request, stop);
    error = steps.run([&](auto handler) { stream.async_handshake(asio::ssl::stream_base::client, handler); });
    // A certificate that is refused once is refused again; a connection that breaks may not be.
    require(error, request, "the TLS handshake with", error.category() != asio::error::get_ssl_category());
    return exchange(steps, stream, request, limits);
}

}  // namespace

HttpResponse http_post(const HttpRequest& request, const HttpLimits& limits, const std::stop_token& stop) {
    if (stop.stop_requested()) throw StoppedError();
    Steps steps(limits.timeout, stop);
    if (request.url.secure) return exchange_securely(steps, request, limits, stop);
    tcp::socket socket(steps.context);
    connect(steps, socket, request, stop);
    return exchange(steps, socket, request, limits);
}

}  // namespace praxis::belief
