// Standing as in `stand`, and waving with the right hand to a person in the distance.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/grip.h"

namespace claque::figures
{

Pose stand_wave_at(float phase)
{
    Pose pose = stand_at(phase);
    const float up = hold(phase, 0.01f, 0.31f, 0.69f, 0.99f);
    const float to_and_fro = hold(phase, 0.20f, 0.32f, 0.68f, 0.80f) * wave(phase, 6);
    const auto more = [&pose](Bone bone, glm::quat turn_by) { pose.set(bone, pose.local(bone) * turn_by); };
    more(Bone::spine_upper, roll(2.0f * up) * yaw(3 * up));
    more(Bone::chest, roll(2.5f * up) * pitch(-3 * up) * yaw(3 * up));
    more(Bone::head, yaw(-5 * up) * pitch(-5 * up));
    more(Bone::clavicle_r, mirrored(roll(9 * up)));
    const Grip waving = {{0.205f + 0.040f * to_and_fro, 1.645f - 0.008f * to_and_fro * to_and_fro, 0.250f},
                         {0.03f + 0.36f * to_and_fro, 1, 0.12f},
                         {0.10f, 0.10f, -1},
                         {0.32f, -1, 0.35f},
                         0.03f};
    blend_to_grip(pose, Side::right, waving, up, {0.02f, 0, 0.20f}, 1);
    return pose;
}

}  // namespace claque::figures
