// Conversations on disk: what a model said is remembered, one JSON object a line, and said again without it.
//
// A question's key is the SHA-256 of the model's name and of all messages with the bytes of their images; the
// file holds the texts, and the images as their hashes, so that it can be read and compared. Tests and
// repeated experiments run from such a file without a network and without cost.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "belief/perception/chat.hpp"

namespace praxis::belief {

enum class RecordMode : std::uint8_t {
    record,  ///< every question goes to the model; its answers are added to the file
    cache,   ///< known questions are answered from the file, others go to the model and are added
    replay,  ///< all from the file; a question that it does not have is an error
};

class RecordedModel : public ChatModel {
  public:
    /// `model` is needed unless all is replayed; it must outlive this. Throws PerceptionError if the file
    /// cannot be read or written, or has a line that is none of ours (a last line that was cut off is
    /// dropped).
    RecordedModel(std::filesystem::path file, RecordMode mode, std::string model_name,
                  ChatModel* model = nullptr);

    std::string name() const override { return name_; }
    /// In replay, a question asked again gets its next recorded answer, and the last one from then on. May be
    /// called from several threads.
    ChatAnswer ask(const std::vector<Message>& messages, std::stop_token stop) override;

    std::int64_t replayed() const;  ///< answers from the file
    std::int64_t recorded() const;  ///< answers added to it

  private:
    struct Entry {
        std::vector<ChatAnswer> answers;
        std::size_t next = 0;
    };
    void read();
    void append(const std::string& key, const std::vector<Message>& messages, const ChatAnswer& answer);

    std::filesystem::path file_;
    RecordMode mode_;
    std::string name_;
    ChatModel* model_;
    mutable std::mutex mutex_;  ///< guards what follows
    std::unordered_map<std::string, Entry> entries_;
    std::ofstream out_;
    std::int64_t replayed_ = 0;
    std::int64_t recorded_ = 0;
};

/// 64 hexadecimal digits: equal for equal questions to the same model.
std::string question_key(const std::string& model, const std::vector<Message>& messages);

}  // namespace praxis::belief
