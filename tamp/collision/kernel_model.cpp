#include "tamp/collision/kernel_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>

#include "tamp/collision/signed_distance.hpp"
#include "tamp/geometry/cover.hpp"
#include "tamp/geometry/extent.hpp"
#include "tamp/scenes/occupancy_map.hpp"

namespace praxis::tamp {

namespace {

/// Prismatic variables without limits are taken to stay within this of 0 (metres).
constexpr double kTravel = 100;
/// Obstacles are dropped if they are farther than this out of reach (metres); more than any margin.
constexpr double kReachPadding = 0.01;

/// A rigid set of balls before it is flattened.
struct Piece {
    Participant who = {};
    int carrier = 0;  ///< the link itself, or the one that a body is attached to
    int frame = 0;
    std::vector<Ball> balls = {};  ///< in the frame
    std::vector<BallClusters::Cluster> clusters = {};
    Ball bound = {};
    Ball range = {};     ///< where the centres of its balls can get
    double largest = 0;  ///< radius of a ball
};

/// Something that stands still.
struct Standing {
    Participant who = {};
    Pose pose = Pose::Identity();
    const Shape* shape = nullptr;
    std::optional<kernel::Obstacle> primitive = {};
    AxisBox box = {};  ///< around the primitive, in the world
};

struct PlacedLink {
    int frame = -1;
    Pose pose = Pose::Identity();  ///< in the frame
};

Eigen::Matrix3d turn_z_to(const Vector3& axis) {
    return Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), axis).toRotationMatrix();
}

void copy_rows(const Eigen::Matrix3d& rows, float* to) {
    for (int i = 0; i < 9; ++i) to[i] = static_cast<float>(rows(i / 3, i % 3));
}

void copy(const Vector3& vector, float* to) {
    for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(vector[i]);
}

kernel::Ball flat(const Ball& ball, double radius) {
    kernel::Ball result = {};
    copy(ball.center, result.center);
    result.radius = static_cast<float>(radius);
    return result;
}

/// The primitive as the kernel sees it; none for meshes and maps.
struct Flatten {
    bool upright = false;

    using Result = std::optional<kernel::Obstacle>;
    Result operator()(const Sphere& s) const { return make(kernel::sphere, {s.radius, 0, 0}); }
    Result operator()(const Box& b) const {
        return make(upright ? kernel::upright_box : kernel::box, b.size / 2);
    }
    Result operator()(const Cylinder& c) const {
        return make(upright ? kernel::upright_cylinder : kernel::cylinder, {c.radius, c.length / 2, 0});
    }
    Result operator()(const Capsule& c) const { return make(kernel::capsule, {c.radius, c.length / 2, 0}); }
    Result operator()(const std::shared_ptr<const Mesh>&) const { return std::nullopt; }
    Result operator()(const std::shared_ptr<const OccupancyMap>&) const { return std::nullopt; }

    static kernel::Obstacle make(kernel::ObstacleKind kind, const Vector3& size) {
        kernel::Obstacle result = {};
        result.kind = kind;
        copy(size, result.size);
        return result;
    }
};

std::optional<kernel::Obstacle> flatten_at(const Shape& shape, const Pose& pose) {
    const bool upright =
        std::abs(pose.linear()(2, 2)) > 1 - 1e-15 && pose.linear().col(2).head<2>().norm() < 1e-9;
    std::optional<kernel::Obstacle> result = std::visit(Flatten{upright}, shape);
    if (!result) return result;
    copy(pose.translation(), result->center);
    copy_rows(pose.linear().transpose(), result->axes);
    return result;
}

/// Rotations by quarter turns cost the kernel next to nothing. Robot descriptions round their angles.
void note_quarters(kernel::Frame& frame) {
    constexpr float kRounding = 1e-8F;
    for (int column = 0; column < 3; ++column) {
        int ones = 0;
        for (int row = 0; row < 3; ++row) {
            const float x = frame.rotation[3 * row + column];
            if (std::abs(x) < kRounding) continue;
            if (std::abs(std::abs(x) - 1) > kRounding) return;
            frame.source[column] = row;
            frame.sign[column] = std::copysign(1.0F, x);
            ++ones;
        }
        if (ones != 1) return;
    }
    frame.by_quarters = 1;
}

}  // namespace

