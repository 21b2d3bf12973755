#include "tamp/robots/urdf_tree.hpp"

#include "parser/suggest.hpp"

namespace praxis::tamp {

namespace {

using Element = tinyxml2::XMLElement;
using Elements = std::map<std::string, const Element*>;

Elements by_name(const XmlFile& xml, const char* kind) {
    Elements elements;
    for (const Element* element : children(xml.root(), kind)) {
        const std::string name = xml.attribute(*element, "name");
        if (!elements.emplace(name, element).second) {
            xml.fail(*element, "there is another " + std::string(kind) + " named " + quote(name),
                     "names must differ");
        }
    }
    return elements;
}

/// The link that a joint's <parent> or <child> names.
std::string joined_link(const XmlFile& xml, const Element& joint, const char* side, const Elements& links) {
    const std::string name = quote(joint.Attribute("name"));
    const Element* joined = joint.FirstChildElement(side);
    if (joined == nullptr) xml.fail(joint, "joint " + name + " has no <" + std::string(side) + ">");
    std::string link = xml.attribute(*joined, "link");
    if (!links.contains(link)) {
        Suggestion suggestion(link);
        for (const auto& [known, element] : links) suggestion.consider(known);
        xml.fail(*joined, "joint " + name + " joins an unknown link " + quote(link),
                 suggestion.found() ? suggestion.hint() : "define it by <link name=...>");
    }
    return link;
}

}  // namespace

UrdfTree make_urdf_tree(const XmlFile& xml) {
    UrdfTree tree;
    tree.link_elements = by_name(xml, "link");
    tree.joint_elements = by_name(xml, "joint");
    if (tree.link_elements.empty()) xml.fail(xml.root(), "the robot has no <link>");

    std::map<std::string, std::string> joint_above;
    std::map<std::string, std::vector<std::pair<std::string, std::string>>> below;
    for (const Element* joint : children(xml.root(), "joint")) {
        const std::string name = joint->Attribute("name");
        const std::string parent = joined_link(xml, *joint, "parent", tree.link_elements);
        const std::string child = joined_link(xml, *joint, "child", tree.link_elements);
        const auto [other, first] = joint_above.emplace(child, name);
        if (!first) {
            xml.fail(*joint, "link " + quote(child) + " is the child of two joints",
                     "the other one is " + quote(other->second));
        }
        below[parent].emplace_back(name, child);
    }
    for (const Element* link : children(xml.root(), "link")) {
        const std::string name = link->Attribute("name");
        if (joint_above.contains(name)) continue;
        if (!tree.root.empty()) {
            xml.fail(*link,
                     "both " + quote(tree.root) + " and " + quote(name) + " are links without a parent",
                     "join them: a robot has one root");
        }
        tree.root = name;
    }
    if (tree.root.empty()) xml.fail(xml.root(), "every link has a parent", "the joints make a cycle");

    std::vector<std::pair<std::string, std::string>> open = {{"", tree.root}};
    std::size_t reached = 0;
    while (!open.empty()) {
        const auto [joint, link] = open.back();
        open.pop_back();
        ++reached;
        if (!joint.empty()) tree.joints.push_back(joint);
        joint_above.erase(link);
        const auto& joints = below[link];
        open.insert(open.end(), joints.rbegin(), joints.rend());
    }
    if (reached < tree.link_elements.size()) {
        const auto& [link, joint] = *joint_above.begin();
        xml.fail(*tree.joint_elements[joint],
                 "link " + quote(link) + " is not connected to the root " + quote(tree.root),
                 "the joints above it make a cycle");
    }
    return tree;
}

}  // namespace praxis::tamp
