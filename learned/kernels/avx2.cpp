#define PRAXIS_KERNELS avx2
#define PRAXIS_KERNELS_TEXT "avx2"
#define PRAXIS_VECTOR_BYTES 32
#define PRAXIS_VECTORS 2
#include "learned/kernels/loops.hpp"
