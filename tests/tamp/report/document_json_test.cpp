#include "tamp/report/document_json.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>
#include <nlohmann/json.hpp>

#include "parser/diagnostic.hpp"
#include "tests/tamp/samples/sample_document.hpp"

namespace praxis::tamp {
namespace {

using Json = nlohmann::json;

TrajectoryDocument read(const std::string& text) {
    return read_document({"plan.json", text});
}

/// What the reader says about the sample after a change; empty if it takes it.
std::string refusal(const std::string& pointer, const Json& value) {
    static const Json sample = Json::parse(to_json(sample_document()));
    Json json = sample;
    json[Json::json_pointer(pointer)] = value;
    try {
        read(json.dump());
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

std::string refusal_without(const std::string& owner, const std::string& member) {
    Json json = Json::parse(to_json(sample_document()));
    json[Json::json_pointer(owner)].erase(member);
    try {
        read(json.dump());
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

testing::AssertionResult says(const std::string& message, const std::string& part) {
    if (message.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << message << "' does not say '" << part << "'";
}

/// One link with a shape of each kind.
TrajectoryDocument all_shapes() {
    TrajectoryDocument document;
    TrajectoryDocument::Link link;
    link.name = "link";
    Mesh mesh{"wedge.stl", {{0, 0, 0}, {1.0 / 3, 0, 0}, {0, 0.1, 0}, {0, 0, 1e-7}}, {{0, 1, 2}, {0, 3, 1}}};
    link.shapes = {{TrajectoryDocument::kIdentity, Sphere{0.1}},
                   {TrajectoryDocument::kIdentity, Box{Vector3(1, 2, 3)}},
                   {TrajectoryDocument::kIdentity, Cylinder{0.1, 0.7}},
                   {TrajectoryDocument::kIdentity, Capsule{0.1, 0}},
                   {TrajectoryDocument::kIdentity, std::make_shared<const Mesh>(mesh)},
                   {TrajectoryDocument::kIdentity, TrajectoryDocument::Voxels{0.05, {{1, 2, 3}, {4, 5, 6}}}}};
    document.robot.links.push_back(link);
    return document;
}

TEST(DocumentJson, ReadsBackWhatItWrote) {
    const std::string text = to_json(sample_document());
    EXPECT_EQ(to_json(read(text)), text);
    const TrajectoryDocument document = read(text);
    EXPECT_EQ(document.robot.variables.size(), 5u);
    EXPECT_EQ(document.plan[1].name, "place");
    EXPECT_EQ(document.attempts[0].count, 12);
    EXPECT_EQ(document.attempts[2].reason, TrajectoryDocument::Reason::no_path);
    ASSERT_TRUE(document.segments[2].attach);
    EXPECT_EQ(document.segments[2].attach->link, "hand");
}

TEST(DocumentJson, HasEachKindOfShape) {
    const std::string text = to_json(all_shapes());
    const TrajectoryDocument document = read(text);
    EXPECT_EQ(to_json(document), text);
    const auto& shapes = document.robot.links[0].shapes;
    ASSERT_EQ(shapes.size(), 6u);
    for (std::size_t i = 0; i < shapes.size(); ++i) EXPECT_EQ(shapes[i].shape.index(), i);
    EXPECT_EQ(std::get<4>(shapes[4].shape)->vertices[1].x(), 1.0 / 3);
    EXPECT_EQ(std::get<5>(shapes[5].shape).centers[1], Vector3(4, 5, 6));
}

RC_GTEST_PROP(DocumentJson, KeepsEveryNumber, (double number)) {
    RC_PRE(std::isfinite(number));
    TrajectoryDocument document = sample_document();
    document.statistics["number"] = number;
    document.start[0] = number;
    const TrajectoryDocument again = read(to_json(document));
    RC_ASSERT(again.statistics.at("number") == number);
    RC_ASSERT(again.start[0] == number);
}

RC_GTEST_PROP(DocumentJson, KeepsEveryName, (std::string name)) {
    for (char& c : name) c = static_cast<char>(c & 0x7f);
    TrajectoryDocument document = sample_document();
    document.robot.name = name;
    document.plan[0].arguments.push_back(name);
    const TrajectoryDocument again = read(to_json(document));
    RC_ASSERT(again.robot.name == name);
    RC_ASSERT(again.plan[0].arguments.back() == name);
}

TEST(DocumentJson, MendsTextThatIsNotUtf8) {
    TrajectoryDocument document = sample_document();
    document.robot.name = "arm\xff";
    EXPECT_EQ(read(to_json(document)).robot.name, "arm\xef\xbf\xbd");
}

TEST(DocumentJson, DoesNotWriteWhatItWouldNotRead) {
    TrajectoryDocument document = sample_document();
    document.segments[1].knots[1].velocities[2] = std::nan("");
    try {
        to_json(document);
        FAIL() << "NaN was written";
    } catch (const std::invalid_argument& error) {
        EXPECT_TRUE(says(error.what(), "segments[1].knots[1].v[2] must be a finite number"));
    }
}

TEST(DocumentJson, RefusesWhatIsNotJson) {
    for (const char* text : {"", "{", "[1,2", "{\"format\": 1e999}", "{\"a\":\"\xff\"}", "nul"}) {
        try {
            read(text);
            FAIL() << text;
        } catch (const InputError& error) {
            EXPECT_TRUE(says(error.what(), "plan.json: not JSON: "));
            EXPECT_FALSE(says(error.what(), "json.exception"));
        }
    }
    EXPECT_THROW(read(std::string(200000, '[')), InputError);
}

TEST(DocumentJson, RefusesOtherFormatsAndVersions) {
    EXPECT_TRUE(says(refusal("/format", "picture"), "plan.json: format must be \"praxis-trajectory\""));
    EXPECT_TRUE(says(refusal("/version", 2), "version must be a whole number from 1 to 1"));
    EXPECT_TRUE(says(refusal("", Json::array()), "the document must be an object"));
}

TEST(DocumentJson, RefusesMissingMembers) {
    EXPECT_TRUE(says(refusal_without("", "plan"), "the document must be an object with a member \"plan\""));
    EXPECT_TRUE(says(refusal_without("/segments/2/attach", "pose"),
                     "segments[2].attach must be an object with a member \"pose\""));
    EXPECT_TRUE(says(refusal_without("/robot/links/1", "axis"), "robot.links[1] must be an object with"));
}

TEST(DocumentJson, RefusesWrongTypes) {
    EXPECT_TRUE(says(refusal("/plan", 3), "plan must be a list"));
    EXPECT_TRUE(says(refusal("/plan/0/name", 3), "plan[0].name must be a text"));
    EXPECT_TRUE(says(refusal("/bodies/0/movable", 1), "bodies[0].movable must be true or false"));
    EXPECT_TRUE(says(refusal("/start/1", "NaN"), "start[1] must be a number"));
    EXPECT_TRUE(says(refusal("/start/1", nullptr), "start[1] must be a number"));
    EXPECT_TRUE(says(refusal("/robot/links/1/parent", 0.5), "robot.links[1].parent must be a whole number"));
    EXPECT_TRUE(says(refusal("/robot/links/1/parent", 1e18), "robot.links[1].parent must be a whole number"));
    EXPECT_TRUE(says(refusal("/attempts/0/count", 18446744073709551615u), "attempts[0].count must be"));
    EXPECT_TRUE(says(refusal("/segments/0/kind", "fly"), "segments[0].kind must be one of \"transit\""));
    EXPECT_TRUE(says(refusal("/statistics", Json::array()), "statistics must be an object"));
}

TEST(DocumentJson, RefusesWrongSizes) {
    EXPECT_TRUE(says(refusal("/robot/base", Json::array({1, 2})), "robot.base must be a list of 7 numbers"));
    EXPECT_TRUE(says(refusal("/start", Json::array({0.0, 0.0})), "start must be one number for each of"));
    EXPECT_TRUE(says(refusal("/segments/0/knots/1/q", Json::array({0.0, 0.0})),
                     "segments[0].knots[1].q must be one number for each of the segment's variables"));
    EXPECT_TRUE(
        says(refusal("/attempts/0/contacts/0", Json::array({"can"})), "contacts[0] must be two names"));
    EXPECT_TRUE(
        says(refusal("/bodies/0/color", Json::array({0, 0, 2})), "bodies[0].color[2] must be from 0 to 1"));
}

TEST(DocumentJson, RefusesWrongPlaces) {
    EXPECT_TRUE(says(refusal("/robot/links/2/parent", 2),
                     "robot.links[2].parent must be the index of a link before"));
    EXPECT_TRUE(says(refusal("/robot/links/0/parent", 0), "robot.links[0].parent"));
    EXPECT_TRUE(says(refusal("/robot/links/1/variable", 9), "robot.links[1].variable must be the index"));
    EXPECT_TRUE(says(refusal("/robot/tools/0/link", 99), "robot.tools[0].link must be the index of a link"));
    EXPECT_TRUE(says(refusal("/robot/base/6", -1), "robot.base must be x y z qx qy qz qw with qw >= 0"));
    EXPECT_TRUE(says(refusal("/robot/base/6", 0.5), "with a quaternion of length 1"));
    EXPECT_TRUE(says(refusal("/segments/0/action", 2), "segments[0].action must be the index of an action"));
    EXPECT_TRUE(says(refusal("/segments/0/variables/1", 0), "segments[0].variables[0] must be another"));
    EXPECT_TRUE(says(refusal("/segments/2/attach/body", "cup"),
                     "segments[2].attach.body must be the name of a body"));
    EXPECT_TRUE(says(refusal("/segments/2/attach/link", "cup"),
                     "segments[2].attach.link must be the name of a link"));
    EXPECT_TRUE(says(refusal("/segments/6/detach/body", "ball"),
                     "segments[6].detach.body must be a body that is held"));
    EXPECT_TRUE(
        says(refusal("/attempts/0/contacts/0/1", "cup"), "attempts[0].contacts[0] must be two names of"));
    EXPECT_TRUE(says(refusal("/bodies/1/name", "table"), "bodies[1] must be named otherwise"));
    EXPECT_TRUE(says(refusal("/bodies/0/shapes/0/size/1", -1),
                     "bodies[0].shapes[0].size[1] must be a finite length"));
}

TEST(DocumentJson, RefusesWrongTimes) {
    EXPECT_TRUE(
        says(refusal("/segments/0/knots/1/t", 0), "segments[0].knots[1].t must be after that before it"));
    EXPECT_TRUE(
        says(refusal("/segments/0/knots/0/t", 0.1), "segments[0].knots[0] must be at the segment's start"));
    EXPECT_TRUE(
        says(refusal("/segments/1/start", 0), "segments[1].variables[0] must be a variable that no segment"));
    EXPECT_TRUE(says(refusal("/segments/0/end", -1), "segments[0].end must be a finite time"));
    EXPECT_TRUE(
        says(refusal("/plan/0/start", 99), "plan[0].end must be a finite time that is not before start"));
}

RC_GTEST_PROP(DocumentJson, SurvivesBrokenTexts, ()) {
    static const std::string sample = to_json(sample_document());
    std::string text = sample;
    const int changes = *rc::gen::inRange(1, 4);
    for (int i = 0; i < changes; ++i) {
        const auto at = *rc::gen::inRange<std::size_t>(0, text.size());
        const auto length = *rc::gen::inRange<std::size_t>(0, 4);
        const auto put =
            *rc::gen::element<std::string>("", "0", "-", "9", "\"", "{", "]", ",", "null", "1e300");
        text.replace(at, length, put);
    }
    try {
        const TrajectoryDocument document = read(text);
        RC_ASSERT(to_json(read(to_json(document))) == to_json(document));
    } catch (const InputError& error) {
        RC_ASSERT(std::string(error.what()).starts_with("error: plan.json: "));
    }
}

TEST(DocumentJson, PassesOverMembersThatItDoesNotKnow) {
    EXPECT_EQ(refusal("/made_by", "somebody"), "");
    EXPECT_EQ(refusal("/robot/maker", 7), "");
}

}  // namespace
}  // namespace praxis::tamp
