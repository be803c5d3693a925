// Standing as in `stand`, and waving to somebody over there with the right hand.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/grip.h"

namespace claque::figures
{

Pose stand_wave_at(float phase)
{
    Pose pose = stand_at(phase);
    const float up = hold(phase, 0.03f, 0.22f, 0.78f, 0.97f);
    const float to_and_fro = hold(phase, 0.14f, 0.26f, 0.74f, 0.86f) * wave(phase, 6);
    const auto more = [&pose](Bone bone, glm::quat turn_by) { pose.set(bone, pose.local(bone) * turn_by); };
    more(Bone::spine_upper, roll(2.0f * up) * yaw(3 * up));
    more(Bone::chest, roll(2.5f * up) * pitch(-3 * up) * yaw(3 * up));
    more(Bone::head, yaw(-5 * up) * pitch(-5 * up));
    more(Bone::clavicle_r, mirrored(roll(9 * up)));
    const Pose hanging = pose;
    const Grip waving = {{0.255f + 0.055f * to_and_fro, 1.650f - 0.010f * to_and_fro * to_and_fro, 0.210f},
                         {0.10f + 0.42f * to_and_fro, 1, 0.12f},
                         {0.10f, 0.10f, -1},
                         {0.80f, -0.6f, 0.1f},
                         0.03f};
    take(pose, Side::right, waving);
    for (const Bone bone :
         {Bone::upper_arm_r, Bone::forearm_r, Bone::hand_r, Bone::fingers_r, Bone::fingertips_r, Bone::thumb_r})
        pose.set(bone, part(hanging.local(bone), pose.local(bone), up));
    return pose;
}

}  // namespace claque::figures
