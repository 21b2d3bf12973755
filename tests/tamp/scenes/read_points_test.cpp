#include "tamp/scenes/read_points.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "parser/diagnostic.hpp"

namespace praxis::tamp {
namespace {

const std::vector<Vector3> kPoints = {{1, 2, 3}, {-4, 0.5, 0}};

std::vector<Vector3> read(const std::string& text) {
    return parse_points({"cloud", text});
}

template <class T>
std::string bytes(T value) {
    std::string result(sizeof(T), '\0');
    std::memcpy(result.data(), &value, sizeof(T));
    return result;
}

std::string pcd_header(const std::string& format) {
    return "# .PCD v0.7\nVERSION 0.7\nFIELDS rgb x y z\nSIZE 4 4 4 8\nTYPE U F F F\nCOUNT 2 1 1 1\n"
           "WIDTH 3\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA " +
           format + "\n";
}

std::string binary_pcd() {
    std::string text = pcd_header("binary");
    for (const Vector3& point : {kPoints[0], Vector3(std::nan(""), 0, 0), kPoints[1]}) {
        text += std::string(8, 'c') + bytes(static_cast<float>(point.x())) +
                bytes(static_cast<float>(point.y())) + bytes(point.z());
    }
    return text;
}

std::string ply_header(const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment none\nelement vertex 2\nproperty uchar red\nproperty float x\nproperty double y\n"
           "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string binary_ply() {
    std::string text = ply_header("binary_little_endian");
    for (const Vector3& point : kPoints) {
        text += "r" + bytes(static_cast<float>(point.x())) + bytes(point.y()) +
                bytes(static_cast<float>(point.z()));
    }
    return text + std::string(13, '\1');
}

TEST(ReadPoints, ReadsEveryFormat) {
    EXPECT_EQ(read("1 2 3\n-4 0.5 0\n"), kPoints);
    EXPECT_EQ(read("# comment\n\n1,2,+3,9\r\n-4;0.5\t0\n"), kPoints);
    EXPECT_EQ(read("intensity,z,y,X\n7,3,2,1\n7,0,0.5,-4\n"), kPoints);
    EXPECT_EQ(read(pcd_header("ascii") + "9 9 1 2 3\n9 9 nan nan nan\n9 9 -4 0.5 0\n"), kPoints);
    EXPECT_EQ(read(binary_pcd()), kPoints);
    EXPECT_EQ(read(ply_header("ascii") + "255 1 2 3\n255 -4 0.5 0\n3 0 1 2\n"), kPoints);
    EXPECT_EQ(read(binary_ply()), kPoints);
    EXPECT_EQ(read(""), std::vector<Vector3>{});
}

std::string complaint(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(ReadPoints, ErrorsNameTheLineOrWhatTheHeaderLacks) {
    const auto expect = [](const std::string& text, const std::string& words) {
        EXPECT_NE(complaint(text).find(words), std::string::npos) << complaint(text);
    };
    expect("1 2 3\n1 2\n", "cloud:2: a point needs three numbers");
    expect("1 2 3\n1 2 c\n", "cloud:2: 'c' is no number");
    expect("a,b,c\n1,2,3\n", "no column 'x'");
    expect(pcd_header("binary_compressed"), "PCD of kind 'binary_compressed'");
    expect("# .PCD\nFIELDS x y\nSIZE 4 4\nTYPE F F\nPOINTS 0\nDATA ascii\n", "the fields x, y and z");
    expect("# .PCD\nFIELDS x y z\nSIZE 4 4 4\nTYPE U F F\nPOINTS 0\nDATA ascii\n", "TYPE F");
    expect("# .PCD\nFIELDS x y z\nSIZE 4 4\nTYPE F F F\nPOINTS 0\nDATA ascii\n", "as many SIZE");
    expect("# .PCD\nPOINTS 999999999999\n", "up to 50 million");
    expect(ply_header("binary_big_endian"), "PLY of kind 'binary_big_endian'");
    expect("ply\nformat ascii 1.0\nelement face 1\n", "the first element must be 'vertex'");
}

TEST(ReadPoints, TruncatedFilesAreRefused) {
    for (const std::string& text : {binary_pcd(), binary_ply().substr(0, binary_ply().size() - 13)}) {
        for (std::size_t length = text.size() - 40; length < text.size(); ++length) {
            EXPECT_NE(complaint(text.substr(0, length)), "none");
        }
        for (std::size_t length = 0; length < text.size(); ++length) complaint(text.substr(0, length));
    }
}

}  // namespace
}  // namespace praxis::tamp
