#include "tamp/collision/lanes_portable.hpp"
// Lanes first: the template is over it.
#include "tamp/collision/kernel_template.hpp"
#include "tamp/collision/nearest_template.hpp"

namespace praxis::tamp::kernel {

const Functions& portable_functions() {
    static constexpr Functions table = {"portable", collisions,       motion_free,
                                        sweeps,     swept_collisions, nearest};
    return table;
}

}  // namespace praxis::tamp::kernel
