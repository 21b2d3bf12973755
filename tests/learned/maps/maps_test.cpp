#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <fstream>

#include "learned/groups/group.hpp"
#include "learned/maps/maze_file.hpp"
#include "learned/maps/navigation.hpp"
#include "parser/diagnostic.hpp"

namespace praxis::learned {
namespace {

MapProblem drawn(int width, const std::string& cells) {
    MapProblem problem;
    problem.width = width;
    problem.height = static_cast<int>(cells.size()) / width;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        problem.free.push_back(cells[i] != '#');
        if (cells[i] == 'G') problem.goal = static_cast<int>(i);
    }
    return problem;
}

TEST(MapProblem, HasExactDistancesAndAllOptimalMoves) {
    MapProblem problem = drawn(4,
                               "...G"
                               "...."
                               ".###"
                               ".#..");
    solve_exactly(problem);
    constexpr std::uint16_t kFar = MapProblem::kUnreachable;
    EXPECT_EQ(problem.distance,
              (std::vector<std::uint16_t>{3, 2, 1, 0, 4, 3, 2, 1, 5, kFar, kFar, kFar, 6, kFar, kFar, kFar}));
    constexpr unsigned kNorth = 1, kEast = 8;
    EXPECT_EQ(problem.optimal[4], kNorth | kEast);
    EXPECT_EQ(problem.optimal[8], kNorth);
    EXPECT_EQ(problem.optimal[2], kEast);
    EXPECT_EQ(problem.optimal[3], 0);   // the goal
    EXPECT_EQ(problem.optimal[14], 0);  // cut off
}

TEST(MapProblem, MovesWrapAroundOnATorus) {
    MapProblem problem = drawn(5,
                               "....G"
                               "#####"
                               "....."
                               "....."
                               "#####");
    problem.padding = Padding::circular;
    solve_exactly(problem);
    EXPECT_EQ(problem.distance[0], 1);
    EXPECT_EQ(problem.optimal[0], 2u);  // west
    EXPECT_EQ(problem.optimal[1], 2u);
}

TEST(MapProblem, BadProblemsAreRefused) {
    MapProblem in_wall = drawn(2, "G.##");
    in_wall.goal = 2;
    EXPECT_THROW(solve_exactly(in_wall), std::invalid_argument);
    in_wall.goal = 4;
    EXPECT_THROW(solve_exactly(in_wall), std::invalid_argument);
    MapProblem ragged = drawn(2, "G.##");
    ragged.height = 3;
    EXPECT_THROW(solve_exactly(ragged), std::invalid_argument);
}

RC_GTEST_PROP(Navigation, MovesCountDownToTheGoal, (std::uint64_t seed)) {
    Random random(seed);
    const int size = 5 + static_cast<int>(random.below(24));
    const MapProblem problem = navigation_problem(size, random);
    for (int cell = 0; cell < problem.cells(); ++cell) {
        const auto at = static_cast<std::size_t>(cell);
        RC_ASSERT(problem.label[at] < 4);
        RC_ASSERT(
            (problem.optimal[at] != 0) ==
            (problem.free[at] && problem.distance[at] != MapProblem::kUnreachable && cell != problem.goal));
        RC_ASSERT(problem.optimal[at] == 0 || (problem.optimal[at] >> problem.label[at] & 1));
        for (int move = 0; move < 4; ++move) {
            const int next = problem.neighbour(cell, move);
            const bool closer = problem.free[at] && problem.distance[at] != MapProblem::kUnreachable &&
                                next >= 0 &&
                                problem.distance[static_cast<std::size_t>(next)] + 1 == problem.distance[at];
            RC_ASSERT(closer == ((problem.optimal[at] >> move & 1) != 0));
        }
    }
}

TEST(Navigation, MazesAreAsPublished) {
    for (const auto& [size, free] : {std::pair{15, 0.59}, {28, 0.71}, {50, 0.73}}) {
        const MapSet set = navigation_set(size, 400, 7);
        double share = 0, cut_off = 0;
        for (const MapProblem& problem : set.problems)
            for (std::size_t cell = 0; cell < problem.free.size(); ++cell) {
                share += problem.free[cell];
                cut_off += problem.free[cell] && problem.distance[cell] == MapProblem::kUnreachable;
            }
        EXPECT_LT(cut_off / share, 0.01);
        EXPECT_NEAR(share / (400.0 * size * size), free, 0.03) << size;
        if (size % 2 == 0) continue;
        for (const MapProblem& problem : set.problems)
            for (int i = 0; i < size; ++i) {
                EXPECT_EQ(problem.free[static_cast<std::size_t>(i)], 0);
                EXPECT_EQ(problem.free[static_cast<std::size_t>(problem.cells() - 1 - i)], 0);
            }
    }
}

TEST(Navigation, SameSeedSameMazesAnotherSeedOthers) {
    const MapSet a = navigation_set(15, 5, 1), b = navigation_set(15, 5, 1), c = navigation_set(15, 5, 2);
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_EQ(a.problems[k].free, b.problems[k].free);
        EXPECT_EQ(a.problems[k].label, b.problems[k].label);
        EXPECT_NE(a.problems[k].free, c.problems[k].free);
    }
}

