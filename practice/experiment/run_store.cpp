#include "practice/experiment/run_store.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>

#include "parser/files.hpp"
#include "practice/experiment/run_json.hpp"
#include "search/text/output.hpp"

namespace praxis::practice {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".json";

bool plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

std::string encoded(std::string_view name) {
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string result;
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        result += plain(c) ? std::string{c} : std::string{'%', kDigits[byte / 16], kDigits[byte % 16]};
    }
    return result;
}

std::string decoded(std::string_view text) {
    std::string result;
    for (std::size_t at = 0; at < text.size(); ++at) {
        unsigned byte = static_cast<unsigned char>(text[at]);
        if (text[at] == '%' && at + 2 < text.size()) {
            std::from_chars(text.data() + at + 1, text.data() + at + 3, byte, 16);
            at += 2;
        }
        result += static_cast<char>(byte);
    }
    return result;
}

std::string file_name(const RunKey& key) {
    return encoded(key.environment) + "." + encoded(key.method) + "." + std::to_string(key.seed) +
           std::string(kEnding);
}

/// The run that a file of this name holds, if it is a name that `file_name` makes.
std::optional<RunKey> key_of(const std::string& name) {
    std::string_view rest = name;
    if (!rest.ends_with(kEnding)) return std::nullopt;
    rest.remove_suffix(kEnding.size());
    const std::size_t first = rest.find('.'), second = rest.rfind('.');
    if (first == std::string_view::npos || first == second) return std::nullopt;
    RunKey key{decoded(rest.substr(0, first)), decoded(rest.substr(first + 1, second - first - 1)), 0};
    std::from_chars(rest.data() + second + 1, rest.data() + rest.size(), key.seed);
    if (file_name(key) != name) return std::nullopt;
    return key;
}

}  // namespace

RunStore::RunStore(std::string directory, std::string fingerprint)
    : directory_(std::move(directory)), fingerprint_(std::move(fingerprint)) {
    std::error_code error;
    fs::create_directories(directory_, error);
    if (!fs::is_directory(directory_))
        throw OutputError("cannot make the directory '" + directory_ + "'" +
                          (error ? ": " + error.message() : ""));
}

std::string RunStore::path(const RunKey& key) const {
    return (fs::path(directory_) / file_name(key)).string();
}

bool RunStore::contains(const RunKey& key) const {
    std::error_code error;
    return fs::is_regular_file(path(key), error);
}

std::vector<RunKey> RunStore::finished() const {
    std::vector<RunKey> keys;
    std::error_code error;
    for (fs::directory_iterator entry(directory_, error), end; !error && entry != end; entry.increment(error))
        if (const auto key = key_of(entry->path().filename().string()); key && contains(*key))
            keys.push_back(*key);
    if (error) fail_unplaced(directory_ + ": cannot be read (" + error.message() + ")");
    std::sort(keys.begin(), keys.end());
    return keys;
}

RunResult RunStore::load(const RunKey& key) const {
    const std::string name = path(key);
    StoredRun stored = read_run(read_source(name));
    RunResult& run = stored.run;
    if (RunKey{run.environment, run.method, run.seed} != key)
        fail_unplaced(name + ": holds another run: " + run.method + " in " + run.environment + " with seed " +
                      std::to_string(run.seed) + "; remove the file to run it again");
    if (stored.fingerprint != fingerprint_)
        fail_unplaced(name + ": was made with other settings\n  then: " + stored.fingerprint + "\n  now:  " +
                      fingerprint_ + "\nuse another directory, or remove the file to run it again");
    return std::move(run);
}

std::vector<RunResult> RunStore::load_all() const {
    std::vector<RunResult> runs;
    for (const RunKey& key : finished()) runs.push_back(load(key));
    return runs;
}

void RunStore::save(const RunResult& run) const {
    write_file(path({run.environment, run.method, run.seed}), run_to_json({run, fingerprint_}));
}

}  // namespace praxis::practice
