// Numbers as text, the same in every locale.
#pragma once

#include <cstdint>
#include <string>

namespace praxis::practice {

/// The shortest text that reads back as the same number.
std::string exact(double value);

/// Four digits at most, as a JSON number; the value is finite.
std::string brief(double value);

/// With `digits` behind the point and no "-0"; "∞" and "−∞" for what is not finite.
std::string fixed(double value, int digits);

/// "12,500": the nearest whole number, for people; "∞" for what is too large.
std::string grouped(double value);

}  // namespace praxis::practice
