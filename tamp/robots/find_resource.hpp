// Files that robots refer to.
#pragma once

#include <string>
#include <vector>

namespace praxis::tamp {

/// The file that `uri` means in `robot_file`: a path relative to that file, an absolute path, `file://PATH`,
/// or `package://NAME/PATH` (also `model://`), which is looked for as RobotOptions::packages says. The file
/// need not exist unless it is in a package: empty if no package has it.
std::string find_resource(const std::string& uri, const std::string& robot_file,
                          const std::vector<std::string>& packages);

}  // namespace praxis::tamp
