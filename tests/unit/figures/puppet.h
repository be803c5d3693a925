// Built-in characters posed by a few lines that share only the data with the library's own evaluation.
#pragma once

#include <cmath>
#include <string>

#include "lib/figures/figure.h"

namespace puppet
{

using claque::model::Model;
using glm::quat;
using glm::vec3;

inline const Model &citizen()
{
    static const Model made = claque::figures::citizen();
    return made;
}

struct Posed {
    std::vector<quat> local, world;
    std::vector<vec3> joints;
    std::vector<vec3> vertices;
};

inline uint32_t clip(const std::string &name) { return citizen().rig.find_clip(name); }
inline uint32_t node(const std::string &name) { return citizen().rig.find_node(name); }

inline void read(const claque::model::Rig &rig, const claque::model::Channel &c, uint32_t key, float *out)
{
    for (uint32_t k = 0; k < c.component_count; ++k) out[k] = rig.values[c.first_value + key * c.component_count + k];
}

inline Posed pose(const Model &figure, uint32_t clip_index, float time_s)
{
    const auto &rig = figure.rig;
    const size_t n = rig.parents.size();
    Posed out;
    std::vector<vec3> shift(n);
    for (size_t i = 0; i < n; ++i) {
        out.local.push_back(rig.rest[i].rotation);
        shift[i] = rig.rest[i].translation;
    }
    if (clip_index < rig.clips.size())
        for (uint32_t i = 0; i < rig.clips[clip_index].channel_count; ++i) {
            const auto &c = rig.channels[rig.clips[clip_index].first_channel + i];
            uint32_t key = 0;
            while (key + 2 < c.key_count && rig.times[c.first_time + key + 1] <= time_s) ++key;
            const float from = rig.times[c.first_time + key], to = rig.times[c.first_time + key + 1];
            const float t = std::fmin(1.0f, std::fmax(0.0f, (time_s - from) / (to - from)));
            float a[4], b[4];
            read(rig, c, key, a);
            read(rig, c, key + 1, b);
            if (c.target == claque::model::ChannelTarget::translation)
                shift[c.node] = vec3(a[0], a[1], a[2]) * (1 - t) + vec3(b[0], b[1], b[2]) * t;
            else out.local[c.node] = glm::slerp(quat(a[3], a[0], a[1], a[2]), quat(b[3], b[0], b[1], b[2]), t);
        }
    for (size_t i = 0; i < n; ++i) {
        const uint32_t p = rig.parents[i];
        const bool root = p == claque::model::none;
        out.world.push_back(root ? out.local[i] : out.world[p] * out.local[i]);
        out.joints.push_back(root ? shift[i] : out.joints[p] + out.world[p] * shift[i]);
    }
    const auto &part = figure.parts[0];
    for (size_t v = 0; v < part.positions.size(); ++v) {
        vec3 sum(0);
        for (size_t k = 0; k < 4; ++k) {
            const auto &entry = rig.palette[part.joints[4 * v + k]];
            const vec3 in_bone = claque::math::transform_point(entry.inverse_bind, part.positions[v]);
            sum += part.weights[4 * v + k] * (out.joints[entry.node] + out.world[entry.node] * in_bone);
        }
        out.vertices.push_back(sum);
    }
    return out;
}

inline Posed pose(uint32_t clip_index, float time_s) { return pose(citizen(), clip_index, time_s); }

// The joint with the largest weight of a vertex.
inline uint32_t owner(const Model &figure, size_t vertex)
{
    return figure.rig.palette[figure.parts[0].joints[4 * vertex]].node;
}
inline uint32_t owner(size_t vertex) { return owner(citizen(), vertex); }

constexpr float frame_s = 1.0f / 30;
inline int frames(const Model &figure, uint32_t c) { return int(figure.rig.clips[c].duration_s * 30 + 0.5f); }
inline int frames(uint32_t c) { return frames(citizen(), c); }

inline float degrees(float radians) { return radians * 57.29578f; }
inline float angle(quat q) { return degrees(2 * std::acos(std::fmin(1.0f, std::fabs(q.w)))); }

constexpr const char *clip_names[] = {
    "stand",         "walk",        "applaud",   "cheer",     "sit",  "sit_lean",   "sit_look",   "sit_talk",
    "sit_applaud",   "sit_cheer",   "sit_laugh", "sit_wave",  "rise", "sit_down",   "stand_wave", "stand_laugh",
    "stand_applaud", "stand_cheer", "jog",       "walk_slow", "turn", "stand_look", "stand_shift"};
// Standing, in place.
constexpr const char *standing_clips[] = {"stand",         "applaud",     "cheer",      "stand_wave", "stand_laugh",
                                          "stand_applaud", "stand_cheer", "stand_look", "stand_shift"};
constexpr const char *seated_clips[] = {"sit",         "sit_lean",  "sit_look",  "sit_talk",
                                        "sit_applaud", "sit_cheer", "sit_laugh", "sit_wave"};
// Sitting down or standing up: the two clips that do not loop.
constexpr const char *ways[] = {"rise", "sit_down"};

}  // namespace puppet
