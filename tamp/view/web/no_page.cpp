#include "tamp/view/page_template.hpp"

namespace praxis::tamp {

const PageTemplate* page_template() {
    return nullptr;
}

}  // namespace praxis::tamp
