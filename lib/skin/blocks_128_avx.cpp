// The same with 128-bit lanes for processors with AVX: its three-operand instructions need no copies, and it broadcasts
// an element as it loads it.
#include "lib/skin/kernel.h"

#if defined(__x86_64__) || defined(__i386__)

#define CLAQUE_BLOCKS __attribute__((target("avx")))
#define CLAQUE_BLOCKS_INLINE __attribute__((target("avx"), always_inline)) inline
#define CLAQUE_BLOCKS_BROADCAST
#define CLAQUE_BLOCKS_RUN run_128_avx_blocks
#include "lib/skin/blocks_128.h"

#else

namespace claque::skin
{

void run_128_avx_blocks(const BlockRun &) {}  // never called

}  // namespace claque::skin

#endif
