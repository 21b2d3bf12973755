// Helpers of the tests of perception.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "belief/perception/chat.hpp"

namespace praxis::test {

/// A model that is a function.
class FunctionModel : public belief::ChatModel {
  public:
    using Function = std::function<std::string(const std::vector<belief::Message>&)>;
    explicit FunctionModel(Function function) : function_(std::move(function)) {}
    std::string name() const override { return "function"; }
    belief::ChatAnswer ask(const std::vector<belief::Message>& messages, std::stop_token) override {
        ++asked;
        return {function_(messages), false, 10, 5};
    }
    int asked = 0;

  private:
    Function function_;
};

/// A file of this test's own, removed at the end.
class TemporaryFile {
  public:
    TemporaryFile() {
        std::string name = (std::filesystem::temp_directory_path() / "praxis-XXXXXX").string();
        ::close(::mkstemp(name.data()));
        path_ = name;
    }
    ~TemporaryFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    void write(const std::string& text) const { std::ofstream(path_, std::ios::binary) << text; }
    std::string read() const {
        std::ostringstream text;
        text << std::ifstream(path_, std::ios::binary).rdbuf();
        return text.str();
    }

  private:
    std::filesystem::path path_;
};

/// The message of the PerceptionError that `action` throws; empty if it throws none.
template <class Action>
std::string perception_error(Action action) {
    try {
        action();
    } catch (const belief::PerceptionError& error) {
        return error.what();
    }
    return {};
}

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// The smallest thing that begins as a PNG file does.
inline const std::string kPngHead = "\x89PNG\r\n\x1a\n";

}  // namespace praxis::test
