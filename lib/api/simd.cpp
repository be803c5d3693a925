// The instruction set of poses and skinning.
#include <claque/simd.h>

#include "lib/api/boundary.h"
#include "lib/math/simd_level.h"

using namespace claque;

namespace
{

math::SimdLevel simd_level_of(unsigned number)
{
    switch (number) {
        case CLQ_SIMD_SCALAR:
            return math::SimdLevel::scalar;
        case CLQ_SIMD_128:
            return math::SimdLevel::simd128;
        case CLQ_SIMD_256:
            return math::SimdLevel::simd256;
        case CLQ_SIMD_FMA:
            return math::SimdLevel::fma;
        case CLQ_SIMD_WIDEST:
            return math::can_run(math::SimdLevel::simd256) ? math::SimdLevel::simd256 : math::SimdLevel::simd128;
        default:
            base::fail(CLQ_ARGUMENT, "%u is no instruction set", number);
    }
}

}  // namespace

extern "C" {

clq_status clq_simd_set(clq_simd simd)
{
    return api::boundary("clq_simd_set", [&] {
        const math::SimdLevel simd_level = simd_level_of(api::number_of(simd));
        if (!math::can_run(simd_level))
            base::fail(CLQ_UNSUPPORTED, "this processor has no %s",
                       simd_level == math::SimdLevel::simd256 ? "AVX2" : "AVX2 with fused multiply-add");
        math::set_simd_level(simd_level);
    });
}

clq_simd clq_simd_get(void)
{
    switch (math::default_simd_level()) {
        case math::SimdLevel::scalar:
            return CLQ_SIMD_SCALAR;
        case math::SimdLevel::simd128:
            return CLQ_SIMD_128;
        case math::SimdLevel::simd256:
            return CLQ_SIMD_256;
        case math::SimdLevel::fma:
            break;
    }
    return CLQ_SIMD_FMA;
}

}  // extern "C"
