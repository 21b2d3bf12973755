// The words of trajectory documents, in the order of the enumerations.
#pragma once

#include <string>
#include <vector>

#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

inline constexpr const char* kDocumentFormat = "praxis-trajectory";
inline constexpr int kDocumentVersion = 1;

const std::vector<std::string>& joint_type_names();
const std::vector<std::string>& motion_names();
const std::vector<std::string>& reason_names();
/// In the order of the alternatives of `TrajectoryDocument::PlacedShape::shape`.
const std::vector<std::string>& shape_names();

inline const std::string& name_of(JointType type) {
    return joint_type_names()[static_cast<std::size_t>(type)];
}
inline const std::string& name_of(TrajectoryDocument::Motion kind) {
    return motion_names()[static_cast<std::size_t>(kind)];
}
inline const std::string& name_of(TrajectoryDocument::Reason reason) {
    return reason_names()[static_cast<std::size_t>(reason)];
}

}  // namespace praxis::tamp
