#include "tamp/robots/find_resource.hpp"

#include <filesystem>
#include <string_view>

namespace praxis::tamp {

namespace {

namespace fs = std::filesystem;

std::string find_in_packages(std::string_view name_and_path, const fs::path& robot_file,
                             const std::vector<std::string>& packages) {
    const std::size_t slash = name_and_path.find('/');
    if (slash == std::string_view::npos) return {};
    const fs::path name = name_and_path.substr(0, slash);
    const fs::path path = name_and_path.substr(slash + 1);
    std::vector<fs::path> places(packages.begin(), packages.end());
    std::error_code error;
    for (fs::path above = fs::absolute(robot_file, error).parent_path(); !above.empty() && !error;
         above = above.parent_path()) {
        places.push_back(above);
        if (above == above.root_path()) break;
    }
    for (const fs::path& place : places) {
        const fs::path inside = place / name / path;
        if (fs::is_regular_file(inside, error)) return inside.string();
        const fs::path last = place.has_filename() ? place.filename() : place.parent_path().filename();
        if (last == name && fs::is_regular_file(place / path, error)) return (place / path).string();
    }
    return {};
}

}  // namespace

std::string find_resource(const std::string& uri, const std::string& robot_file,
                          const std::vector<std::string>& packages) {
    for (const std::string_view scheme : {"package://", "model://"}) {
        if (uri.starts_with(scheme)) return find_in_packages(uri.substr(scheme.size()), robot_file, packages);
    }
    constexpr std::string_view kFile = "file://";
    const fs::path path = uri.starts_with(kFile) ? uri.substr(kFile.size()) : uri;
    return (path.is_absolute() ? path : fs::path(robot_file).parent_path() / path).string();
}

}  // namespace praxis::tamp
