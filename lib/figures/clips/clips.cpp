#include "lib/figures/clips/clips.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace claque::figures
{

namespace
{

bool turns(const std::vector<Pose> &poses, Bone bone)
{
    for (const Pose &pose : poses)
        if (std::fabs(pose.local(bone).w) < 1 - 1e-7f) return true;
    return false;
}

}  // namespace

float wave(float phase, int cycles, float at) { return std::sin(2 * pi * (static_cast<float>(cycles) * phase + at)); }

void add_clip(model::Rig &rig, const ClipMaker &maker)
{
    std::vector<Pose> poses;
    for (int k = 0; k < maker.frames; ++k)
        poses.push_back(maker.pose_at(static_cast<float>(k) / static_cast<float>(maker.frames)));
    poses.push_back(poses.front());  // the last key is the first one, to the bit

    model::Clip clip;
    clip.first_channel = static_cast<uint32_t>(rig.channels.size());
    clip.duration_s = static_cast<float>(maker.frames) / keys_per_second;
    model::Channel channel;
    channel.first_time = static_cast<uint32_t>(rig.times.size());
    channel.key_count = static_cast<uint32_t>(poses.size());
    for (int k = 0; k <= maker.frames; ++k) rig.times.push_back(static_cast<float>(k) / keys_per_second);

    channel.node = static_cast<uint32_t>(Bone::pelvis);
    channel.path = model::Path::translation;
    channel.component_count = 3;
    channel.first_value = static_cast<uint32_t>(rig.values.size());
    for (const Pose &pose : poses) {
        const glm::vec3 p = skeleton().offset(Bone::pelvis) + pose.pelvis_shift();
        rig.values.insert(rig.values.end(), {p.x, p.y, p.z});
    }
    rig.channels.push_back(channel);

    channel.path = model::Path::rotation;
    channel.component_count = 4;
    for (int b = 0; b < bone_count; ++b) {
        const Bone bone = static_cast<Bone>(b);
        if (!turns(poses, bone)) continue;
        channel.node = static_cast<uint32_t>(b);
        channel.first_value = static_cast<uint32_t>(rig.values.size());
        glm::quat before(1, 0, 0, 0);
        for (const Pose &pose : poses) {
            glm::quat q = pose.local(bone);
            if (glm::dot(before, q) < 0) q = -q;  // the short way from key to key
            rig.values.insert(rig.values.end(), {q.x, q.y, q.z, q.w});
            before = q;
        }
        rig.channels.push_back(channel);
    }
    clip.channel_count = static_cast<uint32_t>(rig.channels.size()) - clip.first_channel;
    rig.clips.push_back(clip);
    rig.clip_names.emplace_back(maker.name);
}

}  // namespace claque::figures
