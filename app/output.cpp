#include "app/output.hpp"

#include <sys/stat.h>
#include <unistd.h>

namespace praxis::app {
namespace {

void remove_regular(const std::string& path) {
    struct stat status {};
    if (::lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode)) ::unlink(path.c_str());
}

}  // namespace

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
