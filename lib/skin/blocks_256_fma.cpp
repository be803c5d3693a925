// Blocks for processors with AVX2 and fused multiply-add, used only if a host asks for it by name: a product is not
// rounded before it is added, so bits differ from scalar.cpp's.
#include "lib/skin/kernel.h"

#if defined(__x86_64__) || defined(__i386__)

#define CLAQUE_BLOCKS __attribute__((target("avx2,fma")))
#define CLAQUE_BLOCKS_INLINE __attribute__((target("avx2,fma"), always_inline)) inline
#define CLAQUE_BLOCKS_PLUS_TIMES(sum, a, b) _mm256_fmadd_ps(a, b, sum)
#define CLAQUE_BLOCKS_RUN run_256_fma_blocks
#include "lib/skin/blocks_256.h"

#else

namespace claque::skin
{

void run_256_fma_blocks(const BlockRun &) {}  // never called

}  // namespace claque::skin

#endif
