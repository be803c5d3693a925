#include "lib/math/simd_level.h"

#include <atomic>
#include <cstdlib>
#include <string_view>

namespace claque::math
{

namespace
{

SimdLevel widest()
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2")) return SimdLevel::simd128;
    return __builtin_cpu_supports("fma") ? SimdLevel::fma : SimdLevel::simd256;
#else
    return SimdLevel::simd128;
#endif
}

SimdLevel chosen_simd_level()
{
#ifdef CLAQUE_SCALAR
    return SimdLevel::scalar;
#else
    const char *named = std::getenv("CLAQUE_SIMD");
    const std::string_view name = named ? named : "";
    if (name == "scalar") return SimdLevel::scalar;
    if (name == "128") return SimdLevel::simd128;
    if (name == "fma" && can_run(SimdLevel::fma)) return SimdLevel::fma;
    return can_run(SimdLevel::simd256) ? SimdLevel::simd256 : SimdLevel::simd128;
#endif
}

std::atomic<SimdLevel> &simd_level_in_use()
{
    static std::atomic<SimdLevel> simd_level{chosen_simd_level()};
    return simd_level;
}

}  // namespace

bool can_run(SimdLevel simd_level)
{
    static const SimdLevel maximum = widest();
    return simd_level <= maximum;
}

bool has_avx()
{
#if defined(__x86_64__) || defined(__i386__)
    static const bool has = (__builtin_cpu_init(), __builtin_cpu_supports("avx"));
    return has;
#else
    return false;
#endif
}

SimdLevel default_simd_level() { return simd_level_in_use().load(std::memory_order_relaxed); }

void set_simd_level(SimdLevel simd_level) { simd_level_in_use().store(simd_level, std::memory_order_relaxed); }

}  // namespace claque::math
