#include "lib/figures/clips/clips.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "lib/math/trig.h"

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

bool moves(const std::vector<Pose> &poses, Bone bone)
{
    if (bone == Bone::pelvis) return true;
    for (const Pose &pose : poses)
        if (pose.shift(bone) != glm::vec3(0)) return true;
    return false;
}

void add_translation(model::Rig &rig, const std::vector<Pose> &poses, Bone bone, model::Channel channel)
{
    channel.node = static_cast<uint32_t>(bone);
    channel.target = model::ChannelTarget::translation;
    channel.component_count = 3;
    channel.first_value = static_cast<uint32_t>(rig.values.size());
    for (const Pose &pose : poses) {
        const glm::vec3 p = skeleton().offset(bone) + pose.shift(bone);
        rig.values.insert(rig.values.end(), {p.x, p.y, p.z});
    }
    rig.channels.push_back(channel);
}

void add_rotation(model::Rig &rig, const std::vector<Pose> &poses, Bone bone, model::Channel channel)
{
    channel.node = static_cast<uint32_t>(bone);
    channel.target = model::ChannelTarget::rotation;
    channel.component_count = 4;
    channel.first_value = static_cast<uint32_t>(rig.values.size());
    glm::quat before(1, 0, 0, 0);
    for (const Pose &pose : poses) {
        glm::quat q = pose.local(bone);
        if (glm::dot(before, q) < 0) q = -q;  // the shorter arc between keys
        rig.values.insert(rig.values.end(), {q.x, q.y, q.z, q.w});
        before = q;
    }
    rig.channels.push_back(channel);
}

}  // namespace

const std::vector<ClipMaker> &figure_clips()
{
    static const std::vector<ClipMaker> all = {{"stand", 180, stand_at},
                                               {"walk", 33, walk_at},
                                               {"applaud", 72, applaud_at},
                                               {"cheer", 60, cheer_at},
                                               {"sit", 210, sit_at},
                                               {"sit_lean", 270, sit_lean_at},
                                               {"sit_look", 240, sit_look_at},
                                               {"sit_talk", 255, sit_talk_at},
                                               {"sit_applaud", 165, sit_applaud_at},
                                               {"sit_cheer", 135, sit_cheer_at},
                                               {"sit_laugh", 150, sit_laugh_at},
                                               {"sit_wave", 120, sit_wave_at},
                                               {"rise", 60, rise_at, Ending::open},
                                               {"sit_down", 63, sit_down_at, Ending::open},
                                               {"stand_wave", 120, stand_wave_at},
                                               {"stand_laugh", 150, stand_laugh_at},
                                               {"stand_applaud", 150, stand_applaud_at},
                                               {"stand_cheer", 120, stand_cheer_at},
                                               {"jog", 22, jog_at},
                                               {"walk_slow", 36, walk_slow_at},
                                               {"turn", 30, turn_at},
                                               {"stand_look", 210, stand_look_at},
                                               {"stand_shift", 240, stand_shift_at}};
    return all;
}

float wave(float phase, int cycles, float at) { return math::sin(2 * pi * (static_cast<float>(cycles) * phase + at)); }

void add_clip(model::Rig &rig, const ClipMaker &maker, Fit fit)
{
    std::vector<Pose> poses;
    for (int k = 0; k < maker.frames; ++k)
        poses.push_back(maker.pose_at(static_cast<float>(k) / static_cast<float>(maker.frames)));
    // The last key of a loop equals the first to the bit.
    poses.push_back(maker.ending == Ending::closed ? poses.front() : maker.pose_at(1));

    add_clip(rig, maker.name, std::move(poses), fit);
}

void add_clip(model::Rig &rig, const char *name, std::vector<Pose> poses, Fit fit)
{
    if (fit)
        for (Pose &pose : poses) fit(pose);
    const int frames = static_cast<int>(poses.size()) - 1;
    model::Clip clip;
    clip.first_channel = static_cast<uint32_t>(rig.channels.size());
    clip.duration_s = static_cast<float>(frames) / keys_per_second;
    model::Channel channel;
    channel.first_time = static_cast<uint32_t>(rig.times.size());
    channel.key_count = static_cast<uint32_t>(poses.size());
    for (int k = 0; k <= frames; ++k) rig.times.push_back(static_cast<float>(k) / keys_per_second);

    for (int b = 0; b < bone_count; ++b)
        if (moves(poses, static_cast<Bone>(b))) add_translation(rig, poses, static_cast<Bone>(b), channel);
    for (int b = 0; b < bone_count; ++b)
        if (turns(poses, static_cast<Bone>(b))) add_rotation(rig, poses, static_cast<Bone>(b), channel);
    clip.channel_count = static_cast<uint32_t>(rig.channels.size()) - clip.first_channel;
    rig.clips.push_back(clip);
    rig.clip_names.emplace_back(name);
}

}  // namespace claque::figures
