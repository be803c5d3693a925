// For processors with 128-bit lanes: SSE2 on x86.
#include "lib/pose/pose_kernels.h"

#define CLAQUE_POSE_INLINE inline
#define CLAQUE_POSE_KERNEL
#include "lib/pose/pose_kernels_body.h"
#include "lib/pose/pose_kernels_four.h"

namespace claque::pose
{

const PoseKernels pose_kernels_128 = pose_kernels_for<Four>;

}  // namespace claque::pose
