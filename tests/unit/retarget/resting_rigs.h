// Rigs of clips that rest as files of other programs do, made from what their joints do in model space.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/geometric.hpp>

#include "rigs.h"

namespace claque::testing
{

inline model::Rig rig_with_motion(const std::vector<Bone> &bones, float turn_rad = 0.6f)
{
    model::Rig rig = rig_of(bones);
    add_motion(rig, "dance", 12, 1, turn_rad);
    return rig;
}

// As FBX "without skin": every joint rests as in the first key of the clip.
inline model::Rig in_first_pose(model::Rig rig)
{
    for (const model::Channel &channel : rig.channels) {
        const float *v = rig.values.data() + channel.first_value;
        math::Trs &rest = rig.rest[channel.node];
        if (channel.target == model::ChannelTarget::rotation) rest.rotation = glm::quat(v[3], v[0], v[1], v[2]);
        if (channel.target == model::ChannelTarget::translation) rest.translation = glm::vec3(v[0], v[1], v[2]);
    }
    return rig;
}

inline glm::dquat turned(glm::dvec3 axis, double degrees)
{
    const double half = degrees * 0.008726646259971648;
    return glm::dquat(std::cos(half), axis * std::sin(half));
}

// What the joints of person(1, 0) do in a clip of keys a tenth of a second apart: how each is turned in model space
// since its T-pose, and where the hips are.
struct Acted {
    uint32_t keys = 12;
    std::function<glm::dquat(const std::string &joint, uint32_t key)> turn;
    std::function<glm::dvec3(uint32_t key)> hips;
};

inline double leg_swing_deg(uint32_t key) { return 20 * std::sin(key * 0.5235987755982988); }

// Arms hang 75 degrees below the horizontal, the left leg swings ahead first, the hips go 1 m/s ahead.
inline Acted walker(uint32_t keys)
{
    Acted out;
    out.keys = keys;
    out.turn = [](const std::string &joint, uint32_t key) {
        const double left = joint.back() == 'l' ? 1 : -1;
        if (joint.find(".") == std::string::npos) return glm::dquat(1, 0, 0, 0);
        const std::string part = joint.substr(0, joint.size() - 2);
        if (part == "arm" || part == "elbow" || part == "hand") return turned({0, 0, 1}, -75 * left);
        return turned({1, 0, 0}, -leg_swing_deg(key) * left);
    };
    out.hips = [](uint32_t key) { return glm::dvec3(0, 1, 0.1 * key); };
    return out;
}

// A rig whose joints' frames are turned by `frame` from model space at the T-pose, with these motions in one clip
// "walk", all turned about y by `away_deg`. Rotations at rest are those of `rest`, of model space.
inline model::Rig acted_rig(const std::vector<Bone> &bones, const Acted &acted, double away_deg,
                            const std::function<glm::dquat(uint32_t)> &frame, bool rests_unturned)
{
    model::Rig rig = rig_of(bones);
    const glm::dquat away = turned({0, 1, 0}, away_deg);
    const auto global = [&](uint32_t i, uint32_t key) { return away * acted.turn(bones[i].name, key) * frame(i); };
    const auto put = [](glm::quat &to, const glm::dquat &q) {
        to = glm::quat(float(q.w), float(q.x), float(q.y), float(q.z));
    };
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const uint32_t parent = rig.parents[i];
        const glm::dquat above = parent == model::none ? glm::dquat(1, 0, 0, 0) : frame(parent);
        rig.rest[i].translation = glm::vec3(glm::conjugate(above) * glm::dvec3(bones[i].offset));
        if (!rests_unturned) put(rig.rest[i].rotation, glm::conjugate(above) * frame(i));
    }
    model::Clip clip;
    clip.duration_s = static_cast<float>(acted.keys - 1) * 0.1f;
    model::Channel channel;
    channel.key_count = acted.keys;
    for (uint32_t k = 0; k < acted.keys; ++k) rig.times.push_back(static_cast<float>(k) * 0.1f);
    for (uint32_t k = 0; k < acted.keys; ++k) {
        const glm::dvec3 hips = away * acted.hips(k);
        for (int axis = 0; axis < 3; ++axis) rig.values.push_back(static_cast<float>(hips[axis]));
    }
    rig.channels.push_back(channel);
    channel.target = model::ChannelTarget::rotation;
    channel.component_count = 4;
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        channel.node = i;
        channel.first_value = static_cast<uint32_t>(rig.values.size());
        for (uint32_t k = 0; k < acted.keys; ++k) {
            glm::dquat q = global(i, k);
            if (rig.parents[i] != model::none) q = glm::conjugate(global(rig.parents[i], k)) * q;
            for (const double v : {q.x, q.y, q.z, q.w}) rig.values.push_back(static_cast<float>(v));
        }
        rig.channels.push_back(channel);
    }
    clip.channel_count = static_cast<uint32_t>(rig.channels.size());
    rig.clips.push_back(clip);
    rig.clip_names.emplace_back("walk");
    return rig;
}

// As LAFAN1 and Bandai-Namco write BVH: the x axis of each joint points to its first child, rotations of zero are no
// pose.
inline model::Rig rig_along_x(const Acted &acted, double away_deg, const std::vector<Bone> &bones = person(1, 0))
{
    std::vector<glm::dquat> frames;
    for (const Bone &bone : bones) {
        const auto child =
            std::find_if(bones.begin(), bones.end(), [&](const Bone &b) { return std::string(b.parent) == bone.name; });
        if (child == bones.end()) {  // as its parent
            const auto parent = std::find_if(bones.begin(), bones.end(),
                                             [&](const Bone &b) { return b.name == std::string(bone.parent); });
            frames.push_back(frames[static_cast<size_t>(parent - bones.begin())]);
            continue;
        }
        const glm::dvec3 way = glm::normalize(glm::dvec3(child->offset));
        frames.push_back(way.x < -0.5 ? turned({0, 0, 1}, 180)
                                      : turned({0, 0, 1}, std::atan2(way.y, way.x) * 57.29577951308232));
    }
    return acted_rig(
        bones, acted, away_deg, [&](uint32_t i) { return frames[i]; }, true);
}

}  // namespace claque::testing
