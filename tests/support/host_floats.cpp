#include "tests/support/host_floats.h"

namespace host_floats
{

#if defined(__x86_64__) || defined(__i386__)

namespace
{

constexpr uint32_t flags = 0x3f;

// MXCSR in the lower half of the control word, x87's in the upper.
constexpr Words words(uint64_t sse, uint64_t x87, uint64_t raised) { return {x87 << 32 | sse, raised << 8 | raised}; }

}  // namespace

Words now()
{
    uint32_t sse;
    uint16_t x87, x87_raised;
    __asm__ volatile("stmxcsr %0\n\tfnstcw %1\n\tfnstsw %2" : "=m"(sse), "=m"(x87), "=m"(x87_raised));
    return {uint64_t(x87) << 32 | (sse & ~flags), uint64_t(x87_raised & flags) << 8 | (sse & flags)};
}

void set(const Words &wanted)
{
    const uint32_t sse = static_cast<uint32_t>(wanted.control) | (static_cast<uint32_t>(wanted.raised) & flags);
    uint32_t environment[7];
    __asm__ volatile("fnstenv %0" : "=m"(environment));
    environment[0] = (environment[0] & 0xffff0000u) | static_cast<uint16_t>(wanted.control >> 32);
    environment[1] = (environment[1] & ~flags) | (static_cast<uint32_t>(wanted.raised >> 8) & flags);
    __asm__ volatile("fldenv %0\n\tldmxcsr %1" : : "m"(environment), "m"(sse));
}

// Under the first and the last, flags tell when they are lost and when they are left behind.
const std::vector<Setting> &settings()
{
    constexpr uint64_t usual = 0x1f80, usual_x87 = 0x37f, zero_divided = 0x04;
    static const std::vector<Setting> all = {
        {"usual", words(usual, usual_x87, zero_divided)},
        {"upward", words(usual | 0x4000, usual_x87 | 0x800, 0)},
        {"downward", words(usual | 0x2000, usual_x87 | 0x400, zero_divided)},
        {"flushed", words(usual | 0x8040, usual_x87, 0)},
        {"short", words(usual, usual_x87 & ~uint64_t(0x300), zero_divided)},
        {"trapped", words(0, 0x340, 0)},
    };
    return all;
}

#elif defined(__aarch64__)

Words now()
{
    Words found;
    __asm__ volatile("mrs %0, fpcr\n\tmrs %1, fpsr" : "=r"(found.control), "=r"(found.raised));
    return found;
}

void set(const Words &wanted)
{
    __asm__ volatile("msr fpcr, %0\n\tmsr fpsr, %1" : : "r"(wanted.control), "r"(wanted.raised));
}

const std::vector<Setting> &settings()
{
    static const std::vector<Setting> all = {
        {"usual", {0, 2}}, {"upward", {1u << 22, 0}}, {"downward", {2u << 22, 2}}, {"flushed", {1u << 24, 0}}};
    return all;
}

#else

Words now() { return {}; }
void set(const Words &) {}
const std::vector<Setting> &settings()
{
    static const std::vector<Setting> none;
    return none;
}

#endif

std::atomic<uint64_t> met{0}, met_others{0};

Callback::Callback(const Words &expected) : found_(now())
{
    ++(found_.control == expected.control ? met : met_others);
    if (!settings().empty()) set({settings().front().words.control, 0});
}

}  // namespace host_floats
