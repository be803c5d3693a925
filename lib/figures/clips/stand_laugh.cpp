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
    for (const Side side : {Side::left, Side::right})
        pose.set(on(side, Bone::clavicle),
                 pose.local(on(side, Bone::clavicle)) *
                     (side == Side::left ? roll(4 * mirth + 2.5f * shake) : mirrored(roll(4 * mirth + 2.5f * shake))));
    const Pose hanging = pose;
    const float belly = hold(phase, 0.10f, 0.36f, 0.78f, 0.97f);
    take(pose, Side::right,
         {{0.130f, 1.130f, 0.215f}, {-0.95f, 0.05f, 0.05f}, {0.15f, 0.10f, 1}, {0.9f, -0.3f, -0.3f}, 0.08f});
    for (const Bone bone :
         {Bone::upper_arm_r, Bone::forearm_r, Bone::hand_r, Bone::fingers_r, Bone::fingertips_r, Bone::thumb_r})
        pose.set(bone, part(hanging.local(bone), pose.local(bone), belly));
    return pose;
}

}  // namespace claque::figures
