#define PRAXIS_KERNELS portable
#define PRAXIS_KERNELS_TEXT "portable"
#define PRAXIS_VECTOR_BYTES 16
#define PRAXIS_VECTORS 2
#include "learned/kernels/loops.hpp"
