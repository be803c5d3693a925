// Laughing: the head goes back, the chest shakes, then the whole body folds over and a hand slaps the thigh.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/seat.h"

namespace claque::figures
{

Pose sit_laugh_at(float phase)
{
    Posture body;
    const float back = hold(phase, 0.02f, 0.12f, 0.30f, 0.44f), over = hold(phase, 0.34f, 0.48f, 0.72f, 0.92f);
    const float mirth = hold(phase, 0.04f, 0.14f, 0.76f, 0.95f);
    const float shake = mirth * wave(phase, 19);
    body.breath = wave(phase, 1) * (1 - mirth) + 1.4f * shake;
    body.tilt += 2 * back + 10 * over;
    body.bend += -12 * back + 12 * over + 1.6f * shake;
    body.nod += -20 * back + 14 * over + 1.2f * shake;
    body.look = 6 * back - 8 * over + 4 * wave(phase, 2) * mirth;
    body.cock = -5 * over + 3 * back;
    body.sway = 3 * over - 2 * back;
    body.shrug_l = body.shrug_r = 4 * mirth + 2.5f * shake;
    // Three slaps while bent over.
    const float slap = hold(phase, 0.42f, 0.46f, 0.68f, 0.72f) * swell((phase - 0.44f) / 0.27f, 3);
    Grip left = in_lap(Side::left), right = in_lap(Side::right);
    // When bent over, the elbows would stick out into the neighbours.
    left.pole.x -= 0.22f * over;
    right.pole.x -= 0.15f * over;
    right.wrist += glm::vec3(0.004f, 0.125f, -0.010f) * slap;
    right.pole += glm::vec3(-0.03f, 0, 0) * slap;
    right.along += glm::vec3(0, 0.40f, 0) * slap;
    right.wrist.y += 0.006f * over;
    return seated(body, left, right);
}

}  // namespace claque::figures
