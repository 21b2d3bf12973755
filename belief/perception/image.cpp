#include "belief/perception/image.hpp"

#include <png.h>

#include "belief/perception/errors.hpp"

namespace praxis::belief {

Image::Image(std::size_t columns, std::size_t rows, Colour colour) : width(columns), height(rows) {
    rgb.reserve(columns * rows * 3);
    for (std::size_t i = 0; i < columns * rows; ++i) rgb.insert(rgb.end(), colour.begin(), colour.end());
}

Colour Image::at(std::size_t column, std::size_t row) const {
    const std::size_t i = (row * width + column) * 3;
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
}

void Image::set(std::size_t column, std::size_t row, Colour colour) {
    const std::size_t i = (row * width + column) * 3;
    for (std::size_t channel = 0; channel < 3; ++channel) rgb[i + channel] = colour[channel];
}

std::string encode_png(const Image& image) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width);
    header.height = static_cast<png_uint_32>(image.height);
    header.format = PNG_FORMAT_RGB;
    if (image.rgb.empty() || image.rgb.size() != image.width * image.height * 3) {
        throw PerceptionError("an image of " + std::to_string(image.width) + " x " +
                              std::to_string(image.height) + " pixels cannot be encoded");
    }
    std::string bytes;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
    bytes.resize(size);
    if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0) {
        throw PerceptionError(std::string("cannot encode an image: ") + header.message);
    }
    bytes.resize(size);
    return bytes;
}

Image decode_png(std::string_view bytes) {
    constexpr std::uint64_t kMostPixels = 64'000'000;
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) {
        throw PerceptionError(std::string("not a usable PNG image: ") + header.message);
    }
    if (std::uint64_t{header.width} * header.height > kMostPixels) {
        png_image_free(&header);
        throw PerceptionError("a PNG image of " + std::to_string(header.width) + " x " +
                              std::to_string(header.height) + " pixels is too large");
    }
    header.format = PNG_FORMAT_RGB;
    Image image(header.width, header.height, {0, 0, 0});
    const png_color black{0, 0, 0};
    if (png_image_finish_read(&header, &black, image.rgb.data(), 0, nullptr) == 0) {
        throw PerceptionError(std::string("not a usable PNG image: ") + header.message);
    }
    return image;
}

}  // namespace praxis::belief
