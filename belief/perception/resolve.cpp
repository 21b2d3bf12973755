#include <utility>  // boost 1.74's asio forgets it

#include "belief/perception/resolve.hpp"

#include <netdb.h>
#include <sys/socket.h>

#include <algorithm>
#include <boost/asio/ip/address.hpp>
#include <condition_variable>
#include <cstring>
#include <memory>
#include <mutex>
#include <thread>

#include "belief/perception/http.hpp"

namespace praxis::belief {
namespace {

using boost::asio::ip::tcp;

struct Lookup {
    std::mutex mutex;
    std::condition_variable_any finished;
    bool done = false;
    int error = 0;
    std::vector<tcp::endpoint> endpoints;
};

void look_up(const std::string& host, const std::string& port, Lookup& lookup) {
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* list = nullptr;
    const int error = ::getaddrinfo(host.c_str(), port.c_str(), &hints, &list);
    const std::lock_guard lock(lookup.mutex);
    lookup.error = error;
    for (const addrinfo* entry = error == 0 ? list : nullptr; entry != nullptr; entry = entry->ai_next) {
        tcp::endpoint endpoint;
        if (entry->ai_addrlen > endpoint.capacity()) continue;
        std::memcpy(endpoint.data(), entry->ai_addr, entry->ai_addrlen);
        endpoint.resize(entry->ai_addrlen);
        lookup.endpoints.push_back(endpoint);
    }
    if (error == 0) ::freeaddrinfo(list);
    lookup.done = true;
    lookup.finished.notify_all();
}

}  // namespace

std::vector<tcp::endpoint> resolve(const std::string& host, const std::string& port,
                                   std::chrono::steady_clock::time_point deadline,
                                   const std::stop_token& stop) {
    boost::system::error_code not_an_address;
    const auto address = boost::asio::ip::make_address(host, not_an_address);
    if (!not_an_address) return {tcp::endpoint(address, static_cast<std::uint16_t>(std::stoul(port)))};

    const auto lookup = std::make_shared<Lookup>();
    std::thread([lookup, host, port] { look_up(host, port, *lookup); }).detach();
    std::unique_lock lock(lookup->mutex);
    lookup->finished.wait_until(lock, stop, deadline, [&] { return lookup->done; });
    if (stop.stop_requested()) throw StoppedError();
    if (!lookup->done) throw HttpError("looking up '" + host + "' took too long", true);
    if (lookup->error != 0) {
        throw HttpError("cannot find the host '" + host + "': " + ::gai_strerror(lookup->error),
                        lookup->error == EAI_AGAIN);
    }
    return lookup->endpoints;
}

}  // namespace praxis::belief
