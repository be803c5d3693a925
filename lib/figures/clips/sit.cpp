// Sitting still, as far as people do: breath, a little weight from one side to the other, a glance.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/seat.h"

namespace claque::figures
{

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
    return seated(body, left, right);
}

}  // namespace claque::figures
