#include "lib/math/kernel.h"

#include <atomic>
#include <cstdlib>
#include <string_view>

namespace claque::math
{

namespace
{

Kernel widest()
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2")) return Kernel::vector;
    return __builtin_cpu_supports("fma") ? Kernel::fused : Kernel::wide;
#else
    return Kernel::vector;
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
    if (name == "fma" && can_run(Kernel::fused)) return Kernel::fused;
    return can_run(Kernel::wide) ? Kernel::wide : Kernel::vector;
#endif
}

std::atomic<Kernel> &kernel_in_use()
{
    static std::atomic<Kernel> kernel{chosen_kernel()};
    return kernel;
}

}  // namespace

bool can_run(Kernel kernel)
{
    static const Kernel most = widest();
    return kernel <= most;
}

Kernel default_kernel() { return kernel_in_use().load(std::memory_order_relaxed); }

void use_kernel(Kernel kernel) { kernel_in_use().store(kernel, std::memory_order_relaxed); }

}  // namespace claque::math
