// Standing as in `stand`, and resting on one leg after the other: the hip of the free leg sinks and its knee gives way.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/stance.h"

namespace claque::figures
{

Pose stand_shift_at(float phase)
{
    Pose pose = stand_at(phase);
    // On the left leg where positive.
    const float lean = hold(phase, 0.55f, 0.68f, 0.84f, 0.97f) - hold(phase, 0.05f, 0.19f, 0.40f, 0.53f);
    const auto more = [&pose](Bone bone, glm::quat turn_by) { pose.set(bone, pose.local(bone) * turn_by); };
    pose.shift_pelvis(pose.shift(Bone::pelvis) + glm::vec3(0.038f * lean, -0.009f * lean * lean, 0));
    more(Bone::pelvis, roll(3.6f * lean) * yaw(-3 * lean));
    more(Bone::spine, roll(-2.4f * lean) * yaw(1.5f * lean));
    more(Bone::spine_upper, roll(-1.9f * lean) * yaw(1.5f * lean));
    more(Bone::chest, roll(-0.8f * lean));
    more(Bone::head, roll(1.2f * lean) * pitch(2.0f * lean * lean));
    for (const Side side : {Side::left, Side::right}) {
        // The hip that is pushed out takes the arm along.
        const glm::quat arm = pose.local(on(side, Bone::upper_arm)), own = side == Side::left ? arm : mirrored(arm);
        pose.set(side, Bone::upper_arm, roll(2.5f * lean * lean) * own);
        stand_on(pose, side, {0.012f, side == Side::left ? 0.016f : -0.010f, 0, 1, 0, 5});
    }
    drape(pose, -1.2f * wave(phase, 1) - 2.0f * lean);
    return pose;
}

}  // namespace claque::figures
