/* The instruction set that computes poses and skinned vertices.
 *
 * By default a process uses the widest set of SCALAR, 128 and 256 that its processor has. The environment variable
 * CLAQUE_SIMD (scalar, 128, 256 or fma, read once) chooses another one for measurements; a value that the processor
 * cannot run is ignored. All sets except FMA give the same bits on every processor. */
#ifndef CLAQUE_SIMD_H
#define CLAQUE_SIMD_H

#include <claque/base.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum clq_simd {
    CLQ_SIMD_WIDEST = 0, /* the widest of the next three that the processor has */
    CLQ_SIMD_SCALAR = 1, /* one number at a time: the reference */
    CLQ_SIMD_128 = 2,    /* four numbers: SSE2, NEON */
    CLQ_SIMD_256 = 3,    /* eight numbers: AVX2 */
    /* AVX2 with fused multiply-add in skinning; skinning takes about a quarter less time. Products are not rounded
     * before they are added: positions differ from those of the other sets by a few units in the last place, so the
     * bits of pictures may differ. */
    CLQ_SIMD_FMA = 4
} clq_simd;

/* Sets the instruction set of this process, for all contexts, from the next update on.
 * Fails: ARGUMENT (an unknown set), UNSUPPORTED (the processor lacks it); the set then stays.
 * Threads: any, while no update, draw or template build runs on any thread. GL: none. */
CLQ_API clq_status clq_simd_set(clq_simd simd);

/* Returns the instruction set in use, never CLQ_SIMD_WIDEST. Threads: any. GL: none. */
CLQ_API clq_simd clq_simd_get(void);

#ifdef __cplusplus
}
#endif

#endif
