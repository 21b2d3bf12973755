#ifdef __AVX2__

#include "tamp/collision/lanes_avx2.hpp"
// Lanes first: the template is over it.
#include "tamp/collision/kernel_template.hpp"
#include "tamp/collision/nearest_template.hpp"

namespace praxis::tamp::kernel {

const Functions& avx2_functions() {
    static constexpr Functions table = {"avx2", collisions, motion_free, sweeps, swept_collisions, nearest};
    return table;
}

}  // namespace praxis::tamp::kernel

#endif
