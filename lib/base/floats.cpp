// The floating-point settings of each thread. One copy for all libraries, in libclaque, so that a callback that
// libclaque calls for libclaque-stage runs under the host's settings too.
#include "lib/base/floats.h"

#include <cfenv>
#include <cstdint>

namespace
{

#if defined(__x86_64__) || defined(__i386__)

// MXCSR and x87's control and status word: exceptions masked, to nearest, denormals kept, 64 bits of precision.
constexpr uint32_t own_sse = 0x1f80, sse_flags = 0x3f;
constexpr uint16_t own_x87 = 0x37f, x87_controls = 0xf3f, x87_flags = 0x3f;

struct Settings {
    uint32_t sse;
    uint16_t x87, x87_raised;
};

Settings settings() noexcept
{
    Settings now;
    __asm__ volatile("stmxcsr %0\n\tfnstcw %1\n\tfnstsw %2" : "=m"(now.sse), "=m"(now.x87), "=m"(now.x87_raised));
    now.x87_raised &= x87_flags;
    return now;
}

bool is_own(const Settings &given) noexcept
{
    return (given.sse & ~sse_flags) == own_sse && (given.x87 & x87_controls) == (own_x87 & x87_controls);
}

// The flags of x87 can be set with its whole environment only.
void set_x87(uint16_t control, uint16_t raised) noexcept
{
    uint32_t environment[7];
    __asm__ volatile("fnstenv %0" : "=m"(environment));
    environment[0] = (environment[0] & 0xffff0000u) | control;
    environment[1] = (environment[1] & ~uint32_t(x87_flags)) | raised;
    __asm__ volatile("fldenv %0" : : "m"(environment));
}

void set(const Settings &wanted) noexcept
{
    const Settings now = settings();
    if (now.x87_raised != wanted.x87_raised) set_x87(wanted.x87, wanted.x87_raised);
    else if (now.x87 != wanted.x87) __asm__ volatile("fldcw %0" : : "m"(wanted.x87));
    if (now.sse != wanted.sse) __asm__ volatile("ldmxcsr %0" : : "m"(wanted.sse));
}

void set_own(const Settings &found) noexcept { set({own_sse | (found.sse & sse_flags), own_x87, found.x87_raised}); }

#elif defined(__aarch64__)

struct Settings {
    uint64_t control, raised;
};

Settings settings() noexcept
{
    Settings now;
    __asm__ volatile("mrs %0, fpcr\n\tmrs %1, fpsr" : "=r"(now.control), "=r"(now.raised));
    return now;
}

bool is_own(const Settings &given) noexcept { return given.control == 0; }

void set(const Settings &wanted) noexcept
{
    const Settings now = settings();
    if (now.control != wanted.control) __asm__ volatile("msr fpcr, %0" : : "r"(wanted.control));
    if (now.raised != wanted.raised) __asm__ volatile("msr fpsr, %0" : : "r"(wanted.raised));
}

void set_own(const Settings &found) noexcept { set({0, found.raised}); }

#else

struct Settings {
    std::fenv_t all;
};

Settings settings() noexcept
{
    Settings now;
    std::fegetenv(&now.all);
    return now;
}

bool is_own(const Settings &) noexcept { return false; }
void set(const Settings &wanted) noexcept { std::fesetenv(&wanted.all); }
void set_own(const Settings &) noexcept { std::fesetenv(FE_DFL_ENV); }

#endif

struct Thread {
    Settings hosts;
    bool inside, differ;
};
thread_local Thread thread;

}  // namespace

extern "C" {

bool clq_floats_enter(void)
{
    Thread &here = thread;
    if (here.inside) return false;
    here.hosts = settings();
    here.differ = !is_own(here.hosts);
    if (here.differ) set_own(here.hosts);
    return here.inside = true;
}

bool clq_floats_leave(void)
{
    Thread &here = thread;
    if (!here.inside) return false;
    set(here.hosts);
    here.inside = false;
    return true;
}

bool clq_floats_differ(void) { return thread.inside && thread.differ; }

}  // extern "C"
