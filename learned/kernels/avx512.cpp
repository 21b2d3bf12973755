#define PRAXIS_KERNELS avx512
#define PRAXIS_KERNELS_TEXT "avx512"
#define PRAXIS_VECTOR_BYTES 64
#define PRAXIS_VECTORS 1
#include "learned/kernels/loops.hpp"
