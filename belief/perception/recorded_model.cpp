#include "belief/perception/recorded_model.hpp"

#include <nlohmann/json.hpp>
#include <optional>

#include "belief/perception/encode.hpp"

namespace praxis::belief {
namespace {

using Json = nlohmann::json;

std::optional<std::pair<std::string, ChatAnswer>> read_line(const std::string& line) {
    const Json entry = Json::parse(line, nullptr, false);
    try {
        const Json& said = entry.at("answer");
        ChatAnswer answer;
        said.at("text").get_to(answer.text);
        said.at("cut_off").get_to(answer.cut_off);
        said.at("prompt_tokens").get_to(answer.prompt_tokens);
        said.at("completion_tokens").get_to(answer.completion_tokens);
        return std::pair(entry.at("key").get<std::string>(), std::move(answer));
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

}  // namespace

std::string question_key(const std::string& model, const std::vector<Message>& messages) {
    // Every part is preceded by its length, so that no two questions read the same.
    std::string text;
    const auto add = [&text](std::string_view part) {
        text += std::to_string(part.size());
        text += ':';
        text += part;
    };
    add(model);
    for (const Message& message : messages) {
        add(to_string(message.role));
        add(message.text);
        add(std::to_string(message.images.size()));
        for (const std::string& image : message.images) add(sha256(image));
    }
    return sha256(text);
}

RecordedModel::RecordedModel(std::filesystem::path file, RecordMode mode, std::string model_name,
                             ChatModel* model)
    : file_(std::move(file)), mode_(mode), name_(std::move(model_name)), model_(model) {
    if (model_ == nullptr && mode_ != RecordMode::replay) {
        throw PerceptionError("recording needs a model to ask");
    }
    read();
    if (mode_ == RecordMode::replay) return;
    out_.open(file_, std::ios::app | std::ios::binary);
    if (!out_) throw PerceptionError("cannot write '" + file_.string() + '\'');
}

void RecordedModel::read() {
    std::ifstream in(file_, std::ios::binary);
    if (!in) {
        std::error_code ignored;
        if (mode_ == RecordMode::replay || std::filesystem::exists(file_, ignored)) {
            throw PerceptionError("cannot read '" + file_.string() + '\'');
        }
        return;
    }
    std::string line;
    std::uintmax_t good = 0;
    bool open_line = false;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
        open_line = in.eof();
        auto entry = line.empty() ? std::nullopt : read_line(line);
        if (entry) {
            entries_[entry->first].answers.push_back(std::move(entry->second));
        } else if (open_line) {
            break;  // a recording that was killed leaves half a line
        } else if (!line.empty()) {
            throw PerceptionError(file_.string() + ':' + std::to_string(number) +
                                  ": this line is not an exchange; remove it");
        }
        good += line.size() + (open_line ? 0 : 1);
    }
    in.close();
    if (mode_ == RecordMode::replay) return;
    if (std::filesystem::file_size(file_) > good) {
        std::filesystem::resize_file(file_, good);
    } else if (open_line) {
        std::ofstream(file_, std::ios::app | std::ios::binary) << '\n';
    }
}

ChatAnswer RecordedModel::ask(const std::vector<Message>& messages, std::stop_token stop) {
    if (stop.stop_requested()) throw StoppedError();
    const std::string key = question_key(name_, messages);
    if (mode_ != RecordMode::record) {
        const std::lock_guard lock(mutex_);
        const auto found = entries_.find(key);
        if (found != entries_.end()) {
            Entry& entry = found->second;
            const ChatAnswer& answer = entry.answers[entry.next];
            if (mode_ == RecordMode::replay && entry.next + 1 < entry.answers.size()) ++entry.next;
            ++replayed_;
            return answer;
        }
        if (mode_ == RecordMode::replay) {
            throw PerceptionError("'" + file_.string() + "' has no answer of '" + name_ +
                                  "' to this question (key " + key.substr(0, 12) + "...); record it again");
        }
    }
    ChatAnswer answer = model_->ask(messages, stop);
    const std::lock_guard lock(mutex_);
    append(key, messages, answer);
    entries_[key].answers.push_back(answer);
    ++recorded_;
    return answer;
}

void RecordedModel::append(const std::string& key, const std::vector<Message>& messages,
                           const ChatAnswer& answer) {
    Json list = Json::array();
    for (const Message& message : messages) {
        Json images = Json::array();
        for (const std::string& image : message.images) images.push_back(sha256(image));
        list.push_back({{"role", to_string(message.role)}, {"text", message.text}, {"images", images}});
    }
    const Json entry = {{"key", key},
                        {"model", name_},
                        {"messages", list},
                        {"answer",
                         {{"text", answer.text},
                          {"cut_off", answer.cut_off},
                          {"prompt_tokens", answer.prompt_tokens},
                          {"completion_tokens", answer.completion_tokens}}}};
    out_ << entry.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n' << std::flush;
    if (!out_) throw PerceptionError("cannot write '" + file_.string() + '\'');
}

std::int64_t RecordedModel::replayed() const {
    const std::lock_guard lock(mutex_);
    return replayed_;
}

std::int64_t RecordedModel::recorded() const {
    const std::lock_guard lock(mutex_);
    return recorded_;
}

}  // namespace praxis::belief
