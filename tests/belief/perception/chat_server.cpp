#include <utility>  // boost 1.74's asio forgets it

#include "tests/belief/perception/chat_server.hpp"

#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>
#include <sys/socket.h>

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http.hpp>
#include <condition_variable>
#include <list>
#include <mutex>
#include <set>
#include <thread>

namespace praxis::test {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using asio::ip::tcp;
using boost::system::error_code;

std::string text_of(BIO* bio) {
    char* data = nullptr;
    const long length = BIO_get_mem_data(bio, &data);
    std::string text(data, static_cast<std::size_t>(length));
    BIO_free(bio);
    return text;
}

/// A key and a certificate that signs itself, both as PEM.
std::pair<std::string, std::string> make_certificate(const std::string& host) {
    EVP_PKEY* key = EVP_EC_gen("P-256");
    X509* certificate = X509_new();
    X509_set_version(certificate, 2);
    ASN1_INTEGER_set(X509_get_serialNumber(certificate), 1);
    X509_gmtime_adj(X509_getm_notBefore(certificate), -3600);
    X509_gmtime_adj(X509_getm_notAfter(certificate), 3600);
    X509_set_pubkey(certificate, key);
    X509_NAME* name = X509_get_subject_name(certificate);
    X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_ASC, reinterpret_cast<const unsigned char*>(host.c_str()),
                               -1, -1, 0);
    X509_set_issuer_name(certificate, name);
    X509V3_CTX context;
    X509V3_set_ctx(&context, certificate, certificate, nullptr, nullptr, 0);
    X509_EXTENSION* extension =
        X509V3_EXT_conf_nid(nullptr, &context, NID_subject_alt_name, ("DNS:" + host).c_str());
    X509_add_ext(certificate, extension, -1);
    X509_EXTENSION_free(extension);
    X509_sign(certificate, key, EVP_sha256());
    BIO* key_text = BIO_new(BIO_s_mem());
    PEM_write_bio_PrivateKey(key_text, key, nullptr, nullptr, 0, nullptr, nullptr);
    BIO* certificate_text = BIO_new(BIO_s_mem());
    PEM_write_bio_X509(certificate_text, certificate);
    X509_free(certificate);
    EVP_PKEY_free(key);
    return {text_of(key_text), text_of(certificate_text)};
}

std::string response_text(const Reaction& reaction) {
    if (reaction.raw) return *reaction.raw;
    std::string text = "HTTP/1.1 " + std::to_string(reaction.status) + " Status\r\n";
    for (const auto& [name, value] : reaction.headers) text += name + ": " + value + "\r\n";
    text += "Content-Type: application/json\r\nContent-Length: " + std::to_string(reaction.body.size());
    return text + "\r\nConnection: close\r\n\r\n" + reaction.body;
}

}  // namespace

class ChatServer::Implementation {
  public:
    Implementation(Handler handler, bool secure, const std::string& host)
        : handler_(std::move(handler)),
          secure_(secure),
          acceptor_(context_, tcp::endpoint(asio::ip::address_v4::loopback(), 0)) {
        port_ = acceptor_.local_endpoint().port();
        if (secure_) {
            const auto [key, certificate] = make_certificate(host);
            certificate_ = certificate;
            security_.use_certificate_chain(asio::buffer(certificate));
            security_.use_private_key(asio::buffer(key), asio::ssl::context::pem);
        }
        acceptance_ = std::thread([this] { accept(); });
    }

    ~Implementation() {
        {
            const std::lock_guard lock(mutex_);
            stopping_ = true;
            for (const int socket : open_) ::shutdown(socket, SHUT_RDWR);
            ::shutdown(acceptor_.native_handle(), SHUT_RDWR);
        }
        wake_.notify_all();
        acceptance_.join();
        for (std::thread& thread : connections_) thread.join();
    }

    std::string base() const {
        return (secure_ ? "https://localhost:" : "http://127.0.0.1:") + std::to_string(port_) + "/v1";
    }
    const std::string& certificate() const { return certificate_; }
    std::vector<ReceivedRequest> requests() const {
        const std::lock_guard lock(mutex_);
        return requests_;
    }

  private:
    void accept() {
        for (;;) {
            auto socket = std::make_shared<tcp::socket>(context_);
            error_code error;
            acceptor_.accept(*socket, error);
            const std::lock_guard lock(mutex_);
            if (stopping_ || error) return;
            open_.insert(socket->native_handle());
            connections_.emplace_back([this, socket] {
                serve(*socket);
                const std::lock_guard done(mutex_);
                open_.erase(socket->native_handle());
                error_code ignored;
                socket->close(ignored);
            });
        }
    }

    void serve(tcp::socket& socket) {
        if (!secure_) return converse(socket);
        asio::ssl::stream<tcp::socket&> stream(socket, security_);
        error_code error;
        stream.handshake(asio::ssl::stream_base::server, error);
        if (!error) converse(stream);
    }

    template <class Stream>
    void converse(Stream& stream) {
        boost::beast::flat_buffer buffer;
        http::request_parser<http::string_body> parser;
        parser.body_limit(64U << 20U);
        error_code error;
        http::read(stream, buffer, parser, error);
        if (error) return;
        ReceivedRequest request;
        request.target = std::string(parser.get().target());
        for (const auto& field : parser.get()) {
            std::string name(field.name_string());
            for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            request.headers[name] = std::string(field.value());
        }
        request.body = parser.get().body();
        std::size_t number = 0;
        {
            const std::lock_guard lock(mutex_);
            number = requests_.size();
            requests_.push_back(request);
        }
        const Reaction reaction = handler_(request, number);
        if (!wait(reaction.delay)) return;
        std::string text = response_text(reaction);
        if (reaction.cut_at) text.resize(std::min(*reaction.cut_at, text.size()));
        if (reaction.trickle.count() == 0) {
            asio::write(stream, asio::buffer(text), error);
            return;
        }
        for (const char& c : text) {
            asio::write(stream, asio::buffer(&c, 1), error);
            if (error || !wait(reaction.trickle)) return;
        }
    }

    /// False if the server is to end.
    bool wait(std::chrono::milliseconds length) {
        std::unique_lock lock(mutex_);
        return !wake_.wait_for(lock, length, [this] { return stopping_; });
    }

    Handler handler_;
    bool secure_;
    std::string certificate_;
    asio::io_context context_;
    asio::ssl::context security_{asio::ssl::context::tls_server};
    tcp::acceptor acceptor_;
    std::uint16_t port_ = 0;
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    bool stopping_ = false;
    std::set<int> open_;
    std::vector<ReceivedRequest> requests_;
    std::list<std::thread> connections_;
    std::thread acceptance_;
};

ChatServer::ChatServer(Handler handler, bool secure, const std::string& certified_host)
    : implementation_(std::make_unique<Implementation>(std::move(handler), secure, certified_host)) {}
ChatServer::~ChatServer() = default;
std::string ChatServer::base() const {
    return implementation_->base();
}
std::string ChatServer::certificate() const {
    return implementation_->certificate();
}
std::vector<ReceivedRequest> ChatServer::requests() const {
    return implementation_->requests();
}

std::uint16_t closed_port() {
    asio::io_context context;
    const tcp::acceptor acceptor(context, tcp::endpoint(asio::ip::address_v4::loopback(), 0));
    return acceptor.local_endpoint().port();
}

}  // namespace praxis::test