class KernelModelBuilder {
  public:
    KernelModelBuilder(const CollisionProblem& problem, BallSide side, SolidCache& cache, KernelModel& model)
        : clusters_(cache.clusters(problem.robot)),
          robot_(*problem.robot),
          world_(*problem.world),
          group_(robot_.groups[static_cast<std::size_t>(problem.group)]),
          rest_(problem.rest),
          side_(side),
          cache_(cache),
          model_(model) {}

    void build() {
        model_.variable_count_ = static_cast<int>(group_.variables.size());
        place_links();
        collect_pieces();
        if (pieces_.size() > kernel::kMaxParts) {
            throw std::invalid_argument(
                "the fast checker takes at most 256 moving links and attached bodies");
        }
        collect_standing();
        drop_unreachable();
        merge_pieces();
        model_.margin_ = std::ldexp(1.0, -20) * (static_cast<double>(model_.frames_.size()) + 2) * farthest();
        flatten_pieces();
        flatten_levers();
        flatten_turns();
        pair_pieces();
    }

  private:
    int place_of(int variable) const {
        const auto found = std::ranges::find(group_.variables, variable);
        return found == group_.variables.end() ? -1 : static_cast<int>(found - group_.variables.begin());
    }

    double rest_position(const Joint& joint) const {
        return joint.multiplier * rest_[static_cast<std::size_t>(joint.variable)] + joint.offset;
    }

    void place_links() {
        links_.resize(robot_.links.size());
        links_[0].pose = robot_.base;
        for (const Joint& joint : robot_.joints) {
            const PlacedLink& parent = links_[static_cast<std::size_t>(joint.parent)];
            PlacedLink& child = links_[static_cast<std::size_t>(joint.child)];
            child = {parent.frame, parent.pose * joint.origin};
            if (joint.variable < 0) continue;
            const Eigen::Matrix3d turn = turn_z_to(joint.axis);
            const int variable = place_of(joint.variable);
            if (variable >= 0) {
                add_frame(joint, child, turn, variable);
                child = {static_cast<int>(model_.frames_.size()) - 1, Pose(turn.transpose())};
            } else if (joint.type == JointType::prismatic) {
                child.pose.translate(rest_position(joint) * joint.axis);
            } else {
                child.pose.rotate(Eigen::AngleAxisd(rest_position(joint), joint.axis));
            }
        }
    }

    void add_frame(const Joint& joint, const PlacedLink& at, const Eigen::Matrix3d& turn, int variable) {
        kernel::Frame frame = {};
        frame.parent = at.frame;
        frame.variable = variable;
        frame.prismatic = joint.type == JointType::prismatic ? 1 : 0;
        frame.multiplier = static_cast<float>(joint.multiplier);
        frame.offset = static_cast<float>(joint.offset);
        copy_rows(at.pose.linear() * turn, frame.rotation);
        copy(at.pose.translation(), frame.translation);
        note_quarters(frame);
        model_.frames_.push_back(frame);
        joints_.push_back(&joint);
        translations_.push_back(at.pose.translation());
    }

    void add_piece(Participant who, int carrier, const Pose& in_link, const BallClusters& clusters,
                   bool has_cover, const std::string& name) {
        if (!clusters.exact && !has_cover)
            throw std::invalid_argument("'" + name + "' has shapes but no balls that cover them");
        model_.exact_ = model_.exact_ && clusters.exact;
        if (clusters.balls.empty()) return;
        const PlacedLink& link = links_[static_cast<std::size_t>(carrier)];
        const Pose pose = link.pose * in_link;
        Piece piece = {.who = who, .carrier = carrier, .frame = link.frame};
        const auto moved = [&](const Ball& ball) { return Ball{pose * ball.center, ball.radius}; };
        piece.balls.reserve(clusters.balls.size());
        for (const Ball& ball : clusters.balls) piece.balls.push_back(moved(ball));
        for (const auto& cluster : clusters.clusters)
            piece.clusters.push_back({moved(cluster.bound), cluster.ball_count});
        piece.bound = moved(clusters.bound);
        measure(piece);
        pieces_.push_back(std::move(piece));
    }

