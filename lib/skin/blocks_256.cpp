// Blocks for processors with AVX2; bit-equal to scalar.cpp.
#include "lib/skin/kernel.h"

#if defined(__x86_64__) || defined(__i386__)

#define CLAQUE_BLOCKS __attribute__((target("avx2")))
#define CLAQUE_BLOCKS_INLINE __attribute__((target("avx2"), always_inline)) inline
#define CLAQUE_BLOCKS_PLUS_TIMES(sum, a, b) _mm256_add_ps(sum, _mm256_mul_ps(a, b))
#define CLAQUE_BLOCKS_RUN run_256_blocks
#include "lib/skin/blocks_256.h"

#else

namespace claque::skin
{

void run_256_blocks(const BlockRun &) {}  // never called

}  // namespace claque::skin

#endif
