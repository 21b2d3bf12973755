// Pictures in memory, and PNG files of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace praxis::belief {

using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

struct Image {
    std::size_t width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< row by row, three bytes a pixel

    Image() = default;
    Image(std::size_t columns, std::size_t rows, Colour colour);

    Colour at(std::size_t column, std::size_t row) const;
    void set(std::size_t column, std::size_t row, Colour colour);
};

/// The bytes of a PNG file, eight bits a channel. Throws PerceptionError if the image is empty or cannot be
/// encoded.
std::string encode_png(const Image& image);

/// Any PNG file as red, green and blue; transparency lies on black. Throws PerceptionError, saying what is
/// wrong with the file, or if it has more than 64 million pixels.
Image decode_png(std::string_view bytes);

}  // namespace praxis::belief
