#include "lib/pose/steps.h"

namespace claque::pose
{

const Steps &steps_of(math::Kernel kernel)
{
    if (kernel == math::Kernel::scalar) return steps_scalar;
    return kernel >= math::Kernel::wide && math::can_run(math::Kernel::wide) ? steps_wide : steps_vector;
}

}  // namespace claque::pose