    bool moves(int link) const { return links_[static_cast<std::size_t>(link)].frame >= 0; }

    /// The far end of the robot first: it collides most often.
    void collect_pieces() {
        for (int b = static_cast<int>(world_.size()) - 1; b >= 0; --b) {
            const BodyState& body = world_[b];
            if (!body.attachment || !moves(body.attachment->link)) continue;
            add_piece({Participant::Kind::body, b}, body.attachment->link, body.attachment->in_link,
                      (*cache_.clusters(body.model))[side_], !body.model->balls.empty(), body.model->name);
        }
        for (int l = static_cast<int>(robot_.links.size()) - 1; l >= 0; --l) {
            const Link& link = robot_.links[static_cast<std::size_t>(l)];
            if (!moves(l)) continue;
            add_piece({Participant::Kind::link, l}, l, Pose::Identity(),
                      (*clusters_)[static_cast<std::size_t>(l)][side_], !link.balls.empty(), link.name);
        }
    }

    void add_standing(Participant who, const Pose& pose, const std::vector<PlacedShape>& shapes) {
        for (const PlacedShape& placed : shapes) {
            Standing& standing = standing_.emplace_back();
            standing = {.who = who, .pose = pose * placed.pose, .shape = &placed.shape};
            standing.primitive = flatten_at(placed.shape, standing.pose);
            if (standing.primitive) standing.box = extent(placed, pose);
        }
    }

    void collect_standing() {
        for (int b = 0; b < static_cast<int>(world_.size()); ++b) {
            const BodyState& body = world_[b];
            const Participant who = {Participant::Kind::body, b};
            if (!body.attachment) {
                add_standing(who, body.pose, body.model->shapes);
            } else if (const PlacedLink& link = links_[static_cast<std::size_t>(body.attachment->link)];
                       link.frame < 0) {
                add_standing(who, link.pose * body.attachment->in_link, body.model->shapes);
            }
        }
        for (int l = 0; l < static_cast<int>(robot_.links.size()); ++l) {
            const PlacedLink& link = links_[static_cast<std::size_t>(l)];
            if (link.frame >= 0) continue;
            add_standing({Participant::Kind::link, l}, link.pose,
                         robot_.links[static_cast<std::size_t>(l)].collision);
        }
    }

    void drop_unreachable() {
        std::erase_if(standing_, [&](const Standing& standing) {
            return std::ranges::none_of(pieces_, [&](const Piece& p) { return reachable(p, standing); });
        });
    }

    /// Pieces that move together and may touch the same become one.
    void merge_pieces() {
        std::vector<Piece> merged;
        for (Piece& piece : pieces_) {
            const auto alike =
                std::ranges::find_if(merged, [&](const Piece& m) { return are_alike(m, piece); });
            if (alike == merged.end()) {
                merged.push_back(std::move(piece));
                continue;
            }
            alike->balls.insert(alike->balls.end(), piece.balls.begin(), piece.balls.end());
            alike->clusters.insert(alike->clusters.end(), piece.clusters.begin(), piece.clusters.end());
            alike->bound = bounding_ball(alike->bound, piece.bound);
            alike->range.radius = std::max(alike->range.radius, piece.range.radius);
            alike->largest = std::max(alike->largest, piece.largest);
        }
        pieces_ = std::move(merged);
    }

    bool are_alike(const Piece& first, const Piece& second) const {
        if (first.frame != second.frame) return false;
        const auto same = [&](const auto& other) {
            return may_touch(first, other.who) == may_touch(second, other.who);
        };
        if (!std::ranges::all_of(standing_, same)) return false;
        return std::ranges::all_of(
            pieces_, [&](const Piece& other) { return other.frame == first.frame || same(other); });
    }

    /// How far the origin of a frame slides at most.
    double travel(std::size_t frame) const {
        const Joint& joint = *joints_[frame];
        if (joint.type != JointType::prismatic) return 0;
        const Variable& variable = robot_.variables[static_cast<std::size_t>(joint.variable)];
        const double lower = std::isfinite(variable.lower) ? std::abs(variable.lower) : kTravel;
        const double upper = std::isfinite(variable.upper) ? std::abs(variable.upper) : kTravel;
        return std::abs(joint.multiplier) * std::max(lower, upper) + std::abs(joint.offset);
    }

