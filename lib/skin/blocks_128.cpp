// Blocks for processors with 128-bit lanes: SSE2 on x86.
#define CLAQUE_BLOCKS
#define CLAQUE_BLOCKS_INLINE __attribute__((always_inline)) inline
#define CLAQUE_BLOCKS_RUN run_128_blocks
#include "lib/skin/blocks_128.h"
