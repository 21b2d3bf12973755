// Text inside of pages.
#pragma once

#include <string>
#include <string_view>

namespace praxis {

/// Between tags and in attributes. What no XML text may hold (control characters, broken UTF-8) becomes
/// U+FFFD.
std::string escape_markup(std::string_view text);

/// As a string of JSON that may stand inside of a `script` element: quoted, and without "<", which could end
/// the element.
std::string script_string(std::string_view text);

}  // namespace praxis
