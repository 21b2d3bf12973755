// The tables of kernels, one namespace an instruction set. Each is defined by a file that is nothing but
// loops.hpp compiled for it.
#pragma once

#include "learned/kernels/kernels.hpp"

namespace praxis::learned {

namespace portable {
template <class T>
const Kernels<T>& table();
}
namespace avx2 {
template <class T>
const Kernels<T>& table();
}
namespace avx512 {
template <class T>
const Kernels<T>& table();
}

}  // namespace praxis::learned
