// Chromium without a window, for tests of pages.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace praxis::tamp {

/// Chromium's command; empty if it is not installed.
std::string find_browser();

struct Picture {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint32_t> pixels;  ///< rows from above; 0xAABBGGRR

    /// Distinct colours in the rectangle.
    std::set<std::uint32_t> colors(std::size_t left, std::size_t top, std::size_t right,
                                   std::size_t bottom) const;
};

/// What a page is after a while.
struct Visit {
    std::string dom;     ///< as HTML
    std::string errors;  ///< lines that the page wrote to its console
    Picture picture;     ///< 1280 x 800
};

/// Opens a page of this machine, at "#" `hash`, lets its clocks run for two seconds, and takes a picture of
/// it.
Visit visit(const std::filesystem::path& page, const std::string& hash);

}  // namespace praxis::tamp
