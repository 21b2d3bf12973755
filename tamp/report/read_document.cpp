#include <stdexcept>

#include "parser/files.hpp"
#include "tamp/report/document_json.hpp"
#include "tamp/report/document_names.hpp"
#include "tamp/text/json_place.hpp"

namespace praxis::tamp {

namespace {

using Document = TrajectoryDocument;

template <std::size_t size>
std::array<double, size> read_numbers(const JsonPlace& place) {
    if (place.size() != size) place.refuse("a list of " + std::to_string(size) + " numbers");
    std::array<double, size> result;
    for (std::size_t i = 0; i < size; ++i) result[i] = place[i].number();
    return result;
}

Document::PoseNumbers read_pose(const JsonPlace& owner) {
    return read_numbers<7>(owner.member("pose"));
}

/// Threes of a flat list.
std::vector<Vector3> read_vectors(const JsonPlace& place) {
    const std::size_t size = place.size();
    if (size % 3 != 0) place.refuse("a list of x y z, x y z, ...");
    std::vector<Vector3> result(size / 3);
    for (std::size_t i = 0; i < size; ++i) result[i / 3][static_cast<int>(i % 3)] = place[i].number();
    return result;
}

std::vector<std::array<std::uint32_t, 3>> read_triangles(const JsonPlace& place) {
    const std::size_t size = place.size();
    if (size % 3 != 0) place.refuse("a list of three indices a triangle");
    std::vector<std::array<std::uint32_t, 3>> result(size / 3);
    for (std::size_t i = 0; i < size; ++i)
        result[i / 3][i % 3] = static_cast<std::uint32_t>(place[i].integer(0));
    return result;
}

std::vector<std::string> read_texts(const JsonPlace& place) {
    return place.list([](const JsonPlace& entry) { return entry.text(); });
}

Document::PlacedShape read_shape(const JsonPlace& place) {
    Document::PlacedShape result;
    result.pose = read_pose(place);
    const auto length = [&](const char* name) { return place.member(name).number(); };
    switch (place.member("type").one_of(shape_names())) {
        case 0:
            result.shape = Sphere{length("radius")};
            break;
        case 1: {
            const std::array<double, 3> size = read_numbers<3>(place.member("size"));
            result.shape = Box{Vector3(size[0], size[1], size[2])};
            break;
        }
        case 2:
            result.shape = Cylinder{length("radius"), length("length")};
            break;
        case 3:
            result.shape = Capsule{length("radius"), length("length")};
            break;
        case 4: {
            Mesh mesh;
            if (place.has("name")) mesh.name = place.member("name").text();
            mesh.vertices = read_vectors(place.member("vertices"));
            mesh.triangles = read_triangles(place.member("triangles"));
            result.shape = std::make_shared<const Mesh>(std::move(mesh));
            break;
        }
        default:
            result.shape = Document::Voxels{length("edge"), read_vectors(place.member("centers"))};
    }
    return result;
}

std::vector<Document::PlacedShape> read_shapes(const JsonPlace& owner) {
    return owner.member("shapes").list(read_shape);
}

Document::Link read_link(const JsonPlace& place) {
    Document::Link link;
    link.name = place.member("name").text();
    link.parent = place.member("parent").integer(-1);
    link.origin = read_numbers<7>(place.member("origin"));
    link.type = static_cast<JointType>(place.member("type").one_of(joint_type_names()));
    link.axis = read_numbers<3>(place.member("axis"));
    link.variable = place.member("variable").integer(-1);
    link.multiplier = place.member("multiplier").number();
    link.offset = place.member("offset").number();
    link.shapes = read_shapes(place);
    return link;
}

Document::Tool read_tool(const JsonPlace& place) {
    return {place.member("name").text(), place.member("link").integer(0), read_pose(place)};
}

Document::Robot read_robot(const JsonPlace& place) {
    Document::Robot robot;
    robot.name = place.member("name").text();
    robot.base = read_numbers<7>(place.member("base"));
    robot.variables = read_texts(place.member("variables"));
    robot.links = place.member("links").list(read_link);
    if (place.has("tools")) robot.tools = place.member("tools").list(read_tool);
    return robot;
}

Document::Body read_body(const JsonPlace& place) {
    Document::Body body;
    body.name = place.member("name").text();
    body.pose = read_pose(place);
    body.shapes = read_shapes(place);
    body.color = read_numbers<3>(place.member("color"));
    body.movable = place.member("movable").boolean();
    return body;
}

Document::Hold read_hold(const JsonPlace& place) {
    return {place.member("body").text(), place.member("link").text(), read_pose(place)};
}

Document::Stand read_stand(const JsonPlace& place) {
    return {place.member("body").text(), read_pose(place)};
}

Document::Action read_action(const JsonPlace& place) {
    return {place.member("name").text(), read_texts(place.member("arguments")),
            place.member("start").number(), place.member("end").number()};
}

Trajectory::Knot read_knot(const JsonPlace& place) {
    return {place.member("t").number(), place.member("q").numbers(), place.member("v").numbers(),
            place.member("a").numbers()};
}

Document::Segment read_segment(const JsonPlace& place) {
    Document::Segment segment;
    segment.action = place.member("action").integer(0);
    segment.kind = static_cast<Document::Motion>(place.member("kind").one_of(motion_names()));
    segment.start = place.member("start").number();
    segment.end = place.member("end").number();
    segment.variables =
        place.member("variables").list([](const JsonPlace& entry) { return entry.integer(0); });
    segment.knots = place.member("knots").list(read_knot);
    if (place.has("attach")) segment.attach = read_hold(place.member("attach"));
    if (place.has("detach")) segment.detach = read_stand(place.member("detach"));
    return segment;
}

std::pair<std::string, std::string> read_pair(const JsonPlace& place) {
    if (place.size() != 2) place.refuse("two names");
    return {place[0].text(), place[1].text()};
}

Document::Attempt read_attempt(const JsonPlace& place) {
    Document::Attempt attempt;
    attempt.action = place.member("action").text();
    attempt.stream = place.member("stream").text();
    attempt.reason = static_cast<Document::Reason>(place.member("reason").one_of(reason_names()));
    attempt.message = place.member("message").text();
    if (place.has("configuration")) attempt.configuration = place.member("configuration").numbers();
    if (place.has("held")) attempt.held = read_hold(place.member("held"));
    if (place.has("elsewhere")) attempt.elsewhere = place.member("elsewhere").list(read_stand);
    attempt.contacts = place.member("contacts").list(read_pair);
    attempt.count = place.member("count").integer(1);
    return attempt;
}

Document read_members(const JsonPlace& place) {
    if (place.member("format").text() != kDocumentFormat)
        place.member("format").refuse("\"" + std::string(kDocumentFormat) + "\"");
    place.member("version").integer(kDocumentVersion, kDocumentVersion);
    Document document;
    document.robot = read_robot(place.member("robot"));
    document.bodies = place.member("bodies").list(read_body);
    if (place.has("held")) document.held = place.member("held").list(read_hold);
    document.start = place.member("start").numbers();
    document.plan = place.member("plan").list(read_action);
    place.member("values").each_member([&](const std::string& name, const JsonPlace& value) {
        document.values[name] = {value.member("kind").text(), value.member("numbers").numbers()};
    });
    document.segments = place.member("segments").list(read_segment);
    document.attempts = place.member("attempts").list(read_attempt);
    place.member("statistics").each_member([&](const std::string& name, const JsonPlace& value) {
        document.statistics[name] = value.number();
    });
    return document;
}

}  // namespace

TrajectoryDocument read_document(const Source& source) {
    nlohmann::json json;
    try {
        json = nlohmann::json::parse(source.text);
    } catch (const nlohmann::json::exception& error) {
        const std::string message =
            error.what();  // "[json.exception...] parse error at line 3, column 5: ..."
        const std::size_t start = message.find("] ");
        fail_unplaced(source.name +
                      ": not JSON: " + (start == std::string::npos ? message : message.substr(start + 2)));
    }
    Document document = read_members(JsonPlace(json, source.name));
    try {
        check_document(document);
    } catch (const std::invalid_argument& error) {
        fail_unplaced(source.name + ": " + error.what());
    }
    return document;
}

}  // namespace praxis::tamp
