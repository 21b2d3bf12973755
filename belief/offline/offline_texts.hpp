// What `plan belief --offline` writes.
#pragma once

#include <string>

#include "belief/belief_task.hpp"
#include "belief/offline/offline.hpp"

namespace praxis::belief {

struct OfflineTexts {
    std::string summary;  ///< one line: size, costs, in how many worlds it was executed, how it was made
    std::string text;     ///< plan_to_text, and the summary as a comment at its end
    std::string dot;
    std::string json;
    std::string html;
};

/// Of a plan that was found; without one, the summary says why and the others are empty. `title`: the page's
/// heading.
OfflineTexts offline_texts(const BeliefTask& task, const OfflineResult& result, const std::string& title);

}  // namespace praxis::belief
