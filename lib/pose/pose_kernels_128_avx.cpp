// The same lanes for processors with AVX: its three-operand instructions need no copies, and it broadcasts an element
// as it loads it. Only functions of this file are compiled for AVX.
#include "lib/pose/pose_kernels.h"

#if defined(__x86_64__) || defined(__i386__)

#include <immintrin.h>

#define CLAQUE_POSE_INLINE __attribute__((target("avx"), always_inline)) inline
#define CLAQUE_POSE_KERNEL __attribute__((target("avx")))
#define CLAQUE_POSE_BROADCAST
#include "lib/pose/pose_kernels_body.h"
#include "lib/pose/pose_kernels_four.h"

namespace claque::pose
{

const PoseKernels pose_kernels_128_avx = pose_kernels_for<Four>;

}  // namespace claque::pose

#else

namespace claque::pose
{

const PoseKernels pose_kernels_128_avx = pose_kernels_128;

}  // namespace claque::pose

#endif
