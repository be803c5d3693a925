#include "tests/bench/body.h"

#include <cmath>
#include <random>

#include "lib/math/slerp.h"
#include "meshsplit/motion.h"

namespace claque::bench
{

namespace
{

void add_bones(model::Rig &rig, std::mt19937 &random)
{
    std::uniform_real_distribution<float> real(-0.2f, 0.2f);
    for (uint32_t i = 0; i < joint_count; ++i) {
        rig.parents.push_back(i == 0 ? model::none : (i - 1) / 2);
        math::Trs trs;
        trs.translation = glm::vec3(real(random), real(random), real(random));
        rig.rest.push_back(trs);
        rig.node_names.emplace_back("");
        rig.palette.push_back({i, math::affine_of(trs)});
    }
}

void add_clip(model::Rig &rig, double length_s, std::mt19937 &random)
{
    std::uniform_real_distribution<float> real(-1, 1);
    const uint32_t keys = uint32_t(std::lround(length_s * 30)) + 1, first_time = uint32_t(rig.times.size());
    for (uint32_t k = 0; k < keys; ++k) rig.times.push_back(float(k) / 30);
    model::Clip clip;
    clip.first_channel = uint32_t(rig.channels.size()), clip.channel_count = joint_count;
    clip.duration_s = rig.times.back();
    for (uint32_t i = 0; i < joint_count; ++i) {
        model::Channel channel;
        channel.node = i, channel.target = model::ChannelTarget::rotation, channel.component_count = 4;
        channel.first_time = first_time, channel.key_count = keys;
        channel.first_value = uint32_t(rig.values.size());
        rig.channels.push_back(channel);
        const double phase = real(random);
        for (uint32_t k = 0; k < keys; ++k) {
            const glm::quat q = math::unit_quat(1, 0.4 * std::sin(k * 0.19 + phase), 0.3 * std::cos(k * 0.19), 0.1);
            rig.values.insert(rig.values.end(), {q.x, q.y, q.z, q.w});
        }
    }
    rig.clips.push_back(clip);
    rig.clip_names.emplace_back("walk");
}

}  // namespace

model::Level make_level(uint32_t influences)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<float> real(-1, 1), positive(0.1f, 1);
    std::vector<uint32_t> counts(joint_count), filled, loose;
    for (uint32_t v = 0; v < vertex_count; ++v) ++counts[random() % joint_count];
    for (uint32_t bone = 0; bone < joint_count; ++bone)
        for (uint32_t i = 0; i < counts[bone]; ++i)
            (i < model::worth_blocks(counts[bone]) ? filled : loose).push_back(bone);
    filled.insert(filled.end(), loose.begin(), loose.end());
    model::Level level(std::pmr::get_default_resource());
    level.source_count = level.vertex_count = vertex_count;
    level.runs.push_back({0, vertex_count, influences, 0});
    for (const uint32_t bone : filled) {
        for (int k = 0; k < 3; ++k) level.positions.push_back(real(random)), level.normals.push_back(real(random));
        for (uint32_t i = 0; i < influences; ++i) {
            level.joints.push_back(uint16_t((bone + i) % joint_count));
            level.weights.push_back(positive(random));
        }
    }
    model::plan_skinning(level);
    return level;
}

std::unique_ptr<model::Template> make_body(uint32_t influences)
{
    auto out = std::make_unique<model::Template>(std::pmr::get_default_resource());
    std::mt19937 random(1);
    add_bones(out->rig, random);
    for (const double length_s : clip_lengths_s) add_clip(out->rig, length_s, random);
    model::check(out->rig);
    out->levels.push_back(make_level(influences));
    out->sklsroot.radius = 2;
    // A tolerance so small that every clip keeps the rate of its keys.
    meshsplit::inflate(meshsplit::make_motion({0.001f, 0.01f}, *out), *out);
    return out;
}

}  // namespace claque::bench
