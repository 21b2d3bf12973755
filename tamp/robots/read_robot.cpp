#include "tamp/robots/read_robot.hpp"

#include "parser/files.hpp"
#include "tamp/robots/derive.hpp"
#include "tamp/robots/finish_robot.hpp"
#include "tamp/robots/srdf.hpp"
#include "tamp/robots/urdf.hpp"

namespace praxis::tamp {

Robot parse_robot(const Source& urdf, const Source& srdf, const RobotOptions& options) {
    // Limits may name variables of a base that only the SRDF adds.
    RobotOptions unlimited = options;
    unlimited.limits = {};
    Robot robot = parse_urdf(urdf, unlimited);
    bool told = false;
    if (srdf.text.empty()) {
        derive_groups(robot);
    } else {
        told = apply_srdf(robot, srdf);
    }
    apply_limits(robot, options.limits, urdf.name);
    if (!told) derive_allowed_collisions(robot, options.samples, options.seed);
    allow_neighbours(robot);
    require_valid(robot, srdf.text.empty() ? urdf.name : srdf.name);
    return robot;
}

Robot read_robot(const std::string& urdf_file, const std::string& srdf_file, const RobotOptions& options) {
    if (srdf_file.empty()) return parse_robot(read_source(urdf_file), {}, options);
    const Source srdf = read_source(srdf_file);
    require_text(srdf);
    return parse_robot(read_source(urdf_file), srdf, options);
}

}  // namespace praxis::tamp
