// Which thing is which: by name, else by place, never beyond the gate.
#include "belief/perception/object_memory.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "belief/perception/assignment.hpp"
#include "belief/perception/errors.hpp"

namespace praxis::belief {
namespace {

Detection seen(const std::string& object, const std::string& type,
               std::optional<Position> position = std::nullopt) {
    return {object, type, position, 1};
}

ObjectMemory memory_with_gate(double gate) {
    ObjectMemoryOptions options;
    options.gate = gate;
    return ObjectMemory(options);
}

TEST(Assignment, CostsTheLeastOfAllPermutations) {
    EXPECT_TRUE(rc::check([] {
        const auto rows = *rc::gen::inRange<std::size_t>(0, 6);
        const auto columns = *rc::gen::inRange<std::size_t>(rows, 7);
        std::vector<double> costs(rows * columns);
        for (double& cost : costs) cost = *rc::gen::inRange(-20, 20);
        const auto chosen = assign(costs, rows, columns);
        double sum = 0;
        std::set<std::size_t> used;
        for (std::size_t i = 0; i < rows; ++i) {
            RC_ASSERT(chosen[i] < columns);
            RC_ASSERT(used.insert(chosen[i]).second);
            sum += costs[i * columns + chosen[i]];
        }
        std::vector<std::size_t> order(columns);
        std::iota(order.begin(), order.end(), std::size_t{0});
        double least = 1e9;
        do {
            double cost = 0;
            for (std::size_t i = 0; i < rows; ++i) cost += costs[i * columns + order[i]];
            least = std::min(least, cost);
        } while (std::ranges::next_permutation(order).found);
        RC_ASSERT(sum == least);
    }));
}

TEST(ObjectMemory, TrustsNamesBeforePlaces) {
    ObjectMemory memory = memory_with_gate(0.1);
    memory.add("cup1", "cup", Position{0, 0, 0});
    memory.add("cup2", "cup", Position{1, 0, 0});
    // cup1 was carried to where cup2 was; what now stands where cup1 was cannot be cup2, a metre away: it is
    // new.
    const std::vector<Detection> view = {seen("cup1", "cup", Position{1, 0, 0}),
                                         seen("", "cup", Position{0, 0, 0})};
    const auto result = memory.associate(view, 1);
    ASSERT_TRUE(result[0] && result[1]);
    EXPECT_EQ(memory.objects()[result[0]->object].name, "cup1");
    EXPECT_TRUE(result[1]->is_new);
    EXPECT_EQ(memory.objects()[result[1]->object].name, "cup3");
    EXPECT_EQ(memory.find("cup1")->position->x, 1);
    EXPECT_EQ(memory.find("cup1")->last_seen, 1);
    EXPECT_EQ(memory.find("cup2")->last_seen, -1);
    EXPECT_EQ(memory.find("cup4"), nullptr);
}

TEST(ObjectMemory, ANameOfAnotherTypeIsNoName) {
    ObjectMemory memory = memory_with_gate(0.1);
    memory.add("thing", "cup", Position{0, 0, 0});
    const std::vector<Detection> view = {seen("thing", "box", Position{0, 0, 0})};
    const auto result = memory.associate(view, 1);
    ASSERT_TRUE(result[0]);
    EXPECT_TRUE(result[0]->is_new);
    EXPECT_EQ(memory.objects()[result[0]->object].name, "box1");

    ObjectMemoryOptions options;
    options.compatible = [](const std::string& a, const std::string& b) { return a == b || a == "object"; };
    ObjectMemory tolerant(options);
    tolerant.add("thing", "cup", Position{0, 0, 0});
    const std::vector<Detection> vague = {seen("thing", "object")};
    EXPECT_FALSE(tolerant.associate(vague, 1)[0]->is_new);
}

TEST(ObjectMemory, NeverMergesBeyondTheGate) {
    ObjectMemory memory = memory_with_gate(0.1);
    memory.add("cup1", "cup", Position{0, 0, 0});
    const std::vector<Detection> near = {seen("", "cup", Position{0.1, 0, 0})};
    EXPECT_FALSE(memory.associate(near, 1)[0]->is_new);
    const std::vector<Detection> far = {seen("", "cup", Position{0.2001, 0, 0})};
    EXPECT_TRUE(memory.associate(far, 2)[0]->is_new);
    EXPECT_EQ(memory.objects().size(), 2U);
}

TEST(ObjectMemory, MatchesAsManyAsItCan) {
    // The nearest pair alone would leave the other detection without a partner.
    ObjectMemory memory = memory_with_gate(0.1);
    memory.add("cup1", "cup", Position{0, 0, 0});
    memory.add("cup2", "cup", Position{0.09, 0, 0});
    const std::vector<Detection> view = {seen("", "cup", Position{0.08, 0, 0}),
                                         seen("", "cup", Position{0.18, 0, 0})};
    const auto result = memory.associate(view, 1);
    EXPECT_EQ(memory.objects()[result[0]->object].name, "cup1");
    EXPECT_EQ(memory.objects()[result[1]->object].name, "cup2");
}

TEST(ObjectMemory, LeavesOutWhatHasNoNameAndNoPlace) {
    ObjectMemory memory = memory_with_gate(0.1);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Detection> view = {seen("", "cup"), seen("?!", "cup"),
                                         seen("", "cup", Position{nan, 0, 0}), seen("My Cup", "cup")};
    const auto result = memory.associate(view, 1);
    EXPECT_FALSE(result[0] || result[1] || result[2]);
    ASSERT_TRUE(result[3]);
    EXPECT_EQ(memory.objects()[result[3]->object].name, "my-cup");
    EXPECT_EQ(memory.objects().size(), 1U);
}

TEST(ObjectMemory, OneOfTwoWithTheSameNameKeepsIt) {
    ObjectMemory memory = memory_with_gate(0.1);
    memory.add("cup1", "cup", Position{0, 0, 0});
    const std::vector<Detection> view = {seen("cup1", "cup", Position{1, 0, 0}),
                                         seen("cup1", "cup", Position{0.01, 0, 0})};
    const auto result = memory.associate(view, 1);
    EXPECT_TRUE(result[0]->is_new);
    EXPECT_EQ(memory.objects()[result[1]->object].name, "cup1");
}

TEST(ObjectMemory, GivesNoReservedName) {
    ObjectMemory memory = memory_with_gate(0.1);
    memory.reserve("cup1");
    const std::vector<Detection> view = {seen("", "cup", Position{0, 0, 0})};
    EXPECT_EQ(memory.objects()[memory.associate(view, 1)[0]->object].name, "cup2");
    const std::vector<Detection> named = {seen("cup1", "cup", Position{5, 0, 0})};
    EXPECT_EQ(memory.objects()[memory.associate(named, 1)[0]->object].name, "cup1");
}

TEST(ObjectMemory, FollowsWhatTheRobotMoves) {
    ObjectMemory memory = memory_with_gate(0.05);
    memory.add("cup1", "cup", Position{0, 0, 0});
    memory.moved("cup1", Position{2, 0, 0});
    const std::vector<Detection> view = {seen("", "cup", Position{2.01, 0, 0})};
    EXPECT_FALSE(memory.associate(view, 1)[0]->is_new);
    EXPECT_THROW(memory_with_gate(-1), PerceptionError);
}

TEST(ObjectMemory, TellsEqualThingsApart) {
    // Cups of one colour, farther apart than the gate, looked at again and again from two views with noise,
    // some of them hidden, in any order, without names: each keeps its name, and none is invented.
    std::mt19937_64 random(7);
    for (int round = 0; round < 40; ++round) {
        const double gate = 0.06;
        ObjectMemory memory = memory_with_gate(gate);
        std::vector<Position> cups;
        std::uniform_real_distribution<double> place(0, 1);
        while (cups.size() < 12) {
            const Position p{place(random), place(random), 0};
            if (std::ranges::all_of(cups, [&](const Position& q) { return distance(p, q) > 2 * gate; })) {
                cups.push_back(p);
            }
        }
        std::vector<std::optional<std::size_t>> name_of(cups.size());
        std::uniform_real_distribution<double> noise(-0.015, 0.015);
        for (int step = 0; step < 20; ++step) {
            for (int view = 0; view < 2; ++view) {
                std::vector<std::size_t> order(cups.size());
                std::iota(order.begin(), order.end(), std::size_t{0});
                std::ranges::shuffle(order, random);
                order.resize(4 + random() % (cups.size() - 3));
                std::vector<Detection> detections;
                for (const std::size_t cup : order) {
                    const Position& p = cups[cup];
                    detections.push_back(seen(
                        "", "cup", Position{p.x + noise(random), p.y + noise(random), p.z + noise(random)}));
                }
                const auto result = memory.associate(detections, step);
                for (std::size_t i = 0; i < order.size(); ++i) {
                    ASSERT_TRUE(result[i]);
                    auto& name = name_of[order[i]];
                    EXPECT_EQ(result[i]->is_new, !name.has_value());
                    if (!name) name = result[i]->object;
                    EXPECT_EQ(*name, result[i]->object);
                }
            }
        }
        EXPECT_LE(memory.objects().size(), cups.size());
    }
}

TEST(ObjectMemory, KeepsItsPromisesOnAnything) {
    EXPECT_TRUE(rc::check([] {
        const double gate = 0.3;
        ObjectMemory memory = memory_with_gate(gate);
        for (int step = 0; step < 5; ++step) {
            std::vector<Detection> view;
            const int count = *rc::gen::inRange(0, 6);
            for (int i = 0; i < count; ++i) {
                Detection detection = seen(*rc::gen::element<std::string>("", "", "a", "b", "cup1"),
                                           *rc::gen::element<std::string>("cup", "box"));
                if (*rc::gen::inRange(0, 4) > 0) {
                    detection.position =
                        Position{*rc::gen::inRange(0, 10) * 0.1, *rc::gen::inRange(0, 10) * 0.1, 0};
                }
                view.push_back(detection);
            }
            const std::vector<RememberedObject> before = memory.objects();
            const auto result = memory.associate(view, step);
            std::set<std::size_t> used;
            for (std::size_t i = 0; i < view.size(); ++i) {
                if (!result[i]) {
                    RC_ASSERT(!view[i].position);
                    continue;
                }
                const std::size_t object = result[i]->object;
                RC_ASSERT(used.insert(object).second);
                RC_ASSERT(result[i]->is_new == (object >= before.size()));
                RC_ASSERT(memory.objects()[object].type == view[i].type);
                RC_ASSERT(memory.objects()[object].last_seen == step);
                if (!result[i]->is_new && before[object].name != view[i].object) {
                    RC_ASSERT(distance(*before[object].position, *view[i].position) <= gate);
                }
            }
            std::set<std::string> names;
            for (const RememberedObject& object : memory.objects())
                RC_ASSERT(names.insert(object.name).second);
        }
    }));
}

}  // namespace
}  // namespace praxis::belief
