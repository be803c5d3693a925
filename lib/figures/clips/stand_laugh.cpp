// Standing as in `stand`, and laughing: head back, then bent over a hand on the belly, the shoulders shaking.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/grip.h"

namespace claque::figures
{

Pose stand_laugh_at(float phase)
{
    Pose pose = stand_at(phase);
    const float back = hold(phase, 0.02f, 0.14f, 0.30f, 0.46f), over = hold(phase, 0.34f, 0.50f, 0.74f, 0.94f);
    const float mirth = hold(phase, 0.04f, 0.16f, 0.78f, 0.96f);
    const float shake = mirth * wave(phase, 19);
    const auto more = [&pose](Bone bone, glm::quat turn_by) { pose.set(bone, pose.local(bone) * turn_by); };
    more(Bone::spine, pitch(-3 * back + 9 * over));
    more(Bone::spine_upper, pitch(-4 * back + 10 * over - 0.8f * shake));
    more(Bone::chest, pitch(-4 * back + 8 * over - 1.2f * shake));
    more(Bone::neck, pitch(-9 * back - 6 * over));
    more(Bone::head, pitch(-10 * back - 4 * over + 1.2f * shake) * yaw(6 * back - 6 * over));
    const float shrug = 4 * mirth + 2.5f * shake;
    for (const Side side : {Side::left, Side::right}) {
        const Bone clavicle = on(side, Bone::clavicle), arm = on(side, Bone::upper_arm);
        const float raised = side == Side::left ? shrug : -shrug;
        pose.set(clavicle, pose.local(clavicle) * roll(raised));
        // Shoulders go up, arms hang on, and keep clear of the cloth when the body bends.
        const float clear = side == Side::left ? 6 * over : -6 * over;
        pose.set(arm, roll(clear - raised) * pose.local(arm));
    }
    const float belly = hold(phase, 0.10f, 0.36f, 0.78f, 0.97f);
    const Grip on_belly = {
        {0.130f, 1.120f, 0.215f}, {-0.95f, 0.05f, 0.05f}, {0.15f, 0.10f, 1}, {0.45f, -0.8f, -0.45f}, 0.08f};
    blend_to_grip(pose, Side::right, on_belly, belly, {0, 0, 0.06f}, 0.3f);
    return pose;
}

}  // namespace claque::figures
