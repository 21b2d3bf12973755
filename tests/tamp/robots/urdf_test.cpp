#include "tamp/robots/urdf.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "parser/diagnostic.hpp"
#include "parser/files.hpp"

namespace praxis::tamp {
namespace {

Robot parse(const std::string& inside, const RobotOptions& options = {}) {
    return parse_urdf({"r.urdf", "<robot name=\"r\">\n" + inside + "\n</robot>"}, options);
}

std::string message_of(const std::string& inside, const RobotOptions& options = {}) {
    try {
        parse(inside, options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string link(const std::string& name, const std::string& geometry = "") {
    if (geometry.empty()) return "<link name=\"" + name + "\"/>\n";
    return "<link name=\"" + name + "\"><collision><geometry>" + geometry +
           "</geometry></collision></link>\n";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& more = "") {
    return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/>" + more + "</joint>\n";
}

const std::string kLimit = "<limit lower=\"-1\" upper=\"2\" effort=\"1\" velocity=\"3\"/>";
const std::string kAB = link("a") + link("b");

TEST(Urdf, ThePandaOfSpheresHas59) {
    const std::filesystem::path file =
        std::filesystem::path(PRAXIS_SOURCE_DIR) / "../shared/data/mbm_panda/panda_spheres.urdf";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
    const Robot robot = read_urdf(file.string());
    std::size_t spheres = 0;
    std::size_t balls = 0;
    for (const Link& part : robot.links) {
        for (const PlacedShape& placed : part.collision)
            spheres += std::holds_alternative<Sphere>(placed.shape);
        balls += part.balls.size();
        for (const Ball& ball : part.balls) {
            EXPECT_LE((ball.center - part.bound.center).norm() + ball.radius, part.bound.radius + 1e-12);
        }
    }
    EXPECT_EQ(spheres, 59U);
    EXPECT_EQ(balls, 59U);
    EXPECT_EQ(robot.name, "panda");
    EXPECT_EQ(robot.links.size(), 13U);
    ASSERT_GE(robot.variables.size(), 7U);
    EXPECT_EQ(robot.variables[3].name, "panda_joint4");
    EXPECT_NEAR(robot.variables[3].lower, -3.07, 0.03);
}

TEST(Urdf, JointsOfEveryKind) {
    const Robot robot =
        parse(link("a") + link("b") + link("c") + link("d") + link("e") +
              joint("turn", "revolute", "a", "b", "<axis xyz=\"0 0 2\"/>" + kLimit) +
              joint("wheel", "continuous", "b", "c", "<origin xyz=\"1 2 3\" rpy=\"0 0 1\"/>") +
              joint("slide", "prismatic", "c", "d", "<axis xyz=\"0 1 0\"/>" + kLimit) +
              joint("stay", "fixed", "d", "e"));
    ASSERT_EQ(robot.variables.size(), 3U);
    EXPECT_EQ(robot.joints[0].axis, Vector3::UnitZ());
    EXPECT_EQ(robot.variables[0].lower, -1);
    EXPECT_EQ(robot.variables[0].upper, 2);
    EXPECT_EQ(robot.variables[0].max_velocity, 3);
    EXPECT_EQ(robot.variables[0].max_acceleration, 3 / kDefaultAccelerationTime);
    EXPECT_TRUE(robot.variables[1].continuous);
    EXPECT_EQ(robot.variables[1].max_velocity, kDefaultVelocity);
    EXPECT_EQ(robot.joints[1].origin.translation(), Vector3(1, 2, 3));
    EXPECT_EQ(robot.joints[2].type, JointType::prismatic);
    EXPECT_EQ(robot.joints[3].variable, -1);
    EXPECT_FALSE(robot.may_collide(0, 1));
    EXPECT_TRUE(robot.may_collide(0, 2));
}

TEST(Urdf, MimicJointsFollowTheirMastersMaster) {
    const Robot robot = parse(link("a") + link("b") + link("c") + link("d") +
                              joint("third", "prismatic", "a", "d",
                                    kLimit + "<mimic joint=\"second\" multiplier=\"-1\" offset=\"0.5\"/>") +
                              joint("second", "prismatic", "a", "c",
                                    kLimit + "<mimic joint=\"first\" multiplier=\"2\" offset=\"0.25\"/>") +
                              joint("first", "prismatic", "a", "b", kLimit));
    ASSERT_EQ(robot.variables.size(), 1U);
    EXPECT_EQ(robot.variables[0].name, "first");
    // -1 * (2 q + 0.25) + 0.5
    EXPECT_EQ(robot.joints[0].multiplier, -2);
    EXPECT_EQ(robot.joints[0].offset, 0.25);
    EXPECT_EQ(robot.joints[0].variable, 0);
}

TEST(Urdf, PlanarJointsAreThree) {
    const Robot robot = parse(kAB + joint("base", "planar", "a", "b", "<axis xyz=\"0 0 1\"/>"));
    ASSERT_EQ(robot.variables.size(), 3U);
    EXPECT_EQ(robot.variables[0].name, "base/x");
    EXPECT_EQ(robot.variables[2].name, "base/theta");
    EXPECT_TRUE(robot.variables[2].continuous);
    const Pose pose = link_pose(robot, Configuration{1, 2, 0.5}, robot.find_link("b"));
    EXPECT_TRUE(pose.isApprox(pose_from_rpy({1, 2, 0}, {0, 0, 0.5}), 1e-12));
}

TEST(Urdf, ACylinderBetweenBallsIsACapsule) {
    const auto collision = [](const std::string& origin, const std::string& geometry) {
        return "<collision><origin xyz=\"" + origin + "\" rpy=\"0 1.5707963267948966 0\"/><geometry>" +
               geometry + "</geometry></collision>";
    };
    const Robot robot = parse(
        "<link name=\"a\">" + collision("1 0 0", "<cylinder radius=\"0.1\" length=\"0.4\"/>") +
        collision("1.2 0 0", "<sphere radius=\"0.1\"/>") + collision("5 0 0", "<sphere radius=\"0.1\"/>") +
        collision("0.8 0 0", "<sphere radius=\"0.1\"/>") + "</link>");
    const auto& shapes = robot.links[0].collision;
    ASSERT_EQ(shapes.size(), 2U);
    EXPECT_TRUE(std::holds_alternative<Sphere>(shapes[0].shape));
    ASSERT_TRUE(std::holds_alternative<Capsule>(shapes[1].shape));
    EXPECT_EQ(std::get<Capsule>(shapes[1].shape).length, 0.4);
}

TEST(Urdf, MeshesAreFoundInPackages) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "praxis_urdf_test";
    std::filesystem::create_directories(folder / "things/meshes");
    std::ofstream(folder / "things/meshes/plate.obj") << "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    std::ofstream(folder / "things/meshes/broken.stl") << "solid nothing";
    const auto mesh = [](const std::string& uri) {
        return link("a", "<mesh filename=\"" + uri + "\" scale=\"2 2 2\"/>");
    };
    for (const std::string place : {"", "things"}) {
        const Robot robot =
            parse(mesh("package://things/meshes/plate.obj"), {.packages = {(folder / place).string()}});
        ASSERT_EQ(robot.links[0].collision.size(), 1U);
        const auto& plate = std::get<std::shared_ptr<const Mesh>>(robot.links[0].collision[0].shape);
        EXPECT_EQ(plate->triangles.size(), 2U);
        Eigen::AlignedBox3d box;
        for (const Vector3& vertex : plate->vertices) box.extend(vertex);
        EXPECT_EQ(box.sizes(), Vector3(2, 2, 0));
        EXPECT_GE(robot.links[0].bound.radius, std::sqrt(2.0));
    }
    EXPECT_NE(message_of(mesh("package://things/meshes/plate.obj")).find("no package has"),
              std::string::npos);
    const std::string broken = message_of(mesh((folder / "things/meshes/broken.stl").string()));
    EXPECT_NE(broken.find("link 'a'"), std::string::npos) << broken;
    EXPECT_NE(broken.find("broken.stl"), std::string::npos) << broken;
    const std::string missing = message_of(mesh("nowhere.stl"));
    EXPECT_NE(missing.find("nowhere.stl: there is no such file"), std::string::npos) << missing;
    EXPECT_NE(message_of(mesh("nowhere.xyz")).find("no such file"), std::string::npos);
    // A picture may be missing.
    const Robot bare =
        parse("<link name=\"a\"><visual><geometry><mesh filename=\"no.stl\"/></geometry></visual></link>");
    EXPECT_TRUE(bare.links[0].visual.empty());
    std::filesystem::remove_all(folder);
}

TEST(Urdf, BrokenFilesAreRefusedWithPlaceAndMend) {
    struct Case {
        std::string inside;
        std::vector<std::string> words;
    };
    const std::string sphere = "<sphere radius=\"1\"/>";
    const std::string bc = link("a") + link("b") + link("c");
    const std::vector<Case> cases = {
        {"<link name=\"a\">", {"r.urdf:", "well-formed"}},
        {"", {"no <link>"}},
        {"<link/>", {"r.urdf:2", "'name'"}},
        {link("a") + link("a"), {"r.urdf:3", "another link named 'a'"}},
        {kAB, {"r.urdf:3", "'a' and 'b'", "one root"}},
        {kAB + joint("j", "fixed", "a", "b") + joint("j", "fixed", "b", "a"), {"another joint named 'j'"}},
        {kAB + joint("j", "fixed", "a", "x"), {"r.urdf:4", "joint 'j'", "unknown link 'x'"}},
        {link("arm") + link("hand") + joint("j", "fixed", "arm", "hend"), {"did you mean 'hand'"}},
        {kAB + joint("j", "fixed", "a", "b") + joint("k", "fixed", "b", "a"), {"cycle"}},
        {bc + joint("j", "fixed", "b", "c") + joint("k", "fixed", "c", "b"), {"not connected", "cycle"}},
        {bc + joint("j", "fixed", "a", "c") + joint("k", "fixed", "b", "c"),
         {"'c' is the child of two", "'j'"}},
        {kAB + "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/></joint>", {"'j' has no <child>"}},
        {kAB + joint("j", "floating", "a", "b"), {"'j' floats", "planar"}},
        {kAB + joint("j", "ball", "a", "b"), {"r.urdf:4", "ball"}},
        {kAB + joint("j", "revolute", "a", "b"), {"r.urdf:4", "limits"}},
        {kAB +
             joint("j", "revolute", "a", "b", "<limit lower=\"2\" upper=\"1\" effort=\"1\" velocity=\"1\"/>"),
         {"'j' has a lower limit above"}},
        {kAB + joint("j", "revolute", "a", "b",
                     "<limit lower=\"nan\" upper=\"1\" effort=\"1\" velocity=\"1\"/>"),
         {"r.urdf:4", "nan"}},
        {kAB + joint("j", "prismatic", "a", "b", "<axis xyz=\"0 0 0\"/>" + kLimit), {"length zero"}},
        {kAB + joint("j", "fixed", "a", "b", "<origin xyz=\"1 2\"/>"), {"r.urdf:4", "3 expected"}},
        {kAB + joint("j", "prismatic", "a", "b", kLimit + "<mimic joint=\"z\"/>"), {"unknown joint 'z'"}},
        {kAB + joint("j", "prismatic", "a", "b", kLimit + "<mimic joint=\"j\"/>"), {"mimics itself"}},
        {bc + joint("j", "prismatic", "a", "b", kLimit + "<mimic joint=\"k\"/>") +
             joint("k", "fixed", "b", "c"),
         {"'k', which has no single variable"}},
        {link("a", "<sphere radius=\"-1\"/>"), {"r.urdf:2", "link 'a'", "radius"}},
        {link("a", "<sphere radius=\"nan\"/>"), {"r.urdf:2", "nan"}},
        {link("a", "<sphere radius=\"1e999\"/>"), {"1e999"}},
        {link("a", "<cylinder radius=\"1\" length=\"0\"/>"), {"link 'a'", "length"}},
        {link("a", "<box size=\"1 -1 1\"/>"), {"link 'a'", "box"}},
        {link("a", "<box size=\"1 1\"/>"), {"r.urdf:2", "3 expected"}},
        {link("a", "<cone/>"), {"r.urdf:2", "cone"}},
        {link("a", "<mesh filename=\"\"/>"), {"link 'a'", "mesh"}},
    };
    for (const Case& broken : cases) {
        const std::string message = message_of(broken.inside);
        for (const std::string& word : broken.words) {
            EXPECT_NE(message.find(word), std::string::npos) << "no " << word << " in: " << message;
        }
    }
}

TEST(Urdf, MoreThanARobotMayHaveIsRefused) {
    std::string chain = link("l0");
    for (int i = 1; i <= 70; ++i) {
        const std::string number = std::to_string(i);
        chain += link("l" + number) + joint("j" + number, "fixed", "l" + std::to_string(i - 1), "l" + number);
    }
    EXPECT_NE(message_of(chain).find("1 to 64 links"), std::string::npos);
    std::string deep;
    for (int i = 0; i < 100'000; ++i) deep += "<a>";
    EXPECT_NE(message_of(deep).find("nested"), std::string::npos);
    EXPECT_NE(message_of(std::string(std::size_t{17} << 20, ' ')).find("larger than 16 MiB"),
              std::string::npos);
}

TEST(Urdf, OtherFilesAreRefused) {
    EXPECT_THROW(parse_urdf({"r.urdf", ""}), InputError);
    EXPECT_THROW(parse_urdf({"r.urdf", "(define (domain d))"}), InputError);
    EXPECT_THROW(parse_urdf({"r.urdf", "<html/>"}), InputError);
    EXPECT_THROW(parse_urdf({"r.urdf", std::string("<robot name=\"r\">\0<link name=\"a\"/></robot>", 39)}),
                 InputError);
    EXPECT_THROW(read_urdf("/no/such/file.urdf"), InputError);
}

TEST(Urdf, LimitsAreOverriddenByName) {
    const std::string text = kAB + joint("slide", "prismatic", "a", "b", kLimit);
    const Robot robot =
        parse(text, {.limits = {.position = {{"slide", {0, 1}}}, .acceleration = {{"slide", 7}}}});
    EXPECT_EQ(robot.variables[0].lower, 0);
    EXPECT_EQ(robot.variables[0].upper, 1);
    EXPECT_EQ(robot.variables[0].max_velocity, 3);
    EXPECT_EQ(robot.variables[0].max_acceleration, 7);
    EXPECT_NE(message_of(text, {.limits = {.velocity = {{"slied", 1}}}}).find("did you mean 'slide'"),
              std::string::npos);
    EXPECT_NE(message_of(text, {.limits = {.velocity = {{"slide", -1}}}}).find("above 0"), std::string::npos);
}

TEST(Urdf, TruncatedAndSpoiltFilesNeverCrash) {
    const std::string text = "<robot name=\"r\">\n" + link("a", "<sphere radius=\"1\"/>") +
                             link("b", "<box size=\"1 2 3\"/>") +
                             joint("j", "revolute", "a", "b",
                                   "<origin xyz=\"1 2 3\" rpy=\"0 0 0\"/><axis xyz=\"0 0 1\"/>" + kLimit) +
                             "</robot>\n";
    ASSERT_EQ(parse_urdf({"r.urdf", text}).links.size(), 2U);
    const auto survives = [](const std::string& spoilt) {
        try {
            parse_urdf({"r.urdf", spoilt});
        } catch (const InputError&) {
            return true;
        }
        return false;
    };
    for (std::size_t length = 0; length + 9 < text.size(); ++length)
        EXPECT_TRUE(survives(text.substr(0, length)));
    for (const char wrong : {'<', '>', '"', '-', 'x', '&', '\x80'}) {
        for (std::size_t at = 0; at < text.size(); ++at) {
            std::string spoilt = text;
            spoilt[at] = wrong;
            survives(spoilt);
        }
    }
}

}  // namespace
}  // namespace praxis::tamp
