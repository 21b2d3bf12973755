// Runs to report on, and a check of markup.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "practice/experiment/results.hpp"

namespace praxis::practice::testing {

/// Names that break careless writers: separators, quotes, line ends, markup, control and broken characters.
const std::vector<std::string>& hostile_names();

/// A run with a rising curve of `cycles` cycles, and a choice among `candidates` in each.
RunResult example_run(const std::string& environment, const std::string& method, std::uint64_t seed,
                      int cycles = 4, int candidates = 3);

/// How often `part` occurs.
std::size_t count(std::string_view text, std::string_view part);

/// Why a text is not well-formed XML (tags, attributes, entities, characters), or "". A document type before
/// the root is passed over, and so is what stands inside of `script` elements.
std::string xml_error(std::string_view text);

}  // namespace praxis::practice::testing
