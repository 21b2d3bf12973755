#include "tamp/collision/kernel.hpp"

namespace praxis::tamp::kernel {

#ifdef PRAXIS_AVX2
const Functions& avx2_functions();

const Functions& functions() {
    static const bool fast = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return fast ? avx2_functions() : portable_functions();
}
#else
const Functions& functions() {
    return portable_functions();
}
#endif

int scratch_size(const Model& model) {
    int points = model.part_count + model.cluster_count;
    for (int c = 0; c < model.cluster_count; ++c) points += model.clusters[c].ball_count;
    return (18 * model.frame_count + 3 * points + model.part_count) * kLanes;
}

}  // namespace praxis::tamp::kernel
