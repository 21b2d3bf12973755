// A part of practice that users choose by name.
#pragma once

#include <string>

namespace praxis::practice {

struct Component {
    std::string name;
    std::string description;  ///< one sentence
};

}  // namespace praxis::practice
