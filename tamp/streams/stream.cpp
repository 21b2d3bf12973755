#include "tamp/streams/stream.hpp"

#include <cctype>
#include <cmath>
#include <utility>

namespace praxis::tamp {
namespace {

std::string lower(std::string_view name) {
    std::string result(name);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

}  // namespace

std::string_view to_string(Reason reason) {
    switch (reason) {
        case Reason::collision:
            return "collision";
        case Reason::kinematics:
            return "kinematics";
        case Reason::no_path:
            return "no path";
        case Reason::other:
            break;
    }
    return "other";
}

void StreamLibrary::bind(std::string_view stream, StreamCallback callback, const StreamInfo& info) {
    const std::string name = lower(stream);
    if (!callback) throw std::invalid_argument("stream '" + name + "': the callback is empty");
    if (!(info.effort > 0) || !std::isfinite(info.effort))
        throw std::invalid_argument("stream '" + name + "': the effort must be a positive number");
    if (info.max_samples == 0 || info.max_attempts == 0)
        throw std::invalid_argument("stream '" + name + "': max_samples and max_attempts must be positive");
    streams_[name] = {std::move(callback), info};
}

void StreamLibrary::bind_function(std::string_view function, FunctionCallback callback, double lower_bound) {
    const std::string name = lower(function);
    if (!callback) throw std::invalid_argument("function '" + name + "': the callback is empty");
    if (!(lower_bound >= 0) || !std::isfinite(lower_bound))
        throw std::invalid_argument("function '" + name +
                                    "': the lower bound must be a number that is not negative");
    functions_[name] = {std::move(callback), lower_bound};
}

const StreamLibrary::BoundStream* StreamLibrary::find(std::string_view stream) const {
    const auto found = streams_.find(lower(stream));
    return found == streams_.end() ? nullptr : &found->second;
}

const StreamLibrary::BoundFunction* StreamLibrary::find_function(std::string_view function) const {
    const auto found = functions_.find(lower(function));
    return found == functions_.end() ? nullptr : &found->second;
}

std::vector<std::string> StreamLibrary::stream_names() const {
    std::vector<std::string> names;
    for (const auto& [name, stream] : streams_) names.push_back(name);
    return names;
}

}  // namespace praxis::tamp
