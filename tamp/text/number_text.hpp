// Numbers as files of other programs hold them.
#pragma once

#include <string>

namespace praxis::tamp {

/// The shortest text that is read back as the same number.
std::string shortest(double number);

/// The same as a floating-point number of YAML 1.1, which always has a point: "1" as "1.0", "1e-05" as
/// "1.0e-05".
std::string yaml_float(double number);

}  // namespace praxis::tamp
