// Sitting still: breath, small shifts of weight from side to side, a glance, the hands on the thighs and then together.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/seat.h"

namespace claque::figures
{

namespace
{

// Hands laid one over the other in the lap.
Grip folded(Side side)
{
    if (side == Side::left)
        return {{0.112f, 0.611f, -0.165f}, {-0.80f, -0.10f, 0.60f}, {0.12f, 1, 0.30f}, {0.50f, -0.4f, -0.6f}, 0.10f};
    return {{0.108f, 0.638f, -0.170f}, {-0.80f, -0.14f, 0.55f}, {0.10f, 1, 0.25f}, {0.50f, -0.4f, -0.6f}, 0.12f};
}

}  // namespace

Pose sit_at(float phase)
{
    Posture body;
    const float settle = hold(phase, 0.30f, 0.42f, 0.70f, 0.85f);  // sits up, and sinks again
    body.breath = wave(phase, 2);
    body.tilt += 2.0f * settle;
    body.bend -= 4.0f * settle;
    body.sway = 1.6f * wave(phase, 1);
    body.twist = 2.0f * swell(phase) - 3.0f * settle;
    body.look = 7 * hold(phase, 0.12f, 0.18f, 0.34f, 0.42f) - 9 * hold(phase, 0.50f, 0.57f, 0.80f, 0.90f);
    body.nod += 2.0f * wave(phase, 1) - 2.0f * settle;
    body.cock = 1.5f * wave(phase, 1);
    Grip left = in_lap(Side::left), right = in_lap(Side::right);
    left.curl += 0.05f * swell(phase, 3);
    right.curl += 0.06f * swell(phase, 2);
    const float fold = hold(phase, 0.26f, 0.40f, 0.76f, 0.90f);
    const glm::vec3 over(0, 0.03f, 0);
    return seated(body, mix(left, folded(Side::left), ease(0, 0.85f, fold), over),
                  mix(right, folded(Side::right), ease(0.15f, 1, fold), over * 1.5f));
}

}  // namespace claque::figures
