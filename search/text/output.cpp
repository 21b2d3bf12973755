#include "search/text/output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace praxis {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
    throw OutputError("cannot write '" + path + "': " + std::strerror(error));
}

/// 0 or the error.
int write_all(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

bool replaceable(const std::string& path) {
    struct stat status {};
    return ::lstat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode);
}

}  // namespace

void write_standard_output(std::string_view text) {
    if (const int error = write_all(STDOUT_FILENO, text)) fail("standard output", error);
}

void write_file(const std::string& path, std::string_view text) {
    if (path == "-") return write_standard_output(text);
    const bool replace = replaceable(path);
    const std::string target = replace ? path + ".part" + std::to_string(::getpid()) : path;
    const int descriptor = ::open(target.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(path, errno);
    int error = write_all(descriptor, text);
    if (::close(descriptor) != 0 && error == 0) error = errno;
    if (replace && error == 0 && ::rename(target.c_str(), path.c_str()) != 0) error = errno;
    if (error == 0) return;
    if (replace) ::unlink(target.c_str());
    fail(path, error);
}

}  // namespace praxis
