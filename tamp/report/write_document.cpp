#include <nlohmann/json.hpp>

#include "tamp/report/document_json.hpp"
#include "tamp/report/document_names.hpp"

namespace praxis::tamp {

namespace {

using Document = TrajectoryDocument;
using Json = nlohmann::ordered_json;

template <class Vectors>
Json flat(const Vectors& vectors) {
    Json result = Json::array();
    for (const auto& vector : vectors)
        for (std::size_t i = 0; i < 3; ++i) result.push_back(vector[static_cast<int>(i)]);
    return result;
}

struct WriteShape {
    Json& json;

    void operator()(const Sphere& sphere) const { json["radius"] = sphere.radius; }
    void operator()(const Box& box) const { json["size"] = flat(std::array{box.size}); }
    template <class Round>
    void operator()(const Round& round) const {
        json["radius"] = round.radius;
        json["length"] = round.length;
    }
    void operator()(const std::shared_ptr<const Mesh>& mesh) const {
        json["name"] = mesh->name;
        json["vertices"] = flat(mesh->vertices);
        Json triangles = Json::array();
        for (const auto& triangle : mesh->triangles)
            for (const std::uint32_t corner : triangle) triangles.push_back(corner);
        json["triangles"] = std::move(triangles);
    }
    void operator()(const Document::Voxels& voxels) const {
        json["edge"] = voxels.edge;
        json["centers"] = flat(voxels.centers);
    }
};

template <class Values, class Write>
Json list(const Values& values, Write write) {
    Json result = Json::array();
    for (const auto& value : values) result.push_back(write(value));
    return result;
}

Json write_shape(const Document::PlacedShape& placed) {
    Json json;
    json["type"] = shape_names()[placed.shape.index()];
    json["pose"] = placed.pose;
    std::visit(WriteShape{json}, placed.shape);
    return json;
}

Json write_link(const Document::Link& link) {
    Json json;
    json["name"] = link.name;
    json["parent"] = link.parent;
    json["origin"] = link.origin;
    json["type"] = name_of(link.type);
    json["axis"] = link.axis;
    json["variable"] = link.variable;
    json["multiplier"] = link.multiplier;
    json["offset"] = link.offset;
    json["shapes"] = list(link.shapes, write_shape);
    return json;
}

Json write_tool(const Document::Tool& tool) {
    Json json;
    json["name"] = tool.name;
    json["link"] = tool.link;
    json["pose"] = tool.pose;
    return json;
}

Json write_robot(const Document::Robot& robot) {
    Json json;
    json["name"] = robot.name;
    json["base"] = robot.base;
    json["variables"] = robot.variables;
    json["links"] = list(robot.links, write_link);
    json["tools"] = list(robot.tools, write_tool);
    return json;
}

Json write_body(const Document::Body& body) {
    Json json;
    json["name"] = body.name;
    json["pose"] = body.pose;
    json["shapes"] = list(body.shapes, write_shape);
    json["color"] = body.color;
    json["movable"] = body.movable;
    return json;
}

Json write_hold(const Document::Hold& hold) {
    Json json;
    json["body"] = hold.body;
    json["link"] = hold.link;
    json["pose"] = hold.pose;
    return json;
}

Json write_stand(const Document::Stand& stand) {
    Json json;
    json["body"] = stand.body;
    json["pose"] = stand.pose;
    return json;
}

Json write_action(const Document::Action& action) {
    Json json;
    json["name"] = action.name;
    json["arguments"] = action.arguments;
    json["start"] = action.start;
    json["end"] = action.end;
    return json;
}

Json write_knot(const Trajectory::Knot& knot) {
    Json json;
    json["t"] = knot.time;
    json["q"] = knot.positions;
    json["v"] = knot.velocities;
    json["a"] = knot.accelerations;
    return json;
}

Json write_segment(const Document::Segment& segment) {
    Json json;
    json["action"] = segment.action;
    json["kind"] = name_of(segment.kind);
    json["start"] = segment.start;
    json["end"] = segment.end;
    json["variables"] = segment.variables;
    json["knots"] = list(segment.knots, write_knot);
    if (segment.attach) json["attach"] = write_hold(*segment.attach);
    if (segment.detach) json["detach"] = write_stand(*segment.detach);
    return json;
}

Json write_attempt(const Document::Attempt& attempt) {
    Json json;
    json["action"] = attempt.action;
    json["stream"] = attempt.stream;
    json["reason"] = name_of(attempt.reason);
    json["message"] = attempt.message;
    if (!attempt.configuration.empty()) json["configuration"] = attempt.configuration;
    if (attempt.held) json["held"] = write_hold(*attempt.held);
    if (!attempt.elsewhere.empty()) json["elsewhere"] = list(attempt.elsewhere, write_stand);
    json["contacts"] = list(attempt.contacts, [](const auto& pair) {
        return Json::array({pair.first, pair.second});
    });
    json["count"] = attempt.count;
    return json;
}

Json write_values(const std::map<std::string, Document::Value>& values) {
    Json json = Json::object();
    for (const auto& [name, value] : values) {
        json[name]["kind"] = value.kind;
        json[name]["numbers"] = value.numbers;
    }
    return json;
}

}  // namespace

std::string to_json(const TrajectoryDocument& document) {
    check_document(document);
    Json json;
    json["format"] = kDocumentFormat;
    json["version"] = kDocumentVersion;
    json["robot"] = write_robot(document.robot);
    json["bodies"] = list(document.bodies, write_body);
    json["held"] = list(document.held, write_hold);
    json["start"] = document.start;
    json["plan"] = list(document.plan, write_action);
    json["values"] = write_values(document.values);
    json["segments"] = list(document.segments, write_segment);
    json["attempts"] = list(document.attempts, write_attempt);
    json["statistics"] = Json(document.statistics);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace praxis::tamp
