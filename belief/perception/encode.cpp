#include "belief/perception/encode.hpp"

#include <openssl/evp.h>

#include <array>

#include "belief/perception/errors.hpp"

namespace praxis::belief {

std::string base64(std::string_view bytes) {
    // EVP_EncodeBlock counts in int: whole groups of three at a time.
    constexpr std::size_t kBlock = 3U << 20U;
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    std::string block;
    while (!bytes.empty()) {
        const std::string_view part = bytes.substr(0, kBlock);
        bytes.remove_prefix(part.size());
        block.resize((part.size() + 2) / 3 * 4 + 1);
        const int length = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(block.data()),
                                           reinterpret_cast<const unsigned char*>(part.data()),
                                           static_cast<int>(part.size()));
        text.append(block, 0, static_cast<std::size_t>(length));
    }
    return text;
}

std::string image_address(std::string_view image) {
    if (image.starts_with("\x89PNG\r\n\x1a\n")) return "data:image/png;base64," + base64(image);
    if (image.starts_with("\xff\xd8\xff")) return "data:image/jpeg;base64," + base64(image);
    throw PerceptionError("an image of " + std::to_string(image.size()) +
                          " bytes is neither PNG nor JPEG: give the bytes of such a file");
}

std::string sha256(std::string_view bytes) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned length = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1) {
        throw PerceptionError("SHA-256 is not available");
    }
    std::string text;
    for (unsigned i = 0; i < length; ++i) {
        constexpr std::string_view kDigits = "0123456789abcdef";
        text.push_back(kDigits[digest[i] >> 4U]);
        text.push_back(kDigits[digest[i] & 15U]);
    }
    return text;
}

}  // namespace praxis::belief
