// Watching closely: leans forward, forearms on the thighs, hands loosely together, chin up; then back.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/seat.h"

namespace claque::figures
{

namespace
{

// Hands hang between the knees, one over the other.
Grip between_knees(Side side)
{
    if (side == Side::left)
        return {
            {0.066f, 0.622f, 0.185f}, {-0.45f, -0.50f, 0.75f}, {0.72f, 0.55f, 0.45f}, {0.62f, -0.45f, -0.4f}, 0.32f};
    return {{0.070f, 0.600f, 0.175f}, {-0.40f, -0.55f, 0.75f}, {0.75f, 0.55f, 0.45f}, {0.62f, -0.45f, -0.4f}, 0.30f};
}

}  // namespace

Pose sit_lean_at(float phase)
{
    Posture body;
    const float lean = hold(phase, 0.05f, 0.24f, 0.74f, 0.93f);
    body.breath = wave(phase, 2) * (1 - 0.5f * lean);
    body.tilt += 27 * lean;
    body.bend += 14 * lean + 1.0f * lean * wave(phase, 2);
    body.nod += 4 * lean;
    body.look = 10 * hold(phase, 0.32f, 0.40f, 0.50f, 0.60f) - 6 * hold(phase, 0.55f, 0.62f, 0.72f, 0.80f);
    body.cock = 3 * hold(phase, 0.40f, 0.50f, 0.60f, 0.70f);
    const glm::vec3 up(0.01f, 0.05f, 0);
    return seated(body, mix(in_lap(Side::left), between_knees(Side::left), lean, up, 0.2f),
                  mix(in_lap(Side::right), between_knees(Side::right), lean, up, 0.2f));
}

}  // namespace claque::figures
