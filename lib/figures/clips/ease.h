// Easing functions over the phase of a clip: how a movement starts, holds and stops.
#pragma once

#include "lib/figures/clips/pose.h"
#include "lib/math/trig.h"

namespace claque::figures
{

// 0 up to `from`, 1 after `to`; the acceleration is 0 at both.
inline float ease(float from, float to, float x)
{
    const float t = (x - from) / (to - from);
    return t <= 0 ? 0 : t >= 1 ? 1 : t * t * t * (10 + t * (6 * t - 15));
}

// As ease, with acceleration at both ends and softer between them.
inline float smooth(float from, float to, float x)
{
    float t = (x - from) / (to - from);
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return t * t * (3 - 2 * t);
}

// From p0 to p1 as t goes from 0 to 1, with velocity v0 at the start and v1 at the end.
inline float hermite(float p0, float v0, float p1, float v1, float t)
{
    const float t2 = t * t, t3 = t2 * t;
    return p0 * (2 * t3 - 3 * t2 + 1) + v0 * (t3 - 2 * t2 + t) + p1 * (-2 * t3 + 3 * t2) + v1 * (t3 - t2);
}

// Rises between `from` and `full`, falls between `until` and `to`.
inline float hold(float phase, float from, float full, float until, float to)
{
    return ease(from, full, phase) * (1 - ease(until, to, phase));
}

// Rises from 0 to 1 and falls back `cycles` times.
inline float swell(float phase, int cycles = 1)
{
    const float s = math::sin(pi * static_cast<float>(cycles) * phase);
    return s * s;
}

}  // namespace claque::figures
