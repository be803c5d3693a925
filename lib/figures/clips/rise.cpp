// From the seat to one's feet and back: the trunk leans forward until the weight is over the feet, and only then do the
// hips leave the seat; the feet stay.
#include <glm/geometric.hpp>

#include "lib/figures/clips/clips.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/seat.h"
#include "lib/figures/clips/stance.h"

namespace claque::figures
{

namespace
{

// How far along each part of the body is, from sitting (0) to standing (1).
struct Progress {
    float ahead, up;  // of the hips
    float lean;       // 0: as in either end, 1: bent over the feet
    float arms;
};

glm::vec3 hips_of(const Pose &pose) { return (pose.joint(Bone::thigh) + pose.joint(Bone::thigh_r)) * 0.5f; }

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
    for (const Bone bone : trunk) pose.set(bone, part(sat.local(bone), stood.local(bone), at.up));
    const glm::vec3 from = hips_of(sat), to = hips_of(stood);
    const glm::vec3 hips(from.x + (to.x - from.x) * at.up, from.y + (to.y - from.y) * at.up,
                         from.z + (to.z - from.z) * at.ahead);
    pose.shift_pelvis(pose.shift(Bone::pelvis) + hips - hips_of(pose));
    for (const Side side : {Side::left, Side::right}) {
        const float knee = posture.knees_out + (0.10f - posture.knees_out) * at.up;
        stand_on(pose, side, {0.012f, side == Side::left ? 0.016f : -0.010f, 0, 1, 0, 5, knee});
    }
    drape_lap(pose);
    // The hands push on the thighs, which take them along, and then hang.
    Pose pushing = pose;
    for (const Side side : {Side::left, Side::right}) {
        take(pushing, side, in_lap(side));
        for (const Bone bone :
             {Bone::upper_arm, Bone::forearm, Bone::hand, Bone::fingers, Bone::fingertips, Bone::thumb})
            pose.set(on(side, bone), part(pushing.local(on(side, bone)), stood.local(on(side, bone)), at.arms));
    }
    return pose;
}

}  // namespace

Pose rise_at(float phase)
{
    return on_the_way({ease(0.20f, 0.78f, phase), ease(0.28f, 0.96f, phase), hold(phase, 0.02f, 0.42f, 0.40f, 0.86f),
                       ease(0.30f, 0.90f, phase)});
}

Pose sit_down_at(float phase)
{
    const float back = 1 - phase;
    return on_the_way({ease(0.22f, 0.84f, back), ease(0.26f, 0.97f, back), hold(back, 0.03f, 0.40f, 0.38f, 0.88f),
                       ease(0.16f, 0.80f, back)});
}

}  // namespace claque::figures
