#include "app/output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace praxis::app {
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

void remove_regular(const std::string& path) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode)) ::unlink(path.c_str());
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

bool same_file(const std::string& a, const std::string& b) {
    struct stat first {};
    struct stat second {};
    return ::stat(a.c_str(), &first) == 0 && ::stat(b.c_str(), &second) == 0 &&
           first.st_dev == second.st_dev && first.st_ino == second.st_ino;
}

PlanFiles::PlanFiles(std::string path) : path_(std::move(path)) {
    if (path_.empty() || path_ == "-") return;
    remove_regular(path_);
    for (int i = 1;; ++i) {
        const std::string numbered = path_ + "." + std::to_string(i);
        if (::access(numbered.c_str(), F_OK) != 0) break;
        remove_regular(numbered);
        if (::access(numbered.c_str(), F_OK) == 0) break;
    }
}

void PlanFiles::write(const std::string& text) {
    if (path_.empty()) return;
    ++count_;
    if (count_ == 1) first_ = text;
    if (count_ == 2) write_file(path_ + ".1", first_);
    if (count_ >= 2) write_file(path_ + "." + std::to_string(count_), text);
    write_file(path_, text);
}

}  // namespace praxis::app
