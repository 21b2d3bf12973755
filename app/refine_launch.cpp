#include "app/refine_launch.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "app/exit_code.hpp"

namespace praxis::app {

int launch_refine(int argc, char** argv) {
    std::error_code error;
    const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
    const std::string program = (self.parent_path() / "plan-refine").string();
    std::vector<char*> arguments = {argv[0]};
    for (int i = 2; i < argc; ++i) arguments.push_back(argv[i]);
    arguments.push_back(nullptr);
    execv(program.c_str(), arguments.data());
    if (errno == ENOENT) {
        std::fprintf(stderr,
                     "plan: error: this Praxis was built without task and motion planning: there is no %s "
                     "(set it up with './setup.sh --tamp')\n",
                     program.c_str());
        return kUnsupported;
    }
    std::fprintf(stderr, "plan: error: cannot run %s: %s\n", program.c_str(), std::strerror(errno));
    return kInternalError;
}

}  // namespace praxis::app
