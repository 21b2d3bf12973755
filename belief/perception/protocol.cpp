#include "belief/perception/protocol.hpp"

#include <time.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "belief/perception/encode.hpp"

namespace praxis::belief {
namespace {

using Json = nlohmann::json;

Json content_of(const Message& message) {
    if (message.images.empty()) return message.text;
    Json parts = Json::array({{{"type", "text"}, {"text", message.text}}});
    for (const std::string& image : message.images) {
        parts.push_back({{"type", "image_url"}, {"image_url", {{"url", image_address(image)}}}});
    }
    return parts;
}

/// `content` is a text, or a list of parts of which some are texts.
std::optional<std::string> text_of(const Json& content) {
    if (content.is_string()) return content.get<std::string>();
    if (!content.is_array()) return std::nullopt;
    std::string text;
    for (const Json& part : content) {
        if (!part.is_object()) return std::nullopt;
        const auto found = part.find("text");
        if (found != part.end() && found->is_string()) text += found->get<std::string>();
    }
    return text;
}

std::int64_t count_in(const Json& usage, const char* name) {
    const auto found = usage.find(name);
    if (found == usage.end() || !found->is_number_integer()) return 0;
    return std::max<std::int64_t>(found->get<std::int64_t>(), 0);
}

std::string beginning(std::string_view text) {
    constexpr std::size_t kShown = 300;
    std::string shown(text.substr(0, kShown));
    for (char& c : shown) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
    }
    if (text.size() > kShown) shown += "...";
    return shown;
}

}  // namespace

std::string_view to_string(Role role) {
    switch (role) {
        case Role::system:
            return "system";
        case Role::assistant:
            return "assistant";
        case Role::user:
            break;
    }
    return "user";
}

std::string write_chat_request(const VisionModelOptions& options, const std::vector<Message>& messages) {
    Json request = Json::object();
    if (!options.more.empty()) {
        request = Json::parse(options.more, nullptr, false);
        if (!request.is_object()) {
            throw PerceptionError("the further members of a request must be a JSON object, not '" +
                                  beginning(options.more) + '\'');
        }
    }
    request["model"] = options.model;
    Json& list = request["messages"] = Json::array();
    for (const Message& message : messages) {
        list.push_back({{"role", to_string(message.role)}, {"content", content_of(message)}});
    }
    if (options.temperature) request["temperature"] = *options.temperature;
    if (options.json && !request.contains("response_format")) {
        request["response_format"] = {{"type", "json_object"}};
    }
    return request.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::optional<ChatAnswer> read_chat_response(const std::string& body, std::string& why) {
    const Json response = Json::parse(body, nullptr, false);
    if (response.is_discarded()) {
        why = "the answer is not JSON: " + beginning(body);
        return std::nullopt;
    }
    const Json* choice = nullptr;
    if (response.is_object() && response.contains("choices") && response["choices"].is_array() &&
        !response["choices"].empty()) {
        choice = &response["choices"].front();
    }
    const Json* message = nullptr;
    if (choice != nullptr && choice->is_object() && choice->contains("message") &&
        (*choice)["message"].is_object()) {
        message = &(*choice)["message"];
    }
    if (message == nullptr) {
        why = "the answer has no choices[0].message: " + beginning(body);
        return std::nullopt;
    }
    const auto refusal = message->find("refusal");
    if (refusal != message->end() && refusal->is_string() &&
        !refusal->get_ref<const std::string&>().empty()) {
        throw PerceptionError("the model refuses to answer: " +
                              beginning(refusal->get_ref<const std::string&>()));
    }
    const auto content = message->find("content");
    std::optional<std::string> text;
    if (content != message->end()) text = text_of(*content);
    if (!text) {
        why = "the answer has no text in choices[0].message.content: " + beginning(body);
        return std::nullopt;
    }
    ChatAnswer answer;
    answer.text = std::move(*text);
    const auto reason = choice->find("finish_reason");
    answer.cut_off = reason != choice->end() && *reason == "length";
    const auto usage = response.find("usage");
    if (usage != response.end() && usage->is_object()) {
        answer.prompt_tokens = count_in(*usage, "prompt_tokens");
        answer.completion_tokens = count_in(*usage, "completion_tokens");
    }
    return answer;
}

std::string error_message(const std::string& body) {
    const Json response = Json::parse(body, nullptr, false);
    if (response.is_object() && response.contains("error")) {
        const Json& error = response["error"];
        if (error.is_string()) return beginning(error.get_ref<const std::string&>());
        if (error.is_object() && error.contains("message") && error["message"].is_string()) {
            return beginning(error["message"].get_ref<const std::string&>());
        }
    }
    return beginning(body);
}

std::optional<std::chrono::milliseconds> read_retry_after(const std::string& value,
                                                          std::chrono::system_clock::time_point now) {
    using std::chrono::milliseconds;
    constexpr std::int64_t kLongest = 1'000'000'000;  // seconds; more would not fit
    std::int64_t seconds = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), seconds);
    if (error == std::errc::result_out_of_range) return milliseconds(kLongest * 1000);
    if (error == std::errc() && end == value.data() + value.size()) {
        return milliseconds(std::clamp<std::int64_t>(seconds, 0, kLongest) * 1000);
    }
    tm date{};
    const char* rest = ::strptime(value.c_str(), "%a, %d %b %Y %H:%M:%S GMT", &date);
    if (rest == nullptr || *rest != '\0') return std::nullopt;
    const auto then = std::chrono::system_clock::from_time_t(::timegm(&date));
    const auto pause = std::chrono::duration_cast<milliseconds>(then - now);
    return std::max(pause, milliseconds(0));
}

}  // namespace praxis::belief
