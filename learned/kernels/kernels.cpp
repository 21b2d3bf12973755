#include "learned/kernels/kernels.hpp"

#include <stdexcept>

#include "learned/kernels/variants.hpp"

namespace praxis::learned {
namespace {

Instructions best_here() {
    for (const Instructions instructions : {Instructions::avx512, Instructions::avx2})
        if (supported(instructions)) return instructions;
    return Instructions::portable;
}

template <class T>
const Kernels<T>* compiled(Instructions instructions) {
    switch (instructions) {
#ifdef PRAXIS_LEARNED_X86
        case Instructions::avx512:
            return &avx512::table<T>();
        case Instructions::avx2:
            return &avx2::table<T>();
#endif
        case Instructions::portable:
            return &portable::table<T>();
        default:
            return nullptr;
    }
}

}  // namespace

bool supported(Instructions instructions) {
    switch (instructions) {
#ifdef PRAXIS_LEARNED_X86
        case Instructions::avx512:
            return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                   __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
        case Instructions::avx2:
            return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#endif
        case Instructions::portable:
            return true;
        default:
            return false;
    }
}

template <class T>
const Kernels<T>& kernels(Instructions instructions) {
    if (!supported(instructions))
        throw std::invalid_argument("this processor lacks the instructions asked for");
    return *compiled<T>(instructions);
}

template <class T>
const Kernels<T>& kernels() {
    static const Kernels<T>& best = kernels<T>(best_here());
    return best;
}

template const Kernels<float>& kernels(Instructions);
template const Kernels<double>& kernels(Instructions);
template const Kernels<float>& kernels();
template const Kernels<double>& kernels();

}  // namespace praxis::learned
