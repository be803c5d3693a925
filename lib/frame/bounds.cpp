// Coarse bounds, before the first cull phase. Most of a large crowd is far from every view, and a bound of 16 bytes for
// each individual is enough to find that. Individuals that are dropped here would not pass that phase.
#include <cstring>

#include "lib/frame/steps.h"

namespace claque::frame
{

namespace
{

// Moves the rows that are near to the front, in their order, and returns their number. Few are near, so the others are
// skipped eight at a time.
uint32_t keep_near(base::Span<uint32_t> tested, const uint8_t *near)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < tested.count; ++i) {
        uint64_t eight = 1;
        if (i % 8 == 0 && i + 8 <= tested.count) std::memcpy(&eight, near + i, sizeof eight);
        if (eight == 0) i += 7;
        else if (near[i]) tested[count++] = tested[i];
    }
    return count;
}

}  // namespace

base::Status CullBounds::check() const
{
    if (near.count < tested.count) return base::Status::bad(CLQ_ARGUMENT, "no room for all that are tested");
    return base::Status::good();
}

uint32_t CullBounds::run() const
{
    if (given.traditional()) return tested.count;
    constexpr uint32_t ahead = 64;  // rows: bounds are rarely in a CPU cache, so they are prefetched
    given.for_slices(tested.count, [&](uint32_t i) {
        if (i + ahead < tested.count) __builtin_prefetch(&given.crowd.bound_of(tested[i + ahead]));
        const math::RoughSphere &bound = given.crowd.bound_of(tested[i]);
        bool any = false;
        for (const CameraState &eye : given.eyes) any = any || !math::is_outside(eye.rough, bound);
        near[i] = any;
    });
    return keep_near(tested, near.data);
}

}  // namespace claque::frame
