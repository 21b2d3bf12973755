#include "learned/weights/array_file.hpp"

#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "parser/diagnostic.hpp"

namespace praxis::learned {
namespace {

constexpr std::string_view kMagic = "PRAXISNN";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kFixed = 16, kChecksum = 8;

static_assert(std::endian::native == std::endian::little,
              "weights are read and written as they lie in memory");

std::uint64_t checksum(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char byte : bytes) hash = (hash ^ static_cast<std::uint8_t>(byte)) * 0x100000001b3u;
    return hash;
}

template <class T>
void append(std::string& bytes, T number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

template <class T>
T number_at(std::string_view bytes, std::size_t at) {
    T number;
    std::memcpy(&number, bytes.data() + at, sizeof(number));
    return number;
}

[[noreturn]] void fail(const std::string& file, const std::string& what) {
    throw InputError(file + ": error: " + what + "\n");
}

}  // namespace

const std::vector<float>& ArrayFile::array(const std::string& name, const std::string& file) const {
    for (const auto& [known, values] : arrays)
        if (known == name) return values;
    fail(file, "the array '" + name + "' is missing");
}

void write_array_file(const std::string& file, const ArrayFile& contents) {
    nlohmann::json header = contents.header;
    header["arrays"] = nlohmann::json::array();
    for (const auto& [name, values] : contents.arrays)
        header["arrays"].push_back(nlohmann::json::array({name, values.size()}));
    const std::string text = header.dump();
    std::string bytes(kMagic);
    append(bytes, kVersion);
    append(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += text;
    for (const auto& [name, values] : contents.arrays)
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    append(bytes, checksum(bytes));
    const std::string unfinished = file + ".part";
    {
        std::ofstream stream(unfinished, std::ios::binary);
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        stream.flush();
        if (!stream) fail(file, "cannot be written");
    }
    std::error_code error;
    std::filesystem::rename(unfinished, file, error);
    if (error) fail(file, "cannot be written: " + error.message());
}

ArrayFile read_array_file(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) fail(file, "cannot be opened");
    const std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    return parse_array_file(bytes, file);
}

ArrayFile parse_array_file(std::string_view bytes, const std::string& file) {
    if (bytes.substr(0, kMagic.size()) != kMagic)
        fail(file, "is not a file of weights (it does not start with PRAXISNN)");
    if (bytes.size() < kFixed + kChecksum) fail(file, "is cut off");
    const auto version = number_at<std::uint32_t>(bytes, 8);
    if (version != kVersion)
        fail(file, "has version " + std::to_string(version) + ", this program reads version " +
                       std::to_string(kVersion));
    const std::size_t length = number_at<std::uint32_t>(bytes, 12);
    if (length > bytes.size() - kFixed - kChecksum) fail(file, "is cut off: its header does not fit");
    ArrayFile result;
    result.header = nlohmann::json::parse(bytes.substr(kFixed, length), nullptr, false);
    if (!result.header.is_object() || !result.header.contains("arrays") ||
        !result.header["arrays"].is_array())
        fail(file, "has a header that is not a JSON object with a list of arrays");
    std::size_t at = kFixed + length;
    const std::size_t end = bytes.size() - kChecksum;
    for (const nlohmann::json& entry : result.header["arrays"]) {
        if (!entry.is_array() || entry.size() != 2 || !entry[0].is_string() || !entry[1].is_number_unsigned())
            fail(file, "has a header whose list of arrays is not made of [name, length]");
        const auto count = entry[1].get<std::uint64_t>();
        if (count > (end - at) / sizeof(float))
            fail(file, "is cut off: the array '" + entry[0].get<std::string>() + "' does not fit");
        std::vector<float> values(count);
        if (count) std::memcpy(values.data(), bytes.data() + at, count * sizeof(float));
        at += count * sizeof(float);
        result.arrays.emplace_back(entry[0].get<std::string>(), std::move(values));
    }
    if (at != end) fail(file, "has " + std::to_string(end - at) + " bytes more than its header says");
    if (checksum(bytes.substr(0, end)) != number_at<std::uint64_t>(bytes, end))
        fail(file, "was changed since it was written (its checksum does not agree)");
    return result;
}

}  // namespace praxis::learned