TEST(Navigation, UnfitSizesAreRefused) {
    Random random(1);
    EXPECT_THROW(navigation_problem(4, random), std::invalid_argument);
    EXPECT_THROW(navigation_problem(256, random), std::invalid_argument);
}

class MazeFile : public testing::Test {
  protected:
    MazeFile()
        : name_(
              (std::filesystem::temp_directory_path() /
               (std::string("praxis_mazes_") + testing::UnitTest::GetInstance()->current_test_info()->name()))
                  .string()) {}
    ~MazeFile() override { std::filesystem::remove(name_); }

    /// 3x3 cells, the goal in the middle of the first row; the rest of it and the middle are free.
    std::string record() const {
        return std::string{1, 1, 1, 0, 1, 0, 0, 0, 0} + std::string{0, 1} +
               std::string{3, 0, 1, 0, 0, 0, 0, 0, 0};
    }
    MapSet read(const std::string& bytes, std::size_t limit = 0) const {
        std::ofstream(name_, std::ios::binary) << bytes;
        return read_mazes(name_, 3, limit);
    }
    void expect_error(const std::string& bytes, const std::string& message) const {
        try {
            read(bytes);
            FAIL() << "accepted: " << message;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
        }
    }
    std::string changed(std::size_t at, char byte) const {
        std::string bytes = record() + record();
        bytes[record().size() + at] = byte;
        return bytes;
    }

  private:
    std::string name_;
};

TEST_F(MazeFile, IsReadRecordByRecord) {
    const MapSet set = read(record() + record() + record());
    ASSERT_EQ(set.problems.size(), 3u);
    EXPECT_EQ(set.problems[2].goal, 1);
    EXPECT_EQ(set.problems[2].distance[4], 1);
    EXPECT_EQ(set.problems[2].label[0], 3);
    EXPECT_EQ(read(record() + record(), 1).problems.size(), 1u);
}

TEST_F(MazeFile, ThatIsWrongIsRefusedWithThePlace) {
    expect_error("", "0 bytes");
    expect_error(record() + "x", "21 bytes are not a number of records of 20 bytes");
    expect_error(changed(3, 2), "record 2: a cell is not 0 or 1");
    expect_error(changed(9, 3), "record 2: the goal is off the map");
    expect_error(changed(9, 2), "record 2: the goal is in a wall");
    expect_error(changed(11, 4), "record 2: a label is not 0 to 3");
    expect_error(changed(11, 1), "record 2: the label of cell 0, 0 is not an optimal move");
    EXPECT_THROW(read_mazes("/no/such/file"), InputError);
}

TEST(PublishedMazes, HaveOptimalLabelsAsFarAsTheyAreHere) {
    const std::string file = std::string(PRAXIS_SOURCE_DIR) + "/../shared/data/maze15/valid.bin";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "there is no " << file;
    const MapSet set = read_mazes(file);
    ASSERT_EQ(set.problems.size(), 2000u);
    double free = 0;
    for (const MapProblem& problem : set.problems)
        for (const std::uint8_t cell : problem.free) free += cell;
    EXPECT_NEAR(free / (2000 * 225), 0.589, 0.01);
}

}  // namespace
}  // namespace praxis::learned