    /// How far a grid begins from the origin of its shape.
    double offset(const Standing& standing) const {
        Vector3 corner = Vector3::Zero();
        if (const auto* map = std::get_if<std::shared_ptr<const OccupancyMap>>(standing.shape)) {
            const std::array<double, 3>& origin = (*map)->grid().origin;
            corner = {origin[0], origin[1], origin[2]};
        } else if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(standing.shape)) {
            for (const Vector3& vertex : (*mesh)->vertices) corner = corner.cwiseMax(vertex.cwiseAbs());
        }
        return corner.norm();
    }

    /// The chain hangs on a fixed point; how far from it do the balls' centres come?
    void measure(Piece& piece) const {
        double radius = 0;
        for (const Ball& ball : piece.balls) {
            radius = std::max(radius, ball.center.norm());
            piece.largest = std::max(piece.largest, ball.radius);
        }
        int frame = piece.frame;
        while (true) {
            const std::size_t at = static_cast<std::size_t>(frame);
            radius += travel(at);
            if (model_.frames_[at].parent < 0) {
                piece.range = {translations_[at], radius};
                return;
            }
            radius += translations_[at].norm();
            frame = model_.frames_[at].parent;
        }
    }

    /// How far anything that can matter is from the world's origin.
    double farthest() const {
        double farthest = 0;
        for (const Piece& piece : pieces_) {
            farthest =
                std::max(farthest, piece.range.center.norm() + piece.range.radius + piece.bound.radius);
        }
        double center = farthest;
        for (const Standing& standing : standing_) {
            center = std::max(center, standing.pose.translation().norm() + offset(standing));
        }
        return farthest + center;
    }

    double sized(double radius) const {
        return side_ == BallSide::outer ? radius + model_.margin_ : radius - model_.margin_;
    }

    void flatten_pieces() {
        for (Piece& piece : pieces_) {
            kernel::Part part = {};
            part.frame = piece.frame;
            part.bound = flat(piece.bound, piece.bound.radius + model_.margin_);
            part.spread = spread(piece);
            part.first_cluster = static_cast<int>(model_.clusters_.size());
            flatten_balls(piece);
            part.cluster_count = static_cast<int>(model_.clusters_.size()) - part.first_cluster;
            collect_obstacles(piece, part);
            model_.parts_.push_back(part);
            add_levers(piece);
        }
    }

    float spread(const Piece& piece) const {
        double farthest = 0;
        for (const Ball& ball : piece.balls) {
            farthest = std::max(farthest, (ball.center - piece.bound.center).norm());
        }
        return static_cast<float>(farthest + model_.margin_);
    }

    void flatten_balls(const Piece& piece) {
        auto ball = piece.balls.begin();
        for (const BallClusters::Cluster& from : piece.clusters) {
            kernel::Cluster cluster = {};
            cluster.bound = flat(from.bound, from.bound.radius + model_.margin_);
            cluster.first_ball = static_cast<int>(model_.balls_.size());
            for (const auto end = ball + static_cast<std::ptrdiff_t>(from.ball_count); ball != end; ++ball) {
                if (sized(ball->radius) > 0) model_.balls_.push_back(flat(*ball, sized(ball->radius)));
            }
            cluster.ball_count = static_cast<int>(model_.balls_.size()) - cluster.first_ball;
            model_.clusters_.push_back(cluster);
        }
    }

    bool may_touch(const Piece& piece, const Participant& other) const {
        if (world_.allowed(piece.who, other)) return true;
        if (other.kind == Participant::Kind::body) {
            if (piece.who.kind == Participant::Kind::body) return false;
            const std::optional<Attachment>& attachment = world_[other.index].attachment;
            return attachment && touches_carrier(*attachment, piece.who.index);
        }
        if (piece.who.kind == Participant::Kind::link)
            return !robot_.may_collide(piece.who.index, other.index);
        return touches_carrier(*world_[piece.who.index].attachment, other.index);
    }

    static bool touches_carrier(const Attachment& attachment, int link) {
        return attachment.link == link ||
               std::ranges::find(attachment.touching, link) != attachment.touching.end();
    }

    bool reachable(const Piece& piece, const Standing& standing) const {
        const double gap = signed_distance(*standing.shape, standing.pose.inverse() * piece.range.center);
        return !std::isfinite(gap) || gap <= piece.range.radius + piece.largest + kReachPadding;
    }

    void collect_obstacles(const Piece& piece, kernel::Part& part) {
        std::vector<kernel::Grid> grids;
        part.first_boxes = static_cast<int>(model_.boxes_.size());
        std::size_t count = 0;
        for (const Standing& standing : standing_) {
            if (may_touch(piece, standing.who) || !reachable(piece, standing)) continue;
            if (standing.primitive) {
                add_obstacle(standing, count++ % kernel::kLanes);
            } else {
                grids.push_back(grid_of(standing));
            }
        }
        part.boxes_count = static_cast<int>(model_.boxes_.size()) - part.first_boxes;
        part.first_grid = static_cast<int>(model_.grids_.size());
        part.grid_count = static_cast<int>(grids.size());
        model_.grids_.insert(model_.grids_.end(), grids.begin(), grids.end());
    }

    void add_obstacle(const Standing& standing, std::size_t lane) {
        constexpr float kNowhere = 1e30F;
        if (lane == 0) {
            model_.obstacles_.resize(model_.obstacles_.size() + kernel::kLanes);
            kernel::ObstacleBoxes& boxes = model_.boxes_.emplace_back();
            for (std::size_t i = 0; i < 3; ++i) {
                std::ranges::fill(boxes.lower[i], kNowhere);
                std::ranges::fill(boxes.upper[i], -kNowhere);
            }
        }
        model_.obstacles_[model_.obstacles_.size() - kernel::kLanes + lane] = *standing.primitive;
        for (int i = 0; i < 3; ++i) {
            model_.boxes_.back().lower[i][lane] = static_cast<float>(standing.box.lower[i] - model_.margin_);
            model_.boxes_.back().upper[i][lane] = static_cast<float>(standing.box.upper[i] + model_.margin_);
        }
    }

    kernel::Grid grid_of(const Standing& standing) {
        const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(standing.shape);
        model_.distances_.push_back(
            mesh != nullptr
                ? cache_.distances(*mesh)
                : cache_.distances(std::get<std::shared_ptr<const OccupancyMap>>(*standing.shape)));
        model_.exact_ = false;
        const DistanceGrid& distances = *model_.distances_.back();
        const VoxelGrid& voxels = distances.grid();
        kernel::Grid grid = {};
        copy_rows(standing.pose.linear().transpose(), grid.axes);
        const Vector3 origin = {voxels.origin[0], voxels.origin[1], voxels.origin[2]};
        copy(standing.pose.linear().transpose() * standing.pose.translation() + origin, grid.corner);
        grid.edge = static_cast<float>(voxels.edge);
        std::ranges::copy(voxels.cells, grid.cells);
        grid.distance = distances.distances().data();
        // Across the cell that a point is in, and, in a mesh's, across the filled one, too; and some more.
        const double diagonals = mesh != nullptr ? 3 : 2;
        if (side_ == BallSide::inner) grid.slack = static_cast<float>(diagonals * std::sqrt(3) * voxels.edge);
        return grid;
    }

    /// A turn about an axis moves a point by its distance from the axis: at most the distance, across the
    /// axis, of the next frame's origin, and then along the chain.
    void add_levers(const Piece& piece) {
        std::vector<double> levers(group_.variables.size(), 0.0);
        double beyond = 0;
        double across = 0;
        for (const Ball& ball : piece.balls) {
            beyond = std::max(beyond, ball.center.norm());
            across = std::max(across, ball.center.head<2>().norm());
        }
        for (int frame = piece.frame; frame >= 0;) {
            const std::size_t at = static_cast<std::size_t>(frame);
            const kernel::Frame& flat_frame = model_.frames_[at];
            const double multiplier = std::abs(joints_[at]->multiplier);
            levers[static_cast<std::size_t>(flat_frame.variable)] +=
                multiplier * (flat_frame.prismatic == 0      ? across
                              : is_turned(flat_frame.parent) ? 2
                                                             : 1);
            const double slide = travel(at);
            across = translations_[at].head<2>().norm() + slide + beyond;
            beyond = translations_[at].norm() + slide + beyond;
            frame = flat_frame.parent;
        }
        levers_.push_back(std::move(levers));
    }

    /// Whether a variable turns the frame.
    bool is_turned(int frame) const {
        for (; frame >= 0; frame = model_.frames_[static_cast<std::size_t>(frame)].parent) {
            if (model_.frames_[static_cast<std::size_t>(frame)].prismatic == 0) return true;
        }
        return false;
    }

    /// By each variable, along the chain of frames that it turns most.
    void flatten_turns() {
        const std::size_t variables = group_.variables.size();
        model_.turns_.assign(variables, 0.0F);
        std::vector<float> turns(model_.frames_.size() * variables, 0.0F);
        for (std::size_t f = 0; f < model_.frames_.size(); ++f) {
            const kernel::Frame& frame = model_.frames_[f];
            const std::size_t parent = static_cast<std::size_t>(std::max(frame.parent, 0));
            for (std::size_t v = 0; v < variables; ++v) {
                float& turn = turns[f * variables + v];
                if (frame.parent >= 0) turn = turns[parent * variables + v];
                if (frame.prismatic == 0 && frame.variable == static_cast<int>(v))
                    turn += std::abs(frame.multiplier);
                model_.turns_[v] = std::max(model_.turns_[v], turn * 1.00001F);
            }
        }
    }

    void flatten_levers() {
        constexpr double kRoundUp = 1 + 1e-5;  // for the sums on floats, too
        const std::size_t blocks =
            static_cast<std::size_t>(kernel::lever_stride(static_cast<int>(levers_.size()))) / kernel::kLanes;
        model_.levers_.resize(blocks * group_.variables.size());
        for (std::size_t v = 0; v < group_.variables.size(); ++v) {
            for (std::size_t p = 0; p < levers_.size(); ++p) {
                model_.levers_[v * blocks + p / kernel::kLanes].lever[p % kernel::kLanes] =
                    static_cast<float>(levers_[p][v] * kRoundUp);
            }
        }
    }

    void pair_pieces() {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            for (std::size_t j = i + 1; j < pieces_.size(); ++j) {
                if (pieces_[i].frame == pieces_[j].frame || may_touch(pieces_[i], pieces_[j].who)) continue;
                model_.pairs_.push_back({static_cast<int>(i), static_cast<int>(j)});
            }
        }
    }

    std::shared_ptr<const std::vector<CoveringClusters>> clusters_;  ///< of the links
    const Robot& robot_;
    const World& world_;
    const Group& group_;
    const Configuration& rest_;
    BallSide side_;
    SolidCache& cache_;
    KernelModel& model_;
    std::vector<PlacedLink> links_ = {};
    std::vector<const Joint*> joints_ = {};   ///< of every frame
    std::vector<Vector3> translations_ = {};  ///< of every frame in its parent
    std::vector<Piece> pieces_ = {};
    std::vector<Standing> standing_ = {};
    std::vector<std::vector<double>> levers_ = {};  ///< of every part, by variable
};

KernelModel::KernelModel(const CollisionProblem& problem, BallSide side, SolidCache& cache) {
    if (problem.robot->groups[static_cast<std::size_t>(problem.group)].variables.size() >
        kernel::kMaxVariables) {
        throw std::invalid_argument("the fast checker takes groups of at most 16 variables");
    }
    KernelModelBuilder(problem, side, cache, *this).build();
}

kernel::Model KernelModel::view() const {
    return {.variable_count = variable_count_,
            .frame_count = static_cast<int>(frames_.size()),
            .part_count = static_cast<int>(parts_.size()),
            .cluster_count = static_cast<int>(clusters_.size()),
            .pair_count = static_cast<int>(pairs_.size()),
            .frames = frames_.data(),
            .parts = parts_.data(),
            .clusters = clusters_.data(),
            .balls = balls_.data(),
            .obstacles = obstacles_.data(),
            .boxes = boxes_.data(),
            .grids = grids_.data(),
            .pairs = pairs_.data(),
            .levers = levers_.empty() ? nullptr : levers_.front().lever.data(),
            .turns = turns_.data()};
}

}  // namespace praxis::tamp
