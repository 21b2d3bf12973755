// The page around the figures of an experiment: style, controls and the script that shows the choices.
#pragma once

#include <string>

namespace praxis::practice {

/// `sections`: markup. `data`: JSON as `report_data` writes it.
std::string report_page_html(const std::string& title, const std::string& summary,
                             const std::string& sections, const std::string& data);

}  // namespace praxis::practice
