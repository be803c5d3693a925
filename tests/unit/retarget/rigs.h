// Small rigs with motion for tests of retargeting, posed by independent code in double precision.
#pragma once

#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "lib/model/rig.h"

namespace claque::testing
{

struct Bone {
    const char *name;
    const char *parent;
    glm::vec3 offset;
};

// A biped of 13 joints with straight legs; arms down by this many degrees from horizontal.
inline std::vector<Bone> person(float size, float arms_down_deg)
{
    const float a = arms_down_deg * 0.01745329f, c = std::cos(a), s = std::sin(a);
    std::vector<Bone> out = {{"hips", "", {0, 1.0f, 0}},
                             {"spine", "hips", {0, 0.2f, 0}},
                             {"head", "spine", {0, 0.4f, 0}},
                             {"arm.l", "spine", {0.2f, 0.3f, 0}},
                             {"elbow.l", "arm.l", {0.3f * c, -0.3f * s, 0}},
                             {"hand.l", "elbow.l", {0.25f * c, -0.25f * s, 0}},
                             {"arm.r", "spine", {-0.2f, 0.3f, 0}},
                             {"elbow.r", "arm.r", {-0.3f * c, -0.3f * s, 0}},
                             {"hand.r", "elbow.r", {-0.25f * c, -0.25f * s, 0}},
                             {"leg.l", "hips", {0.1f, -0.1f, 0}},
                             {"knee.l", "leg.l", {0, -0.4f, 0}},
                             {"foot.l", "knee.l", {0, -0.45f, 0}},
                             {"leg.r", "hips", {-0.1f, -0.1f, 0}},
                             {"knee.r", "leg.r", {0, -0.4f, 0}},
                             {"foot.r", "knee.r", {0, -0.45f, 0}}};
    for (Bone &bone : out) bone.offset *= size;
    return out;
}

inline model::Rig rig_of(const std::vector<Bone> &bones)
{
    model::Rig rig;
    for (const Bone &bone : bones) {
        rig.parents.push_back(*bone.parent ? rig.find_node(bone.parent) : model::none);
        math::Trs rest;
        rest.translation = bone.offset;
        rig.rest.push_back(rest);
        rig.node_names.emplace_back(bone.name);
    }
    return rig;
}

inline glm::quat axis_turn(glm::vec3 axis, float radians)
{
    const float h = radians / 2;
    return glm::quat(std::cos(h), axis * std::sin(h));
}

// Every joint turns about an axis of its own, the first one walks as well; `keys` a tenth of a second apart.
inline void add_motion(model::Rig &rig, const char *name, uint32_t keys, float size, float turn_rad = 0.6f)
{
    model::Clip clip;
    clip.first_channel = static_cast<uint32_t>(rig.channels.size());
    clip.duration_s = static_cast<float>(keys - 1) * 0.1f;
    model::Channel channel;
    channel.first_time = static_cast<uint32_t>(rig.times.size());
    channel.key_count = keys;
    for (uint32_t k = 0; k < keys; ++k) rig.times.push_back(static_cast<float>(k) * 0.1f);
    channel.target = model::ChannelTarget::translation;
    channel.first_value = static_cast<uint32_t>(rig.values.size());
    for (uint32_t k = 0; k < keys; ++k)
        for (const float v : {0.3f * size, size * (1 + 0.05f * std::sin(float(k))), size * 0.1f * float(k)})
            rig.values.push_back(v);
    rig.channels.push_back(channel);
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        channel.node = i;
        channel.target = model::ChannelTarget::rotation;
        channel.component_count = 4;
        channel.first_value = static_cast<uint32_t>(rig.values.size());
        const float f = static_cast<float>(i);
        const glm::vec3 axis = glm::normalize(glm::vec3(std::sin(2 * f), std::cos(3 * f), std::sin(f + 1)));
        for (uint32_t k = 0; k < keys; ++k) {
            const glm::quat q = axis_turn(axis, turn_rad * std::sin(0.7f * static_cast<float>(k) + f));
            rig.values.insert(rig.values.end(), {q.x, q.y, q.z, q.w});
        }
        rig.channels.push_back(channel);
    }
    clip.channel_count = static_cast<uint32_t>(rig.channels.size()) - clip.first_channel;
    rig.clips.push_back(clip);
    rig.clip_names.emplace_back(name);
}

struct Posed {
    std::vector<glm::dquat> turns;
    std::vector<glm::dvec3> places;
    glm::dvec3 of(const model::Rig &rig, const char *name) const { return places[rig.find_node(name)]; }
};

// At a key of a clip whose channels all have the same keys; ignores scales.
inline Posed posed(const model::Rig &rig, uint32_t clip, uint32_t key)
{
    std::vector<glm::dquat> locals;
    std::vector<glm::dvec3> shifts;
    for (const math::Trs &rest : rig.rest) locals.emplace_back(rest.rotation), shifts.emplace_back(rest.translation);
    for (uint32_t c = 0; c < rig.clips[clip].channel_count; ++c) {
        const model::Channel &channel = rig.channels[rig.clips[clip].first_channel + c];
        const uint32_t k = std::min(key, channel.key_count - 1);
        const float *v = rig.values.data() + channel.first_value + k * channel.component_count;
        if (channel.target == model::ChannelTarget::rotation) locals[channel.node] = glm::dquat(v[3], v[0], v[1], v[2]);
        if (channel.target == model::ChannelTarget::translation) shifts[channel.node] = glm::dvec3(v[0], v[1], v[2]);
    }
    Posed out;
    for (uint32_t i = 0; i < rig.node_count(); ++i) {
        const uint32_t p = rig.parents[i];
        const bool root = p == model::none;
        out.turns.push_back(root ? locals[i] : out.turns[p] * locals[i]);
        out.places.push_back(root ? shifts[i] : out.places[p] + out.turns[p] * shifts[i]);
    }
    return out;
}

}  // namespace claque::testing
