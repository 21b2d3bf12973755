// JSON in what a model says.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace praxis::belief {

/// The one JSON object in a text, which may stand in a fenced block (```json ... ```). A discarded value if
/// there is none, with the reason in `why`: other text around it, two values, a member named twice, wrong
/// syntax.
nlohmann::json read_json_answer(std::string_view text, std::string& why);

}  // namespace praxis::belief
