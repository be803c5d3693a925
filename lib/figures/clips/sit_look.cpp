// Looking about: left, right, up to the rows above the theatre's stage, and ahead again.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/seat.h"

namespace claque::figures
{

Pose sit_look_at(float phase)
{
    Posture body;
    const float left = hold(phase, 0.05f, 0.15f, 0.27f, 0.37f), right = hold(phase, 0.34f, 0.46f, 0.58f, 0.67f);
    const float up = hold(phase, 0.66f, 0.75f, 0.86f, 0.96f);
    body.breath = wave(phase, 2);
    // The chest starts a little later than the head.
    body.twist = 8 * hold(phase, 0.08f, 0.19f, 0.28f, 0.40f) - 10 * hold(phase, 0.38f, 0.50f, 0.58f, 0.70f);
    body.look = 38 * left - 42 * right + 6 * up;
    body.nod += 3 * left - 3 * right - 22 * up;
    body.cock = -3 * left + 4 * right;
    body.bend -= 4 * up;
    body.tilt += 2 * up;
    body.sway = 1.5f * (right - left);
    return seated(body, in_lap(Side::left), in_lap(Side::right));
}

}  // namespace claque::figures
