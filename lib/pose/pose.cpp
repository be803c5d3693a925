#include "lib/pose/pose.h"

#include <algorithm>
#include <cmath>

#include "lib/pose/channel.h"

namespace claque::pose
{

using math::Columns;
using math::F4;

namespace
{

F4 transform(const Columns &a, float x, float y, float z) { return a.c[0] * x + a.c[1] * y + a.c[2] * z; }

// The same steps as math::affine_of(Trs), kept in registers.
Columns columns_of(const math::Trs &trs)
{
    const glm::mat3 r = glm::mat3_cast(trs.rotation);
    Columns out;
    for (int k = 0; k < 3; ++k) out.c[k] = F4{r[k].x, r[k].y, r[k].z, 0} * trs.scale[k];
    out.c[3] = F4{trs.translation.x, trs.translation.y, trs.translation.z, 0};
    return out;
}

Columns mul(const Columns &a, const Columns &b)
{
    Columns out;
    for (int k = 0; k < 4; ++k) out.c[k] = transform(a, b.c[k][0], b.c[k][1], b.c[k][2]);
    out.c[3] += a.c[3];
    return out;
}

void mul_to_affine(const Columns &a, const float *b, float *out)
{
    // Each store's fourth lane is overwritten by the next.
    for (int k = 0; k < 3; ++k) math::store4(out + 3 * k, transform(a, b[3 * k], b[3 * k + 1], b[3 * k + 2]));
    math::store3(out + 9, transform(a, b[9], b[10], b[11]) + a.c[3]);
}

void apply(const PoseJob &job, const model::Channel &channel, KeyPlace place)
{
    const model::Rig &rig = *job.rig;
    switch (channel.path) {
        case model::Path::translation:
            sample_numbers(rig, channel, place, &job.locals[channel.node].translation.x);
            break;
        case model::Path::rotation:
            job.locals[channel.node].rotation = sample_rotation(rig, channel, place);
            break;
        case model::Path::scale:
            sample_numbers(rig, channel, place, &job.locals[channel.node].scale.x);
            break;
        case model::Path::morph_weights:
            sample_numbers(rig, channel, place, job.weights.data + rig.morph_sets[channel.node].first_weight);
            break;
    }
}

void sample(const PoseJob &job)
{
    const model::Rig &rig = *job.rig;
    std::copy(rig.rest.begin(), rig.rest.end(), job.locals.data);
    std::copy(rig.rest_weights.begin(), rig.rest_weights.end(), job.weights.data);
    if (job.clip == model::none) return;
    const model::Clip &clip = rig.clips[job.clip];
    // Channels often share their key times: what was found for the last serves the next.
    const model::Channel *last = nullptr;
    KeyPlace place;
    for (uint32_t i = 0; i < clip.channel_count; ++i) {
        const model::Channel &channel = rig.channels[clip.first_channel + i];
        if (!last || channel.first_time != last->first_time || channel.key_count != last->key_count)
            place = find_key(rig.times.data() + channel.first_time, channel.key_count, job.time_s);
        apply(job, channel, place);
        last = &channel;
    }
}

}  // namespace

base::Status PoseJob::check() const
{
    using base::Status;
    if (!rig) return Status::bad(CLQ_ARGUMENT, "a pose job has no rig");
    if (clip != model::none && clip >= rig->clips.size())
        return Status::bad(CLQ_ARGUMENT, "a pose job asks for clip %u of %zu", clip, rig->clips.size());
    if (!std::isfinite(time_s)) return Status::bad(CLQ_ARGUMENT, "a pose job's time is not finite");
    if (locals.count < rig->node_count() || globals.count < rig->node_count())
        return Status::bad(CLQ_ARGUMENT, "a pose job has room for %u and %u of %u nodes", locals.count, globals.count,
                           rig->node_count());
    if (palette.count < rig->palette.size() || weights.count < rig->rest_weights.size())
        return Status::bad(CLQ_ARGUMENT, "a pose job has room for %u of %zu matrices and %u of %zu weights",
                           palette.count, rig->palette.size(), weights.count, rig->rest_weights.size());
    return Status::good();
}

void PoseJob::run() const
{
    sample(*this);
    for (uint32_t i = 0; i < rig->node_count(); ++i) {
        const Columns local = columns_of(locals[i]);
        const uint32_t parent = rig->parents[i];
        globals[i] = parent == model::none ? local : mul(globals[parent], local);
    }
    for (size_t i = 0; i < rig->palette.size(); ++i)
        mul_to_affine(globals[rig->palette[i].node], rig->palette[i].inverse_bind.c, palette.data[i].c);
}

Workspace::Workspace(const model::Rig &rig)
    : rig_(&rig),
      locals_(rig.node_count()),
      globals_(rig.node_count()),
      palette_(rig.palette.size() + 1),
      weights_(rig.rest_weights.size())
{
}

base::Span<const math::Affine> Workspace::pose(uint32_t clip, double time_s)
{
    PoseJob job;
    job.rig = rig_;
    job.clip = clip;
    job.time_s = time_s;
    job.locals = base::Span<math::Trs>(locals_);
    job.globals = base::Span<Columns>(globals_);
    job.palette = base::Span<math::Affine>(palette_);
    job.weights = base::Span<float>(weights_);
    job.run();
    return {palette_.data(), static_cast<uint32_t>(rig_->palette.size())};
}

math::Affine Workspace::global(uint32_t node) const
{
    math::Affine out;
    for (int k = 0; k < 4; ++k) math::store3(out.c + 3 * k, globals_[node].c[k]);
    return out;
}

}  // namespace claque::pose
