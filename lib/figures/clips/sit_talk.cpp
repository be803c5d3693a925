// Talking to the neighbour on the left: turns to him and nods; the right hand gestures.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/seat.h"

namespace claque::figures
{

namespace
{

// An open hand in front of the chest, palm up; `offer` 0 to 1 holds it out.
Grip telling(float offer)
{
    const Grip near = {
        {0.115f, 0.800f, -0.090f}, {-0.42f, 0.32f, 0.85f}, {0.60f, -0.72f, 0.30f}, {0.50f, -0.6f, -0.5f}, 0.18f};
    const Grip far = {
        {0.085f, 0.770f, 0.000f}, {-0.45f, 0.10f, 0.90f}, {0.25f, -0.95f, 0.15f}, {0.55f, -0.6f, -0.5f}, 0.08f};
    return mix(near, far, offer);
}

}  // namespace

Pose sit_talk_at(float phase)
{
    Posture body;
    const float turn_to = hold(phase, 0.04f, 0.15f, 0.86f, 0.97f);
    const float telling_it = hold(phase, 0.16f, 0.25f, 0.62f, 0.74f);
    const float beat = hold(phase, 0.27f, 0.31f, 0.34f, 0.38f) + hold(phase, 0.40f, 0.44f, 0.50f, 0.55f);
    const float listening = hold(phase, 0.70f, 0.74f, 0.82f, 0.86f);
    body.breath = wave(phase, 2);
    body.twist = 24 * hold(phase, 0.06f, 0.19f, 0.85f, 0.97f);
    body.look = 36 * turn_to;
    body.sway = -3 * turn_to;
    body.bend += 3 * telling_it * beat;
    body.cock = -4 * turn_to + 3 * listening;
    body.nod += 4 * beat * telling_it + 6 * listening * swell(ease(0.70f, 0.86f, phase), 2);
    body.shrug_r = 5 * telling_it * beat;
    return seated(body, in_lap(Side::left),
                  mix(in_lap(Side::right), telling(beat), telling_it, glm::vec3(0.01f, 0.02f, 0.02f)));
}

}  // namespace claque::figures
