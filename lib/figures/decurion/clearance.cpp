// The clips are made for a slim body in a tunic. This moves the decurion's arms outwards by as much as his body and his
// toga are wider than that one, so that they stay as far from the cloth as in the clip.
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "lib/figures/brush.h"
#include "lib/figures/clips/ease.h"
#include "lib/figures/clips/grip.h"
#include "lib/figures/decurion/decurion.h"

namespace claque::figures::decurion
{

namespace
{

// By height at rest: half widths of this body with all of its cloth, and how much they exceed those of the slim one.
struct Stoutness {
    float y, side, front, back;
    float more_side, more_front, more_back;
};
const std::array<Stoutness, 6> stoutness_rows = {{
    {0.600f, 0.215f, 0.190f, 0.176f, 0.020f, 0.045f, 0.010f},
    {0.780f, 0.230f, 0.215f, 0.182f, 0.040f, 0.070f, 0.015f},
    {0.950f, 0.232f, 0.230f, 0.176f, 0.055f, 0.105f, 0.030f},
    {1.080f, 0.222f, 0.222f, 0.160f, 0.060f, 0.095f, 0.035f},
    {1.200f, 0.205f, 0.195f, 0.160f, 0.054f, 0.074f, 0.030f},
    {1.330f, 0.175f, 0.160f, 0.150f, 0.015f, 0.020f, 0.015f},
}};
// How far beyond the cloth the movement fades. Elbows yield less, since neighbours sit close.
constexpr float hands_fade_m = 0.24f, elbows_fade_m = 0.045f, elbows_aside = 0.6f;
constexpr float lap_m = 0.026f;  // how much thicker the toga lies on the thighs

Stoutness stoutness_at(float y)
{
    const Stoutness *low = stoutness_rows.data();
    if (y <= low->y) return *low;
    for (size_t i = 1; i < stoutness_rows.size(); ++i) {
        const Stoutness &a = stoutness_rows[i - 1], &b = stoutness_rows[i];
        if (y > b.y) continue;
        const float t = (y - a.y) / (b.y - a.y);
        const auto between = [t](float from, float to) { return from + (to - from) * t; };
        return {y,
                between(a.side, b.side),
                between(a.front, b.front),
                between(a.back, b.back),
                between(a.more_side, b.more_side),
                between(a.more_front, b.more_front),
                between(a.more_back, b.more_back)};
    }
    return stoutness_rows.back();
}

// Outwards from the trunk, for a point in its rest position.
glm::vec3 beside_trunk(glm::vec3 rest, float fade_m)
{
    const Stoutness s = stoutness_at(rest.y);
    const glm::vec2 at(rest.x, rest.z);
    const float away = glm::length(at);
    if (away < 1e-4f) return glm::vec3(0);
    const glm::vec2 d = at / away;
    const float ahead = d.y > 0 ? s.front : s.back, more_ahead = d.y > 0 ? s.more_front : s.more_back;
    const float girth = 1 / glm::length(d / glm::vec2(s.side, ahead));
    const float more = glm::length(d * glm::vec2(s.more_side, more_ahead));
    const float near =
        smoothstep(girth + fade_m, girth, away) * smoothstep(0.30f, 0.55f, rest.y) * smoothstep(1.45f, 1.30f, rest.y);
    return glm::vec3(d.x, 0, d.y) * (more * near);
}

glm::vec3 outwards(const Pose &pose, glm::vec3 p, float fade_m)
{
    const auto by = [&](Bone bone, float &y) {
        const glm::quat turn = pose.world(bone);
        const glm::vec3 rest = glm::conjugate(turn) * (p - pose.joint(bone)) + skeleton().joint(bone);
        y = rest.y;
        return turn * beside_trunk(rest, fade_m);
    };
    float low_y = 0, middle_y = 0, high_y = 0;
    const glm::vec3 low = by(Bone::pelvis, low_y), middle = by(Bone::spine_upper, middle_y),
                    high = by(Bone::chest, high_y);
    const float above_pelvis = smoothstep(0.98f, 1.14f, middle_y), above_belly = smoothstep(1.16f, 1.30f, middle_y);
    return low * (1 - above_pelvis) + (middle * (1 - above_belly) + high * above_belly) * above_pelvis;
}

// Off the thigh of a sitter.
glm::vec3 off_lap(const Pose &pose, glm::vec3 p)
{
    glm::vec3 sum(0);
    for (const Side side : {Side::left, Side::right}) {
        const glm::vec3 hip = pose.joint(on(side, Bone::thigh)), knee = pose.joint(on(side, Bone::shin));
        const glm::quat thigh = pose.world(on(side, Bone::thigh));
        const glm::vec3 bone = knee - hip;
        const float raised = ease(-0.97f, -0.12f, bone.y / glm::length(bone));
        const float t = std::clamp(glm::dot(p - hip, bone) / glm::dot(bone, bone), 0.0f, 1.0f);
        const float near = smoothstep(0.30f, 0.17f, glm::length(p - hip - bone * t));
        const glm::vec3 off = thigh * glm::vec3(0, 0, 1) * (lap_m * raised * near);
        if (glm::length(off) > glm::length(sum)) sum = off;
    }
    return sum;
}

}  // namespace

void keep_clear(Pose &pose)
{
    for (const Side side : {Side::left, Side::right}) {
        const glm::vec3 shoulder = pose.joint(on(side, Bone::upper_arm));
        const glm::vec3 elbow = pose.joint(on(side, Bone::forearm)), wrist = pose.joint(on(side, Bone::hand));
        const glm::vec3 palm = wrist + pose.world(on(side, Bone::hand)) * mirrored(arm_direction() * 0.07f, side);
        const glm::vec3 moved = wrist + outwards(pose, palm, hands_fade_m) + off_lap(pose, palm);
        const glm::vec3 bent = elbow + outwards(pose, elbow, elbows_fade_m) * glm::vec3(elbows_aside, 1, 1);
        move_wrist(pose, side, moved, bent - (shoulder + moved) * 0.5f);
    }
}

}  // namespace claque::figures::decurion
