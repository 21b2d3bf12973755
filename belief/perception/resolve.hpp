// Looking up a host's addresses so that the caller can stop waiting: the system's resolver cannot be
// interrupted, so it runs on a thread of its own that is left behind where it takes too long.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <stop_token>
#include <string>
#include <vector>

namespace praxis::belief {

/// Addresses in the system's order. Throws HttpError (unknown host, time-out) or StoppedError.
std::vector<boost::asio::ip::tcp::endpoint> resolve(const std::string& host, const std::string& port,
                                                    std::chrono::steady_clock::time_point deadline,
                                                    const std::stop_token& stop);

}  // namespace praxis::belief
