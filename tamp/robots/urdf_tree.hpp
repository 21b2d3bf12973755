// The links and joints of a URDF file as a tree, checked.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tamp/robots/xml_file.hpp"

namespace praxis::tamp {

struct UrdfTree {
    std::string root = {};                 ///< the link
    std::vector<std::string> joints = {};  ///< depth first, in the order of the file
    std::map<std::string, const tinyxml2::XMLElement*> link_elements = {};
    std::map<std::string, const tinyxml2::XMLElement*> joint_elements = {};
};

/// Throws InputError where names are missing or repeated, a joint joins links that are not there, a link has
/// two parents, or the links are no tree with one root.
UrdfTree make_urdf_tree(const XmlFile& xml);

}  // namespace praxis::tamp
