#include "lib/math/kernel.h"

#include <cstdlib>
#include <string_view>

namespace claque::math
{

namespace
{

bool has_avx2()
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2");
#else
    return false;
#endif
}

Kernel chosen_kernel()
{
#ifdef CLAQUE_SCALAR
    return Kernel::scalar;
#else
    const char *named = std::getenv("CLAQUE_SIMD");
    const std::string_view name = named ? named : "";
    if (name == "scalar") return Kernel::scalar;
    if (name == "128") return Kernel::vector;
    return can_run(Kernel::wide) ? Kernel::wide : Kernel::vector;
#endif
}

}  // namespace

bool can_run(Kernel kernel)
{
    static const bool wide = has_avx2();
    return kernel != Kernel::wide || wide;
}

Kernel default_kernel()
{
    static const Kernel kernel = chosen_kernel();
    return kernel;
}

}  // namespace claque::math
