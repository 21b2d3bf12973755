#include "practice/environments/ball_ring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "practice/environments/texts.hpp"

namespace praxis::practice {

namespace {

constexpr std::int32_t kTables = 5;
constexpr double kRoom = 1;
constexpr double kCircleRadius = kRoom / 3;
const double kTableRadius = kCircleRadius * std::sin(std::numbers::pi / kTables) / 2;
const double kBallRadius = 0.95 * 0.25 * kTableRadius;
const double kRingRadius = 1.05 * 0.25 * kTableRadius;
const double kDiscRadius = 0.35 * kTableRadius;
constexpr double kReach = 0.1;

enum Number : std::size_t {
    robot_x,
    robot_y,
    beside,  // a table, the ball, the ring or nothing
    ball_x,
    ball_y,
    ball_at,  // a table, the floor or the hand (alone or in the ring that the hand holds)
    ball_inside,
    ring_x,
    ring_y,
    ring_at,
    disc_x,  // of the sticky disc from the centre of the smooth table
    disc_y,
    number_count
};

// Places: the tables 0 to 4, of which 0 is the smooth one, and these.
constexpr double kFloor = kTables;
constexpr double kHand = kTables + 1;
constexpr double kBesideBall = kTables;
constexpr double kBesideRing = kTables + 1;
constexpr double kBesideNothing = kTables + 2;

enum Predicate : std::int32_t {
    beside_table,
    beside_ball,
    beside_ring,
    hand_empty,
    holding_ball,
    holding_ring,
    ball_on,
    ball_on_floor,
    ball_in_ring,
    ball_free,
    ring_on,
    ring_on_floor
};

enum Schema : std::int32_t {
    navigate_to_table,
    navigate_to_ball,
    navigate_to_ring,
    pick_ball_from_table,
    pick_ball_from_floor,
    pick_ring_from_table,
    pick_ring_with_ball_from_table,
    pick_ring_from_floor,
    pick_ring_with_ball_from_floor,
    place_ball_on_table,
    place_ball_on_floor,
    place_ball_in_ring_on_table,
    place_ball_in_ring_on_floor,
    place_ring_on_table,
    place_ring_on_floor,
    place_ring_with_ball_on_floor
};

struct Point {
    double x = 0;
    double y = 0;
};

Point operator+(Point a, Point b) {
    return {a.x + b.x, a.y + b.y};
}
Point operator-(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}
double length(Point p) {
    return std::hypot(p.x, p.y);
}
Point polar(double distance, double angle) {
    return {distance * std::cos(angle), distance * std::sin(angle)};
}
/// In any direction, at a distance uniform in [low, high).
Point around(Random& random, double low, double high) {
    const double distance = uniform(random, low, high);
    return polar(distance, uniform(random, 0, 2 * std::numbers::pi));
}
bool in_room(Point p) {
    return p.x >= 0 && p.x <= kRoom && p.y >= 0 && p.y <= kRoom;
}

Point table_centre(std::int32_t table) {
    return Point{kRoom / 2, kRoom / 2} + polar(kCircleRadius, 2 * std::numbers::pi * table / kTables);
}
Point disc_offset(const State& state, std::int32_t table) {
    return table == 0 ? Point{state[disc_x], state[disc_y]} : Point{};
}
Point floor_beside(std::int32_t table, Random& random) {
    for (;;) {
        const Point p = table_centre(table) + around(random, 2.25 * kTableRadius, 2.3 * kTableRadius);
        if (in_room(p)) return p;
    }
}
Point centre_of_room(Random& random) {
    return Point{kRoom / 2, kRoom / 2} + around(random, 0, 2 * kRingRadius);
}

bool is_hand_empty(const State& s) {
    return s[ball_at] != kHand && s[ring_at] != kHand;
}
bool holds_ball(const State& s) {
    return s[ball_at] == kHand && s[ball_inside] == 0;
}
bool holds_ring(const State& s) {
    return s[ring_at] == kHand;
}

void move_robot(State& s, double to, Point centre, double radius, Random& random) {
    const Point p = centre + around(random, radius, kReach);
    s[robot_x] = p.x;
    s[robot_y] = p.y;
    s[beside] = to;
}
void put_ball(State& s, double where, Point p) {
    s[ball_at] = where;
    s[ball_x] = p.x;
    s[ball_y] = p.y;
}
/// The ball goes with it if it is inside.
void put_ring(State& s, double where, Point p) {
    s[ring_at] = where;
    s[ring_x] = p.x;
    s[ring_y] = p.y;
    if (s[ball_inside] != 0) put_ball(s, where, p);
}
void pick_ball(State& s) {
    s[ball_at] = kHand;
    s[ball_inside] = 0;
}
void pick_ring(State& s) {
    s[ring_at] = kHand;
    if (s[ball_inside] != 0) s[ball_at] = kHand;
}
void put_ball_into_ring(State& s) {
    put_ball(s, s[ring_at], {s[ring_x], s[ring_y]});
    s[ball_inside] = 1;
}

bool ring_stays(const State& s, std::int32_t table, Point p) {
    const Point offset = p - table_centre(table);
    if (length(offset) > kTableRadius) return false;
    return table != 0 || length(offset - disc_offset(s, table)) <= kDiscRadius;
}

Description describe(BallRing::Features features) {
    Description description;
    description.name = "ball-ring";
    description.domain = texts::kBallRingDomain;
    description.problem = texts::kBallRingProblem;
    description.predicates = {"beside-table", "beside-ball",  "beside-ring", "hand-empty",
                              "holding-ball", "holding-ring", "ball-on",     "ball-on-floor",
                              "ball-in-ring", "ball-free",    "ring-on",     "ring-on-floor"};
    description.objects = {"smooth-table", "table-1", "table-2", "table-3", "table-4"};
    SkillSchema place;
    if (features == BallRing::Features::raw) {
        place.parameters = {"x", "y"};
        place.features = {"robot-x", "robot-y",      "ball-x",      "ball-y",    "ball-radius", "ball-held",
                          "ring-x",  "ring-y",       "ring-radius", "ring-held", "table-x",     "table-y",
                          "table-r", "table-smooth", "disc-dx",     "disc-dy",   "disc-radius"};
        place.relevant_features = {10, 11, 12, 13, 14, 15, 16};
    } else {
        place.parameters = {"dx", "dy"};
        place.features = {"table-smooth", "disc-radius"};
        place.relevant_features = {0, 1};
    }
    const auto schema = [&](const char* name) {
        SkillSchema result = place;
        result.name = name;
        return result;
    };
    description.schemas = {{"navigate-to-table", {}, {}, {}},
                           {"navigate-to-ball", {}, {}, {}},
                           {"navigate-to-ring", {}, {}, {}},
                           {"pick-ball-from-table", {}, {}, {}},
                           {"pick-ball-from-floor", {}, {}, {}},
                           {"pick-ring-from-table", {}, {}, {}},
                           {"pick-ring-with-ball-from-table", {}, {}, {}},
                           {"pick-ring-from-floor", {}, {}, {}},
                           {"pick-ring-with-ball-from-floor", {}, {}, {}},
                           schema("place-ball-on-table"),
                           {"place-ball-on-floor", {}, {}, {}},
                           {"place-ball-in-ring-on-table", {}, {}, {}},
                           {"place-ball-in-ring-on-floor", {}, {}, {}},
                           schema("place-ring-on-table"),
                           {"place-ring-on-floor", {}, {}, {}},
                           {"place-ring-with-ball-on-floor", {}, {}, {}}};
    description.horizon = 8;
    description.cycle_steps = 250;
    return description;
}

}  // namespace

BallRing::BallRing(Features features)
    : CheckedEnvironment(describe(features), signatures(), number_count), features_(features) {}

CheckedEnvironment::Signatures BallRing::signatures() {
    const std::vector<Range> table = {{0, kTables - 1}};
    return {{table, {}, {}, {}, {}, {}, table, {}, {}, {}, table, {}},
            {table, {}, {}, table, {}, table, table, {}, {}, table, {}, table, {}, table, {}, {}}};
}

PracticeTask BallRing::sample_task(Random& random) const {
    State s(number_count, 0);
    const Point disc = around(random, 0, kTableRadius - kDiscRadius);
    s[disc_x] = disc.x;
    s[disc_y] = disc.y;
    put_ball(s, 1, table_centre(1) + around(random, 0, kTableRadius - kBallRadius));
    Point ring;
    const auto over_table = [&] {
        for (std::int32_t table = 0; table < kTables; ++table)
            if (length(ring - table_centre(table)) < kTableRadius + kRingRadius) return true;
        return false;
    };
    do ring = {uniform(random, 0, kRoom), uniform(random, 0, kRoom)};
    while (over_table());
    put_ring(s, kFloor, ring);
    const auto table = static_cast<std::int32_t>(random.below(kTables));
    move_robot(s, table, table_centre(table), kTableRadius, random);
    return {s, {{ball_on, {0}}}};
}

bool BallRing::atom_holds(const State& s, const GroundAtom& atom) const {
    switch (atom.predicate) {
        case beside_table:
            return s[beside] == atom.objects[0];
        case beside_ball:
            return s[beside] == kBesideBall;
        case beside_ring:
            return s[beside] == kBesideRing;
        case hand_empty:
            return is_hand_empty(s);
        case holding_ball:
            return holds_ball(s);
        case holding_ring:
            return holds_ring(s);
        case ball_on:
            return s[ball_at] == atom.objects[0];
        case ball_on_floor:
            return s[ball_at] == kFloor;
        case ball_in_ring:
            return s[ball_inside] != 0;
        case ball_free:
            return s[ball_inside] == 0;
        case ring_on:
            return s[ring_at] == atom.objects[0];
        default:
            return s[ring_at] == kFloor;
    }
}

bool BallRing::can_start(const State& s, const GroundSkill& skill) const {
    const double table = skill.objects.empty() ? -1 : skill.objects[0];
    const bool inside = s[ball_inside] != 0;
    switch (skill.schema) {
        case pick_ball_from_table:
            return s[beside] == table && is_hand_empty(s) && s[ball_at] == table && !inside;
        case pick_ball_from_floor:
            return s[beside] == kBesideBall && is_hand_empty(s) && s[ball_at] == kFloor;
        case pick_ring_from_table:
            return s[beside] == table && is_hand_empty(s) && s[ring_at] == table && !inside;
        case pick_ring_with_ball_from_table:
            return s[beside] == table && is_hand_empty(s) && s[ring_at] == table && inside;
        case pick_ring_from_floor:
            return s[beside] == kBesideRing && is_hand_empty(s) && s[ring_at] == kFloor && !inside;
        case pick_ring_with_ball_from_floor:
            return s[beside] == kBesideRing && is_hand_empty(s) && s[ring_at] == kFloor && inside;
        case place_ball_on_table:
            return s[beside] == table && holds_ball(s);
        case place_ball_on_floor:
            return holds_ball(s);
        case place_ball_in_ring_on_table:
            return s[beside] == kBesideRing && s[ring_at] == table && holds_ball(s);
        case place_ball_in_ring_on_floor:
            return s[beside] == kBesideRing && s[ring_at] == kFloor && holds_ball(s);
        case place_ring_on_table:
            return s[beside] == table && holds_ring(s) && !inside;
        case place_ring_on_floor:
            return holds_ring(s) && !inside;
        case place_ring_with_ball_on_floor:
            return holds_ring(s) && inside;
        default:
            return true;
    }
}

void BallRing::act(State& s, const GroundSkill& skill, std::span<const double> parameters,
                   Random& random) const {
    const std::int32_t table = skill.objects.empty() ? -1 : skill.objects[0];
    switch (skill.schema) {
        case navigate_to_table:
            return move_robot(s, table, table_centre(table), kTableRadius, random);
        case navigate_to_ball:
            return move_robot(s, kBesideBall, {s[ball_x], s[ball_y]}, kBallRadius, random);
        case navigate_to_ring:
            return move_robot(s, kBesideRing, {s[ring_x], s[ring_y]}, kRingRadius, random);
        case pick_ball_from_table:
        case pick_ball_from_floor:
            return pick_ball(s);
        case pick_ring_from_table:
        case pick_ring_with_ball_from_table:
        case pick_ring_from_floor:
        case pick_ring_with_ball_from_floor:
            return pick_ring(s);
        case place_ball_on_table:
            return put_ball(s, kFloor, floor_beside(table, random));
        case place_ball_in_ring_on_table:
        case place_ball_in_ring_on_floor:
            return put_ball_into_ring(s);
        case place_ball_on_floor:
            put_ball(s, kFloor, centre_of_room(random));
            if (s[beside] == kBesideBall) s[beside] = kBesideNothing;
            return;
        case place_ring_on_table: {
            Point p{parameters[0], parameters[1]};
            if (features_ == Features::relative) p = p + table_centre(table) + disc_offset(s, table);
            if (ring_stays(s, table, p)) return put_ring(s, table, p);
            return put_ring(s, kFloor, floor_beside(table, random));
        }
        default:
            put_ring(s, kFloor, centre_of_room(random));
            if (s[beside] == kBesideRing || (s[beside] == kBesideBall && s[ball_inside] != 0))
                s[beside] = kBesideNothing;
            return;
    }
}

void BallRing::draw_parameters(const State& s, const GroundSkill& skill, Random& random,
                               std::span<double> parameters) const {
    const std::int32_t table = skill.objects[0];
    const double radius = skill.schema == place_ring_on_table ? kRingRadius : kBallRadius;
    const Point offset = around(random, 0, kTableRadius - 2 * radius);
    const Point p =
        features_ == Features::relative ? offset - disc_offset(s, table) : offset + table_centre(table);
    parameters[0] = p.x;
    parameters[1] = p.y;
}

void BallRing::write_features(const State& s, const GroundSkill& skill, std::span<double> features) const {
    const std::int32_t table = skill.objects[0];
    const double smooth = table == 0 ? 1 : 0;
    if (features_ == Features::relative) {
        features[0] = smooth;
        features[1] = kDiscRadius;
        return;
    }
    const Point centre = table_centre(table);
    const Point disc = disc_offset(s, table);
    const std::array<double, 17> all = {s[robot_x],   s[robot_y],
                                        s[ball_x],    s[ball_y],
                                        kBallRadius,  s[ball_at] == kHand ? 1.0 : 0.0,
                                        s[ring_x],    s[ring_y],
                                        kRingRadius,  s[ring_at] == kHand ? 1.0 : 0.0,
                                        centre.x,     centre.y,
                                        kTableRadius, smooth,
                                        disc.x,       disc.y,
                                        kDiscRadius};
    std::copy(all.begin(), all.end(), features.begin());
}

}  // namespace praxis::practice
