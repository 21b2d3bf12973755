#include <algorithm>
#include <charconv>

#include "belief/perception/http.hpp"

namespace praxis::belief {
namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
    throw PerceptionError("unusable address '" + std::string(text) + "': " + why);
}

bool is_printable(char c) {
    return c > ' ' && c < '\x7f';
}

}  // namespace

Url Url::parse(std::string_view text) {
    Url url;
    std::string_view rest = text;
    if (rest.starts_with("https://")) {
        url.secure = true;
        rest.remove_prefix(8);
    } else if (rest.starts_with("http://")) {
        rest.remove_prefix(7);
    } else {
        refuse(text, "it must start with http:// or https://");
    }
    if (!std::ranges::all_of(rest, is_printable))
        refuse(text, "there is a blank or an unprintable character in it");
    if (rest.find_first_of("?#") != std::string_view::npos)
        refuse(text, "queries and fragments are not supported");

    const std::size_t slash = std::min(rest.find('/'), rest.size());
    std::string_view authority = rest.substr(0, slash);
    std::string_view path = rest.substr(slash);
    while (path.ends_with('/')) path.remove_suffix(1);
    url.path = path;
    if (authority.find('@') != std::string_view::npos) refuse(text, "give keys in an environment variable");

    std::string_view port;
    if (authority.starts_with('[')) {
        const std::size_t close = authority.find(']');
        if (close == std::string_view::npos) refuse(text, "']' is missing");
        url.host = authority.substr(1, close - 1);
        port = authority.substr(close + 1);
    } else {
        const std::size_t colon = std::min(authority.find(':'), authority.size());
        url.host = authority.substr(0, colon);
        port = authority.substr(colon);
    }
    if (url.host.empty()) refuse(text, "there is no host");
    url.port = url.secure ? "443" : "80";
    if (port.empty()) return url;
    port.remove_prefix(port.starts_with(':') ? 1 : 0);
    unsigned number = 0;
    const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), number);
    if (error != std::errc() || end != port.data() + port.size() || number == 0 || number > 65535) {
        refuse(text, "the port must be a number from 1 to 65535");
    }
    url.port = std::to_string(number);
    return url;
}

std::string Url::authority() const {
    std::string text = host.find(':') == std::string::npos ? host : '[' + host + ']';
    if (port != (secure ? "443" : "80")) text += ':' + port;
    return text;
}

}  // namespace praxis::belief
