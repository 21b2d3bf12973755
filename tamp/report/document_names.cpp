#include "tamp/report/document_names.hpp"

namespace praxis::tamp {

const std::vector<std::string>& joint_type_names() {
    static const std::vector<std::string> names = {"fixed", "revolute", "continuous", "prismatic"};
    return names;
}

const std::vector<std::string>& motion_names() {
    static const std::vector<std::string> names = {"transit", "transfer", "approach", "retreat",
                                                   "gripper", "base",     "wait"};
    return names;
}

const std::vector<std::string>& reason_names() {
    static const std::vector<std::string> names = {"collision", "kinematics", "no path", "other"};
    return names;
}

const std::vector<std::string>& shape_names() {
    static const std::vector<std::string> names = {"sphere", "box", "cylinder", "capsule", "mesh", "voxels"};
    return names;
}

}  // namespace praxis::tamp
