/* Which instruction set poses and vertices are made with. Unless told otherwise claque takes the widest that the
 * processor has; the environment may name one for measuring: CLAQUE_SIMD is scalar, 128, 256 or fma, read once.
 * All but fma give the same bits on every processor. */
#ifndef CLAQUE_SIMD_H
#define CLAQUE_SIMD_H

#include <claque/base.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum clq_simd {
    CLQ_SIMD_WIDEST = 0, /* of the next three, the last that the processor has */
    CLQ_SIMD_SCALAR = 1, /* one number at a time: the reference */
    CLQ_SIMD_128 = 2,    /* four: SSE2, NEON */
    CLQ_SIMD_256 = 3,    /* eight: AVX2 */
    /* AVX2 with fused multiply-add in skinning, about a quarter sooner. Products are not rounded before they are added,
     * so positions differ from the others' by a few units of the last place, and pictures need not be the same bits. */
    CLQ_SIMD_FMA = 4
} clq_simd;

/* Says what this process uses from the next update on, in all contexts.
 * Fails: ARGUMENT (no such set), UNSUPPORTED (this processor has it not); what was in use stays.
 * Threads: while no update, draw or template build runs in any thread. GL: none. */
CLQ_API clq_status clq_simd_use(clq_simd simd);

/* What is in use, never CLQ_SIMD_WIDEST. Threads: any. GL: none. */
CLQ_API clq_simd clq_simd_in_use(void);

#ifdef __cplusplus
}
#endif

#endif
