// Texts of bytes, addresses and times.
#include "belief/perception/encode.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "belief/perception/protocol.hpp"
#include "tests/belief/perception/support.hpp"

namespace praxis::belief {
namespace {

using test::contains;
using test::perception_error;

std::string decoded(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits * 64 + static_cast<unsigned>(digits.find(c));
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<char>((bits >> count) & 255U));
        bits &= (1U << count) - 1;
    }
    return bytes;
}

TEST(Base64, EncodesTheExamplesOfItsStandard) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(Base64, CanBeDecoded) {
    EXPECT_TRUE(rc::check([](const std::string& bytes) {
        const std::string text = base64(bytes);
        RC_ASSERT(text.size() == (bytes.size() + 2) / 3 * 4);
        RC_ASSERT(decoded(text) == bytes);
    }));
    const std::string large((7U << 20U) + 1, '\xa7');
    EXPECT_EQ(decoded(base64(large)), large);
}

TEST(Sha256, KnowsAKnownHash) {
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Images, AreKnownByTheirFirstBytes) {
    EXPECT_TRUE(image_address(test::kPngHead).starts_with("data:image/png;base64,"));
    EXPECT_TRUE(image_address("\xff\xd8\xff rest").starts_with("data:image/jpeg;base64,"));
    EXPECT_TRUE(contains(perception_error([] { image_address("GIF89a"); }), "neither PNG nor JPEG"));
}

TEST(Url, HasParts) {
    const Url plain = Url::parse("http://localhost/v1/");
    EXPECT_FALSE(plain.secure);
    EXPECT_EQ(plain.host, "localhost");
    EXPECT_EQ(plain.port, "80");
    EXPECT_EQ(plain.path, "/v1");
    EXPECT_EQ(plain.authority(), "localhost");
    const Url secure = Url::parse("https://[::1]:8443");
    EXPECT_TRUE(secure.secure);
    EXPECT_EQ(secure.host, "::1");
    EXPECT_EQ(secure.port, "8443");
    EXPECT_EQ(secure.path, "");
    EXPECT_EQ(secure.authority(), "[::1]:8443");
    EXPECT_EQ(Url::parse("https://api.example.com/openai/v1").port, "443");
}

TEST(Url, RefusesWhatIsNone) {
    for (const char* text : {"", "localhost", "http://", "http:///v1", "http://a b/", "http://a:0",
                             "http://a:65536", "http://a:b", "http://a:", "http://[::1", "http://[::1]x",
                             "http://key@host/", "https://h/?q", "http://h/\r\nX: 1", "ftp://h"}) {
        EXPECT_TRUE(contains(perception_error([&] { Url::parse(text); }), "unusable address")) << text;
    }
}

TEST(RetryAfter, IsSecondsOrADate) {
    using namespace std::chrono_literals;
    const auto now = std::chrono::system_clock::from_time_t(784111777);  // Sun, 06 Nov 1994 08:49:37 GMT
    EXPECT_EQ(read_retry_after("7", now), 7s);
    EXPECT_EQ(read_retry_after("0", now), 0s);
    EXPECT_EQ(read_retry_after("-5", now), 0s);
    EXPECT_EQ(read_retry_after("Sun, 06 Nov 1994 08:50:00 GMT", now), 23s);
    EXPECT_EQ(read_retry_after("Sun, 06 Nov 1994 08:49:00 GMT", now), 0s);
    EXPECT_EQ(read_retry_after("", now), std::nullopt);
    EXPECT_EQ(read_retry_after("soon", now), std::nullopt);
    EXPECT_EQ(read_retry_after("7 s", now), std::nullopt);
    EXPECT_GT(read_retry_after("99999999999999999999", now), 24h);
}

}  // namespace
}  // namespace praxis::belief
