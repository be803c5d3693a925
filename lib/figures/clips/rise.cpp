// From the seat to standing, and back. The trunk leans forward until the weight is over the feet; only then do the hips
// leave the seat. The feet stay in place.
#include <glm/geometric.hpp>

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/seat.h"
#include "lib/figures/clips/stance.h"
#include "lib/figures/mesh.h"

namespace claque::figures
{

namespace
{

// The progress of each part of the body from sitting (0) to standing (1).
struct Progress {
    float ahead, up;  // of the hips
    float lean;       // 0: as at either end, 1: bent over the feet
    float arms;
};

glm::vec3 hips_of(const Pose &pose) { return (pose.joint(Bone::thigh) + pose.joint(Bone::thigh_r)) * 0.5f; }

// A hand that follows its thigh and slides up it by `slide` metres, because the arm has a fixed length.
Grip carried(const Pose &sat, const Pose &pose, Side side, float slide)
{
    const Bone thigh = on(side, Bone::thigh);
    const glm::quat turned = pose.world(thigh) * glm::conjugate(sat.world(thigh));
    const auto along_with = [side, turned](glm::vec3 left) { return mirrored(turned * mirrored(left, side), side); };
    Grip grip = in_lap(side);
    grip.wrist.z -= slide;
    // Over the cloth that gathers before the hips.
    grip.wrist.y += 0.6f * slide;
    grip.along.y += 2.2f * slide;
    const glm::vec3 joint = mirrored(sat.joint(thigh), side);
    grip.wrist = mirrored(pose.joint(thigh), side) + along_with(grip.wrist - joint);
    grip.along = along_with(grip.along);
    grip.back = along_with(grip.back);
    return grip;
}

Pose on_the_way(const Progress &at)
{
    const Pose stood = stand_at(0);
    Posture posture;
    posture.tilt += 30 * at.lean * (1 - 0.4f * at.up);
    posture.bend += 16 * at.lean;
    posture.nod += 6 * at.lean;
    const Pose sat = posed(posture);
    Pose pose = sat;
    const Bone trunk[] = {Bone::pelvis, Bone::spine, Bone::spine_upper, Bone::chest,
                          Bone::neck,   Bone::head,  Bone::clavicle,    Bone::clavicle_r};
    for (const Bone bone : trunk) pose.set(bone, nlerp(sat.local(bone), stood.local(bone), at.up));
    const glm::vec3 from = hips_of(sat), to = hips_of(stood);
    const glm::vec3 hips(from.x + (to.x - from.x) * at.up, from.y + (to.y - from.y) * at.up,
                         from.z + (to.z - from.z) * at.ahead);
    pose.shift_pelvis(pose.shift(Bone::pelvis) + hips - hips_of(pose));
    for (const Side side : {Side::left, Side::right}) {
        const float knee = posture.knees_out + (0.10f - posture.knees_out) * at.up;
        stand_on(pose, side, {0.012f, side == Side::left ? 0.016f : -0.010f, 0, 1, 0, 5, knee});
    }
    drape_lap(pose);
    // The hands push on the thighs and move with them, then swing round them and hang.
    for (const Side side : {Side::left, Side::right}) {
        const Bone shoulder = on(side, Bone::upper_arm);
        Grip hanging = grip_of(stood, side);
        hanging.wrist += mirrored(pose.joint(shoulder) - stood.joint(shoulder), side);
        apply_grip(pose, side, mix(carried(sat, pose, side, 0.10f * at.up), hanging, at.arms, {0.10f, 0.09f, 0.05f}));
        blend_arm(pose, stood, side, ease(0.5f, 1, at.arms));
    }
    return pose;
}

}  // namespace

Pose rise_at(float phase)
{
    return on_the_way({ease(0.20f, 0.78f, phase), ease(0.28f, 0.96f, phase), hold(phase, 0.02f, 0.42f, 0.40f, 0.86f),
                       ease(0.36f, 0.98f, phase)});
}

Pose sit_down_at(float phase)
{
    const float back = 1 - phase;
    return on_the_way({ease(0.20f, 0.80f, back), ease(0.27f, 0.96f, back), hold(back, 0.03f, 0.40f, 0.38f, 0.88f),
                       ease(0.34f, 0.97f, back)});
}

}  // namespace claque::figures
