#include "tests/tamp/view/browser.hpp"

#include <png.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace praxis::tamp {

namespace {

namespace fs = std::filesystem;

/// A folder that is removed with everything in it.
class Folder {
  public:
    Folder() {
        std::string name = (fs::temp_directory_path() / "praxis-browser-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no folder for the browser");
        path_ = name;
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    fs::path operator/(const char* name) const { return path_ / name; }

  private:
    fs::path path_;
};

std::string quoted(const std::string& text) {
    return "'" + text + "'";
}

std::string read_file(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string console_lines(const std::string& log) {
    std::istringstream in(log);
    std::string result;
    for (std::string line; std::getline(in, line);)
        if (line.find("CONSOLE") != std::string::npos) result += line + "\n";
    return result;
}

Picture read_picture(const fs::path& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (!png_image_begin_read_from_file(&image, file.c_str()))
        throw std::runtime_error("the browser took no picture");
    image.format = PNG_FORMAT_RGBA;
    Picture picture{image.width, image.height,
                    std::vector<std::uint32_t>(std::size_t{image.width} * image.height)};
    if (!png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr))
        throw std::runtime_error("the browser's picture is broken");
    return picture;
}

}  // namespace

std::string find_browser() {
    std::istringstream path(std::getenv("PATH") ? std::getenv("PATH") : "");
    for (std::string folder; std::getline(path, folder, ':');)
        if (access((folder + "/chromium").c_str(), X_OK) == 0) return folder + "/chromium";
    return "";
}

std::set<std::uint32_t> Picture::colors(std::size_t left, std::size_t top, std::size_t right,
                                        std::size_t bottom) const {
    std::set<std::uint32_t> result;
    for (std::size_t y = top; y < bottom; ++y)
        for (std::size_t x = left; x < right; ++x) result.insert(pixels.at(y * width + x));
    return result;
}

Visit visit(const fs::path& page, const std::string& hash) {
    const Folder folder;
    const std::string command = "timeout 200 " + quoted(find_browser()) +
                                " --headless --no-sandbox --disable-dev-shm-usage --hide-scrollbars" +
                                " --use-angle=swiftshader --enable-unsafe-swiftshader "
                                "--enable-logging=stderr --window-size=1280,800" +
                                " --virtual-time-budget=2000 --user-data-dir=" + quoted(folder / "profile") +
                                " --screenshot=" + quoted(folder / "picture.png") + " --dump-dom " +
                                quoted("file://" + page.string() + "#" + hash) + " >" +
                                quoted(folder / "dom") + " 2>" + quoted(folder / "log") + " </dev/null";
    if (std::system(command.c_str()) != 0)
        throw std::runtime_error("the browser failed: " + read_file(folder / "log"));
    return {read_file(folder / "dom"), console_lines(read_file(folder / "log")),
            read_picture(folder / "picture.png")};
}

}  // namespace praxis::tamp
