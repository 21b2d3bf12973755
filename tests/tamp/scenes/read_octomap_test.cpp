#include "tamp/scenes/read_octomap.hpp"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>
#include <rapidcheck/gtest.h>

#include <sstream>

#include "parser/diagnostic.hpp"
#include "search/engines/random.hpp"

namespace praxis::tamp {
namespace {

octomap::OcTree random_tree(Random& random) {
    octomap::OcTree tree(0.1);
    const auto coordinate = [&] { return 0.1 * (static_cast<double>(random.below(24)) - 12 + 0.5); };
    for (std::size_t i = 0; i < 1 + random.below(60); ++i) {
        const octomap::point3d point(static_cast<float>(coordinate()), static_cast<float>(coordinate()),
                                     static_cast<float>(coordinate()));
        tree.updateNode(point, random.below(2) == 0);
    }
    // A whole cube, which is stored as one leaf of a higher level.
    for (int i = 0; i < 64; ++i) {
        tree.updateNode(octomap::point3d(0.05F + 0.1F * static_cast<float>(i % 4),
                                         0.05F + 0.1F * static_cast<float>(i / 4 % 4),
                                         0.05F + 0.1F * static_cast<float>(i / 16)),
                        true);
    }
    tree.updateInnerOccupancy();
    tree.prune();
    return tree;
}

std::string text_of(octomap::OcTree& tree, bool binary) {
    std::ostringstream out;
    binary ? tree.writeBinary(out) : tree.write(out);
    return out.str();
}

Occupancy in_tree(const octomap::OcTree& tree, const Vector3& point) {
    const octomap::OcTreeNode* node = tree.search(point.x(), point.y(), point.z());
    if (node == nullptr) return Occupancy::unknown;
    return tree.isNodeOccupied(node) ? Occupancy::occupied : Occupancy::free;
}

RC_GTEST_PROP(ReadOctomap, AgreesWithTheTreeThatWasWritten, (std::uint64_t seed)) {
    Random random(seed);
    octomap::OcTree tree = random_tree(random);
    for (const bool binary : {true, false}) {
        OctomapOptions options;
        if (random.below(2) == 0) options.box = AxisBox{{-0.5, -0.7, -0.2}, {1.6, 0.6, 0.3}};
        const OccupancyMap map = parse_octomap({"map", text_of(tree, binary)}, options);
        const VoxelGrid& grid = map.grid();
        for (int k = 0; k < grid.cells[2]; ++k) {
            for (int j = 0; j < grid.cells[1]; ++j) {
                for (int i = 0; i < grid.cells[0]; ++i) {
                    const Vector3 center = Vector3(grid.origin[0], grid.origin[1], grid.origin[2]) +
                                           0.1 * Vector3(i + 0.5, j + 0.5, k + 0.5);
                    RC_ASSERT(map.cells()[grid.index(i, j, k)] == in_tree(tree, center));
                }
            }
        }
        RC_ASSERT(options.box || map.count(Occupancy::occupied) >= 64);
    }
}

std::string complaint(const std::string& text) {
    try {
        parse_octomap({"map.bt", text});
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(ReadOctomap, DamagedFilesAreRefusedInWords) {
    Random random(1);
    octomap::OcTree tree = random_tree(random);
    for (const bool binary : {true, false}) {
        const std::string text = text_of(tree, binary);
        EXPECT_EQ(complaint(text), "none");
        for (std::size_t length = 0; length < text.size(); length += 7) {
            EXPECT_NE(complaint(text.substr(0, length)), "none");
        }
    }
    const std::string header = "# Octomap OcTree binary file\nid OcTree\nsize 1\nres 0.1\ndata\n";
    const auto expect = [](const std::string& message, const std::string& words) {
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    expect(complaint(header + std::string(100000, '\xff')), "deeper than 16 levels");
    expect(complaint(header + std::string(2, '\0')), "no voxel that is known");
    expect(complaint("ply\n"), "map.bt: is no OctoMap file");
    expect(complaint("# Octomap OcTree file\nid ColorOcTree\nres 0.1\ndata\n"), "kind 'ColorOcTree'");
    expect(complaint("# Octomap OcTree file\nid OcTree\nres nan\ndata\n"), "no resolution above 0");
    // One leaf as large as the whole tree.
    expect(complaint("# Octomap OcTree file\nid OcTree\nsize 1\nres 0.1\ndata\n" + std::string(5, '\0')),
           "give a smaller box");
}

}  // namespace
}  // namespace praxis::tamp
