#include "lib/pose/pose_kernels.h"

namespace claque::pose
{

const PoseKernels &pose_kernels_of(math::SimdLevel simd_level)
{
    if (simd_level == math::SimdLevel::scalar) return pose_kernels_scalar;
    if (simd_level >= math::SimdLevel::simd256 && math::can_run(math::SimdLevel::simd256)) return pose_kernels_256;
    return math::has_avx() ? pose_kernels_128_avx : pose_kernels_128;
}

}  // namespace claque::pose
