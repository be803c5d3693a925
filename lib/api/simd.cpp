#include <claque/simd.h>

#include "lib/api/boundary.h"
#include "lib/math/kernel.h"

using namespace claque;

namespace
{

math::Kernel kernel_of(unsigned number)
{
    switch (number) {
        case CLQ_SIMD_SCALAR:
            return math::Kernel::scalar;
        case CLQ_SIMD_128:
            return math::Kernel::vector;
        case CLQ_SIMD_256:
            return math::Kernel::wide;
        case CLQ_SIMD_FMA:
            return math::Kernel::fused;
        case CLQ_SIMD_WIDEST:
            return math::can_run(math::Kernel::wide) ? math::Kernel::wide : math::Kernel::vector;
        default:
            base::fail(CLQ_ARGUMENT, "%u is no instruction set", number);
    }
}

}  // namespace

extern "C" {

clq_status clq_simd_use(clq_simd simd)
{
    return api::boundary("clq_simd_use", [&] {
        const math::Kernel kernel = kernel_of(api::number_of(simd));
        if (!math::can_run(kernel))
            base::fail(CLQ_UNSUPPORTED, "this processor has no %s",
                       kernel == math::Kernel::wide ? "AVX2" : "AVX2 with fused multiply-add");
        math::use_kernel(kernel);
    });
}

clq_simd clq_simd_in_use(void)
{
    switch (math::default_kernel()) {
        case math::Kernel::scalar:
            return CLQ_SIMD_SCALAR;
        case math::Kernel::vector:
            return CLQ_SIMD_128;
        case math::Kernel::wide:
            return CLQ_SIMD_256;
        case math::Kernel::fused:
            break;
    }
    return CLQ_SIMD_FMA;
}

}  // extern "C"
