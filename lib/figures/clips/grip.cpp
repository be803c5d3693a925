#include "lib/figures/clips/grip.h"

#include <glm/geometric.hpp>

#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/stance.h"
#include "lib/figures/mesh.h"

namespace claque::figures
{

namespace
{

glm::vec3 turned(glm::vec3 from, glm::vec3 to, float share)
{
    return glm::normalize(glm::normalize(from) * (1 - share) + glm::normalize(to) * share);
}

// Half of the rotation of `q` about `axis` (its twist).
glm::quat half_twist(glm::quat q, glm::vec3 axis)
{
    if (q.w < 0) q = -q;
    const glm::vec3 about = axis * glm::dot(glm::vec3(q.x, q.y, q.z), axis);
    const glm::quat twist = glm::normalize(glm::quat(q.w, about.x, about.y, about.z));
    return glm::normalize(glm::quat(twist.w + 1, twist.x, twist.y, twist.z));
}

}  // namespace

Grip mix(const Grip &from, const Grip &to, float share, glm::vec3 arc, float tuck)
{
    const float middle = 4 * share * (1 - share);
    Grip grip;
    grip.wrist = from.wrist + (to.wrist - from.wrist) * share + arc * middle;
    grip.along = turned(from.along, to.along, share);
    grip.back = turned(from.back, to.back, share);
    grip.pole = turned(from.pole, to.pole, share) + glm::vec3(-0.3f, -1, 0) * (tuck * middle);
    grip.curl = from.curl + (to.curl - from.curl) * share;
    return grip;
}

Grip clapping(float apart, glm::vec3 middle)
{
    constexpr float touching = 0.0205f;  // half the distance between the hands' centre planes when the palms meet
    const float open = 18 * apart;
    const glm::quat spread = yaw(open * 0.6f) * roll(-open * 0.4f);
    Grip grip;
    grip.along = spread * glm::normalize(glm::vec3(0, 0.66f, 0.75f));
    grip.back = spread * glm::vec3(1, 0, 0);
    grip.wrist = middle + glm::vec3(touching + 0.115f * apart, 0, 0) - glm::vec3(0, 0.66f, 0.75f) * 0.07f;
    grip.pole = glm::vec3(0.85f, -0.75f, -0.30f);
    grip.curl = -0.055f + 0.12f * apart;
    return grip;
}

void apply_grip(Pose &pose, Side side, const Grip &grip)
{
    reach_hand(pose, side, grip.wrist, grip.pole);
    glm::quat hand = rotation_between_frames(arm_direction(), arm_dorsal(), grip.along, grip.back);
    if (side == Side::right) hand = mirrored(hand);
    const Bone forearm = on(side, Bone::forearm);
    const glm::quat in_forearm = glm::conjugate(pose.world(forearm)) * hand;
    pose.set(forearm, glm::normalize(pose.local(forearm) * half_twist(in_forearm, mirrored(arm_direction(), side))));
    pose.set_world(on(side, Bone::hand), hand);
    curl_hand(pose, side, grip.curl);
}

Grip grip_of(const Pose &pose, Side side)
{
    const Bone hand = on(side, Bone::hand);
    const glm::quat turned = pose.world(hand);
    const glm::vec3 shoulder = pose.joint(on(side, Bone::upper_arm)), wrist = pose.joint(hand);
    Grip grip;
    grip.wrist = mirrored(wrist, side);
    grip.along = mirrored(turned * mirrored(arm_direction(), side), side);
    grip.back = mirrored(turned * mirrored(arm_dorsal(), side), side);
    grip.pole = mirrored(pose.joint(on(side, Bone::forearm)) - (shoulder + wrist) * 0.5f, side);
    grip.curl = 0.16f;
    return grip;
}

void blend_to_grip(Pose &pose, Side side, const Grip &to, float share, glm::vec3 arc, float tuck)
{
    const Pose before = pose;
    apply_grip(pose, side, mix(grip_of(before, side), to, share, arc, tuck));
    blend_arm(pose, before, side, 1 - ease(0, 0.3f, share));
}

void move_wrist(Pose &pose, Side side, glm::vec3 wrist, glm::vec3 pole)
{
    const Bone upper = on(side, Bone::upper_arm), forearm = on(side, Bone::forearm), hand = on(side, Bone::hand);
    const glm::quat held = pose.world(hand);
    const glm::vec3 shoulder = pose.joint(upper), elbow = pose.joint(forearm), now = pose.joint(hand);
    // The twist of a bone about itself is what a plain reach leaves.
    const Pose before = pose;
    Pose plain = pose;
    reach_hand(plain, side, mirrored(now, side), mirrored(elbow - (shoulder + now) * 0.5f, side));
    reach_hand(pose, side, mirrored(wrist, side), mirrored(pole, side));
    for (const Bone bone : {upper, forearm})
        pose.set(bone, glm::normalize(pose.local(bone) * glm::conjugate(plain.local(bone)) * before.local(bone)));
    pose.set_world(hand, held);
}

void blend_arm(Pose &pose, const Pose &as, Side side, float share)
{
    for (const Bone left : {Bone::upper_arm, Bone::forearm, Bone::hand, Bone::fingers, Bone::fingertips, Bone::thumb}) {
        const Bone bone = on(side, left);
        pose.set(bone, nlerp(pose.local(bone), as.local(bone), share));
    }
}

}  // namespace claque::figures
