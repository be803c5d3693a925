#include "tests/bench/textbook.h"

namespace claque::bench
{

TextbookPose::TextbookPose(const model::Rig &rig) : rig_(rig), globals_(rig.node_count())
{
    for (const model::PaletteEntry &entry : rig.palette) binds_.push_back(math::mat4_of(entry.inverse_bind));
}

glm::quat TextbookPose::sample(uint32_t clip, uint32_t joint, float time_s) const
{
    const model::Channel &channel = rig_.channels[rig_.clips[clip].first_channel + joint];
    const float *times = rig_.times.data() + channel.first_time;
    uint32_t k = 0;
    while (k + 2 < channel.key_count && times[k + 1] <= time_s) ++k;
    const float f = (time_s - times[k]) / (times[k + 1] - times[k]);
    const float *v = rig_.values.data() + channel.first_value + 4 * k;
    return glm::slerp(glm::quat(v[3], v[0], v[1], v[2]), glm::quat(v[7], v[4], v[5], v[6]), f);
}

glm::quat TextbookPose::blended(Blend blend, uint32_t joint, float time_s, float other_s) const
{
    const glm::quat q = sample(0, joint, time_s);
    if (blend == Blend::one_clip) return q;
    if (blend == Blend::two_clips) return glm::slerp(q, sample(1, joint, other_s), blend_weight);
    if (blend == Blend::upper_body) return glm::slerp(q, sample(1, joint, other_s), blend_weight * mask_of(joint));
    const glm::quat none(1, 0, 0, 0);
    const glm::quat offset = glm::conjugate(sample(0, joint, 0.3f)) * sample(1, joint, 0.3f);
    const glm::quat before = glm::conjugate(sample(0, joint, 0.25f)) * sample(1, joint, 0.25f);
    return q * glm::slerp(none, offset, blend_weight) * glm::slerp(none, glm::conjugate(before), velocity_weight);
}

void TextbookPose::pose(Blend blend, float time_s, float other_s, glm::mat4 *palette)
{
    for (uint32_t i = 0; i < rig_.node_count(); ++i) {
        glm::mat4 local = glm::mat4_cast(blended(blend, i, time_s, other_s));
        local[3] = glm::vec4(rig_.rest[i].translation, 1);
        globals_[i] = rig_.parents[i] == model::none ? local : globals_[rig_.parents[i]] * local;
        palette[i] = globals_[i] * binds_[i];
    }
}

void textbook_skin(const model::Level &level, const glm::mat4 *palette, float *out)
{
    for (const model::InfluenceRun &run : level.runs)
        for (uint32_t v = run.first; v < run.first + run.count; ++v) {
            const float *p = level.positions.data() + 3 * v, *n = level.normals.data() + 3 * v;
            const uint32_t first = run.first_influence + (v - run.first) * run.influences;
            glm::vec4 position(0), normal(0);
            for (uint32_t i = first; i < first + run.influences; ++i) {
                const glm::mat4 &m = palette[level.joints[i]];
                const float w = level.weights[i];
                position += w * (m * glm::vec4(p[0], p[1], p[2], 1));
                normal += w * (m * glm::vec4(n[0], n[1], n[2], 0));
            }
            for (int k = 0; k < 3; ++k) out[3 * v + k] = position[k], out[3 * (level.source_count + v) + k] = normal[k];
        }
}

}  // namespace claque::bench
