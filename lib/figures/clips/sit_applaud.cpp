// Applauding on the seat: the hands leave the lap, clap ten times, and return.

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/seat.h"
#include "lib/math/trig.h"

namespace claque::figures
{

namespace
{

constexpr float first = 0.15f, last = 0.85f;  // phases between which the palms meet
constexpr int seated_claps = 12;

}  // namespace

Pose sit_applaud_at(float phase)
{
    Posture body;
    const float up = hold(phase, 0.02f, first, last, 0.98f);
    const float through = (phase - first) / (last - first) * static_cast<float>(seated_claps);
    const float s = through > 0 && through < static_cast<float>(seated_claps) ? math::sin(pi * through) : 0;
    // Before the first clap and after the last one the hands are further apart.
    const float ends = 1 - hold(phase, first - 0.05f, first, last, last + 0.05f);
    const float apart = s * s + 0.8f * ends;
    body.breath = wave(phase, 2) * (1 - up);
    body.tilt += 4 * up;
    body.bend += -5 * up + 0.8f * up * (1 - s * s);
    body.look = 10 * wave(phase, 1) * up;
    body.nod += -3 * up + 2.5f * up * wave(phase, 4);
    body.cock = 2.5f * wave(phase, 2) * up;
    body.shrug_l = body.shrug_r = 3 * up;
    Grip clap = clapping(apart, glm::vec3(0, 0.845f, -0.055f));
    clap.pole = glm::vec3(0.40f, -1, -0.15f);  // neighbours sit close
    const glm::vec3 arc(0.02f, 0, 0.03f);
    return seated(body, mix(in_lap(Side::left), clap, up, arc, 0.3f), mix(in_lap(Side::right), clap, up, arc, 0.3f));
}

}  // namespace claque::figures
