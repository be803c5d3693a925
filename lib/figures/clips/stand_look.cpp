// Standing as in `stand`, and looking round: far to the left, past the front, far to the right.
#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"

namespace claque::figures
{

Pose stand_look_at(float phase)
{
    Pose pose = stand_at(phase);
    const float left = hold(phase, 0.06f, 0.20f, 0.34f, 0.48f), right = hold(phase, 0.52f, 0.66f, 0.80f, 0.95f);
    const float head = left - right;
    // The body follows the head, and stays behind it.
    const float body = hold(phase, 0.10f, 0.25f, 0.36f, 0.51f) - hold(phase, 0.56f, 0.71f, 0.82f, 0.97f);
    const auto more = [&pose](Bone bone, glm::quat turn_by) { pose.set(bone, pose.local(bone) * turn_by); };
    more(Bone::spine, yaw(3 * body));
    more(Bone::spine_upper, yaw(5 * body));
    more(Bone::chest, yaw(6 * body));
    more(Bone::neck, yaw(12 * head) * pitch(-1.5f * left));
    more(Bone::head, yaw(14 * head) * pitch(-2.5f * left + 2.0f * right));
    return pose;
}

}  // namespace claque::figures
