// Ten by ten metres, four rooms: boxes that can be moved stand about, and one stands in every door. The
// parcel has to come from the last room to the first.
#include "tamp/problems/floor_plan.hpp"
#include "tamp/problems/scatter.hpp"

namespace praxis::tamp {

GeneratedProblem namo(ProblemRequest request) {
    constexpr int kRooms = 4;
    Random& random = request.random;
    const FloorPlan plan = make_floor_plan(random, {.side = 2, .room = 4.9, .door = 0.9, .closed = 0.5});
    ProblemText text("pick-place", request.name,
                     "A parcel has to be fetched past " + std::to_string(request.size) +
                         " boxes, some of which stand in doors.",
                     "mobile-arm7", start_text(plan.center(0)));
    for (const Wall& wall : plan.walls) text.add_box(wall.name, wall.size, wall.center, colors::kWall);
    const double half = (plan.options.room - 0.3) / 2;
    std::vector<Place> taken = {plan.center(0)};
    for (int room = 0; room < kRooms; ++room) {
        const Place center = plan.center(room);
        const std::string floor = "floor" + std::to_string(room + 1);
        text.add_floor(floor, {center[0], center[1], 0}, {2 * half, 2 * half});
        text.add_object(floor, "region");
    }
    text.add_floor("ground", {0, 0, 0}, {30, 30});
    const auto add = [&](const std::string& name, const Place& at, const std::array<double, 3>& color) {
        text.add_thing({.name = name,
                        .shape = box_text({0.06, 0.24, 0.45}),
                        .surface = "ground",
                        .place = at,
                        .yaw = uniform(random, -1.5, 1.5),
                        .color = color,
                        .grasps = "[top]"});
        for (int room = 1; room <= kRooms; ++room) {
            text.add_fact("(placeable " + name + " floor" + std::to_string(room) + ")");
        }
        taken.push_back(at);
    };
    const auto somewhere = [&](int room) {
        const Place center = plan.center(room);
        return scatter(random,
                       {{center[0] - half + 0.4, center[1] - half + 0.4},
                        {center[0] + half - 0.4, center[1] + half - 0.4}},
                       1, 0.8, 0.4, taken)[0];
    };
    add("parcel", somewhere(kRooms - 1), colors::kRed);
    int boxes = 0;
    for (const Door& door : plan.doors) add("box" + std::to_string(++boxes), door.center, colors::kYellow);
    while (boxes < request.size) {
        add("box" + std::to_string(boxes + 1), somewhere(boxes % kRooms), colors::kBlue);
        ++boxes;
    }
    text.add_goal("(in parcel floor1)");
    return std::move(text).finish();
}

}  // namespace praxis::tamp
