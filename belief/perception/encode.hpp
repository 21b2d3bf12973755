// Bytes as text: base64, data: addresses, SHA-256.
#pragma once

#include <string>
#include <string_view>

namespace praxis::belief {

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

/// "data:image/png;base64,...". Throws PerceptionError unless the bytes begin as a PNG or JPEG file does.
std::string image_address(std::string_view image);

/// 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace praxis::belief
