// Waving from the seat to a person in the distance.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/seat.h"

namespace claque::figures
{

Pose sit_wave_at(float phase)
{
    Posture body;
    const float up = hold(phase, 0.03f, 0.24f, 0.76f, 0.97f);
    const float to_and_fro = hold(phase, 0.16f, 0.28f, 0.72f, 0.84f) * wave(phase, 6);
    body.breath = wave(phase, 1) * (1 - up);
    body.tilt += 6 * up;
    body.bend -= 9 * up;
    body.sway = -4 * up;
    body.twist = 6 * up;
    body.look = -16 * up + 2 * to_and_fro;
    body.nod -= 6 * up;
    body.cock = 3 * up;
    body.shrug_r = 9 * up;
    const Grip waving = {{0.186f + 0.034f * to_and_fro, 1.215f - 0.008f * to_and_fro * to_and_fro, -0.130f},
                         {0.02f + 0.34f * to_and_fro, 1, 0.12f},
                         {0.10f, 0.10f, -1},
                         {0.30f, -1, 0.4f},
                         0.03f};
    return seated(body, in_lap(Side::left), mix(in_lap(Side::right), waving, up, glm::vec3(0.01f, 0, 0.09f), 1.5f));
}

}  // namespace claque::figures
