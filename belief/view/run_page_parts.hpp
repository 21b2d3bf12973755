// The page around the data of a run: style, controls and the script that shows them.
#pragma once

#include <string>

namespace praxis::belief {

/// `data`: JSON with "atoms" and "steps" as `RunRecorder::page` writes it, without "<".
std::string run_page_html(const std::string& title, const std::string& summary, const std::string& data);

}  // namespace praxis::belief
