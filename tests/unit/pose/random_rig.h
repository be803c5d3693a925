// A random rig of many nodes, scales and morph targets, the same for the same seed. Its clips are smooth except for one
// that steps.
#pragma once

#include <cmath>
#include <random>

#include "lib/math/slerp.h"
#include "lib/model/rig.h"

namespace claque::test
{

enum : uint32_t { clip_linear = 0, clip_cubic = 1, clip_steps = 2, clip_still = 3 };

class RigMaker
{
public:
    explicit RigMaker(uint32_t seed, uint32_t nodes = 21) : random_(seed), nodes_(nodes) {}

    model::Rig make()
    {
        for (uint32_t i = 0; i < nodes_; ++i) {
            rig_.parents.push_back(i == 0 ? model::none : (i - 1) / 2);
            math::Trs trs;
            trs.translation = glm::vec3(real(-0.3f, 0.3f), real(-0.3f, 0.3f), real(-0.3f, 0.3f));
            trs.rotation = turn(1);
            rig_.rest.push_back(trs);
            rig_.node_names.emplace_back("node");
            rig_.palette.push_back({i, math::affine_of(trs)});
        }
        rig_.morph_sets.push_back({2, 0, 6});
        rig_.rest_weights.assign(6, 0.25f);
        clip("linear", model::Interpolation::linear, 31);
        clip("cubic", model::Interpolation::cubic_spline, 7);
        clip("steps", model::Interpolation::step, 9);
        clip("still", model::Interpolation::linear, 1);
        model::check(rig_);
        return std::move(rig_);
    }

private:
    float real(float a, float b) { return a + (b - a) * float(random_() % 100001) / 100000; }
    glm::quat turn(float most) { return math::unit_quat(1, real(-most, most), real(-most, most), real(-most, most)); }

    // Smooth between keys: each number follows a slow wave.
    void channel(uint32_t node, model::ChannelTarget path, uint32_t components, model::Interpolation how,
                 uint32_t first_time, uint32_t keys)
    {
        model::Channel c;
        c.node = node, c.target = path, c.interpolation = how, c.component_count = uint16_t(components);
        c.first_time = first_time, c.key_count = keys;
        c.first_value = uint32_t(rig_.values.size());
        const float phase = real(0, 6), size = path == model::ChannelTarget::translation ? 0.1f : 0.2f;
        const bool cubic = how == model::Interpolation::cubic_spline;
        for (uint32_t k = 0; k < keys; ++k) {
            const float t = rig_.times[first_time + k];
            for (int part = cubic ? 0 : 1; part < (cubic ? 3 : 2); ++part)
                for (uint32_t i = 0; i < components; ++i) {
                    const float at = phase + 2.5f * t + float(i);
                    const float middle = path == model::ChannelTarget::rotation ? (i == 3 ? 1.0f : 0.3f)
                                         : path == model::ChannelTarget::scale  ? 1.0f
                                                                                : 0.1f;
                    rig_.values.push_back(part == 1 ? middle + size * std::sin(at) : 2.5f * size * std::cos(at));
                }
        }
        if (path == model::ChannelTarget::rotation && !cubic)
            for (uint32_t k = 0; k < keys; ++k) {
                float *v = rig_.values.data() + c.first_value + 4 * k;
                const glm::quat q = math::unit_quat(v[3], v[0], v[1], v[2]);
                v[0] = q.x, v[1] = q.y, v[2] = q.z, v[3] = q.w;
            }
        rig_.channels.push_back(c);
    }

    void clip(const char *name, model::Interpolation how, uint32_t keys)
    {
        const uint32_t first_time = uint32_t(rig_.times.size());
        for (uint32_t k = 0; k < keys; ++k) rig_.times.push_back(0.25f + float(k) / (keys == 31 ? 30.0f : 5.0f));
        model::Clip clip;
        clip.first_channel = uint32_t(rig_.channels.size());
        for (uint32_t i = 1; i + 2 < nodes_; ++i) channel(i, model::ChannelTarget::rotation, 4, how, first_time, keys);
        channel(0, model::ChannelTarget::translation, 3, how, first_time, keys);
        channel(3, model::ChannelTarget::translation, 3, how, first_time, keys);
        channel(4, model::ChannelTarget::scale, 3, how, first_time, keys);
        channel(0, model::ChannelTarget::morph_weights, 6, how, first_time, keys);
        clip.channel_count = uint32_t(rig_.channels.size()) - clip.first_channel;
        clip.start_s = rig_.times[first_time];
        clip.duration_s = rig_.times.back() - clip.start_s;
        rig_.clips.push_back(clip);
        rig_.clip_names.emplace_back(name);
    }

    std::mt19937 random_;
    const uint32_t nodes_;
    model::Rig rig_;
};

// Three layers of every kind on top of each other, with a mask.
inline std::vector<float> upper_half(const model::Rig &rig)
{
    std::vector<float> mask(rig.node_count());
    for (uint32_t n = 0; n < mask.size(); ++n) mask[n] = n % 2 ? 1.0f : float(n) / float(mask.size());
    return mask;
}

}  // namespace claque::test
