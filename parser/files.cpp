#include "parser/files.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <system_error>

#include "parser/diagnostic.hpp"

namespace praxis {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestSource = std::numeric_limits<std::uint32_t>::max() - 1;

std::string read_all(std::FILE* file, const std::string& name) {
    std::string text;
    std::size_t used = 0;
    do {
        text.resize(used + std::max<std::size_t>(std::size_t{1} << 16, used));
        used += std::fread(text.data() + used, 1, text.size() - used, file);
        if (used > kLargestSource) fail_unplaced(name + ": larger than 4 GiB");
    } while (used == text.size());
    if (std::ferror(file) != 0) fail_unplaced(name + ": cannot be read");
    text.resize(used);
    return text;
}

}  // namespace

void fail_unplaced(const std::string& message) {
    Diagnostic diagnostic;
    diagnostic.placed = false;
    diagnostic.message = message;
    throw InputError(to_string(diagnostic, {}), {diagnostic});
}

Source read_source(const std::string& file_name) {
    if (file_name == "-") return {"<stdin>", read_all(stdin, "<stdin>")};
    std::error_code error;
    if (fs::is_directory(file_name, error)) fail_unplaced(file_name + ": is a directory, not a file");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(file_name.c_str(), "rb"),
                                                               &std::fclose);
    if (!file) fail_unplaced(file_name + ": cannot be opened (" + std::strerror(errno) + ")");
    return {file_name, read_all(file.get(), file_name)};
}

void require_text(const Source& source) {
    if (source.text.size() > kLargestSource) fail_unplaced(source.name + ": larger than 4 GiB");
    if (source.text.find_first_not_of(" \t\r\n\v\f") == std::string::npos) {
        fail_unplaced(source.name + ": is empty");
    }
}

}  // namespace praxis
