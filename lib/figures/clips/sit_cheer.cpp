// Cheering on the seat: both fists go up, thrust in turn, and return to the lap.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/seat.h"

namespace claque::figures
{

namespace
{

Grip raised(float thrust)
{
    const Grip low = {
        {0.205f, 1.190f, -0.200f}, {0.05f, 0.98f, 0.10f}, {0.55f, 0.05f, -0.83f}, {0.22f, -0.8f, 0.75f}, 1};
    const Grip high = {{0.198f, 1.475f, -0.285f}, {0.02f, 1, 0.05f}, {0.55f, 0.05f, -0.83f}, {0.22f, -0.6f, 0.75f}, 1};
    return mix(low, high, thrust);
}

}  // namespace

Pose sit_cheer_at(float phase)
{
    Posture body;
    const float up = hold(phase, 0.03f, 0.20f, 0.80f, 0.97f);
    const float thrusts = hold(phase, 0.10f, 0.22f, 0.78f, 0.88f);
    const float left = thrusts * swell(phase, 5), right = thrusts * (1 - swell(phase, 5));
    body.breath = wave(phase, 1) * (1 - up);
    body.tilt += 9 * up;
    body.bend -= 16 * up;
    body.sway = 5 * (right - left);
    body.twist = 5 * (left - right);
    body.nod -= 8 * up;
    body.look = 8 * wave(phase, 2) * up;
    body.shrug_l = 10 * up + 9 * left;
    body.shrug_r = 10 * up + 9 * right;
    const glm::vec3 arc(0.02f, 0, 0.16f);
    return seated(body, mix(in_lap(Side::left), raised(left), up, arc, 2),
                  mix(in_lap(Side::right), raised(right), up, arc, 2));
}

}  // namespace claque::figures
