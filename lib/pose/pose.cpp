#include "lib/pose/pose.h"

#include <algorithm>
#include <cmath>

#include "lib/pose/exact.h"

namespace claque::pose
{

using math::Columns;
using math::F4;

namespace
{

constexpr size_t exact_node_floats = sizeof(math::Trs) / sizeof(float);

// Written out, not looped over, so that columns stay in registers at any optimisation.
F4 transform(const Columns &a, float x, float y, float z)
{
    return a.c[0] * math::splat(x) + a.c[1] * math::splat(y) + a.c[2] * math::splat(z);
}

// The same steps as math::affine_of(Trs), in plain numbers.
struct Axes {
    float xx, xy, xz, yx, yy, yz, zx, zy, zz;
    explicit Axes(const math::Trs &trs)
    {
        const float x = trs.rotation.x, y = trs.rotation.y, z = trs.rotation.z, w = trs.rotation.w;
        const glm::vec3 &s = trs.scale;
        xx = (1 - 2 * (y * y + z * z)) * s.x, xy = 2 * (x * y + w * z) * s.x, xz = 2 * (x * z - w * y) * s.x;
        yx = 2 * (x * y - w * z) * s.y, yy = (1 - 2 * (x * x + z * z)) * s.y, yz = 2 * (y * z + w * x) * s.y;
        zx = 2 * (x * z + w * y) * s.z, zy = 2 * (y * z - w * x) * s.z, zz = (1 - 2 * (x * x + y * y)) * s.z;
    }
};

Columns columns_of(const math::Trs &trs)
{
    const Axes a(trs);
    const glm::vec3 &t = trs.translation;
    return {{F4{a.xx, a.xy, a.xz, 0}, F4{a.yx, a.yy, a.yz, 0}, F4{a.zx, a.zy, a.zz, 0}, F4{t.x, t.y, t.z, 0}}};
}

// parent * columns_of(trs), whose columns are not put together for it.
Columns mul(const Columns &parent, const math::Trs &trs)
{
    const Axes a(trs);
    const glm::vec3 &t = trs.translation;
    return {{transform(parent, a.xx, a.xy, a.xz), transform(parent, a.yx, a.yy, a.yz),
             transform(parent, a.zx, a.zy, a.zz), transform(parent, t.x, t.y, t.z) + parent.c[3]}};
}

void mul_to_affine(const Columns &a, const float *b, float *out)
{
    // Each store's fourth lane is overwritten by the next.
    math::store4(out, transform(a, b[0], b[1], b[2]));
    math::store4(out + 3, transform(a, b[3], b[4], b[5]));
    math::store4(out + 6, transform(a, b[6], b[7], b[8]));
    math::store3(out + 9, transform(a, b[9], b[10], b[11]) + a.c[3]);
}

const uint8_t *active_of(const PoseJob &job)
{
    return job.level && !job.level->active.empty() ? job.level->active.data() : nullptr;
}

// Scratch holds as many local poses as layers need.
LocalPose spare_pose(const PoseJob &job, uint32_t index)
{
    const size_t node_floats = exact_node_floats * job.rig->node_count();
    float *first = job.scratch.data + index * (node_floats + job.rig->rest_weights.size());
    return {reinterpret_cast<math::Trs *>(first), first + node_floats};
}

void sample(const PoseJob &job)
{
    const LocalPose out = {job.locals.data, job.weights.data};
    if (job.layers.empty()) sample_exact(*job.rig, job.clip, job.time_s, active_of(job), out);
    else sample_layers(*job.rig, job.layers, active_of(job), out, spare_pose(job, 0), spare_pose(job, 1));
}

// S0 3: what the degrees of freedom add to the nodes' own transforms. One at zero adds nothing, to the bit.
void apply_dofs(const PoseJob &job)
{
    const model::Rig &rig = *job.rig;
    for (size_t i = 0; i < rig.dofs.size(); ++i) {
        const model::Dof &dof = rig.dofs[i];
        const float value = job.dofs ? job.dofs[i] : dof.rest;
        if (value == 0) continue;
        if (dof.kind == model::DofKind::morph) {
            job.weights[rig.morph_sets[dof.node].first_weight + dof.target] += value;
            continue;
        }
        math::Trs &local = job.locals[dof.node];
        if (dof.kind == model::DofKind::translation) {
            local.translation = local.translation + local.rotation * (dof.axis * value);
        } else {
            const float half = value * 0.5f, s = std::sin(half);
            local.rotation = local.rotation * glm::quat(std::cos(half), dof.axis.x * s, dof.axis.y * s, dof.axis.z * s);
        }
    }
}

}  // namespace

size_t scratch_floats(const model::Rig &rig)
{
    return 2 * (exact_node_floats * rig.node_count() + rig.rest_weights.size());
}

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
    if (!layers.empty() && scratch.count < scratch_floats(*rig))
        return Status::bad(CLQ_ARGUMENT, "a pose job of %u layers has %u of %zu numbers of scratch", layers.count,
                           scratch.count, scratch_floats(*rig));
    for (const Layer &layer : layers) {
        const bool clips_exist = (layer.clip == model::none || layer.clip < rig->clips.size()) &&
                                 (layer.reference_clip == model::none || layer.reference_clip < rig->clips.size());
        if (!clips_exist)
            return Status::bad(CLQ_ARGUMENT, "a layer of a pose job asks for clip %u, against %u, of %zu", layer.clip,
                               layer.reference_clip, rig->clips.size());
        if (!std::isfinite(layer.time_s) || !std::isfinite(layer.reference_time_s) || !std::isfinite(layer.weight))
            return Status::bad(CLQ_ARGUMENT, "a layer of a pose job has a time or weight that is not finite");
    }
    return Status::good();
}

void PoseJob::run() const
{
    sample(*this);
    if (!rig->dofs.empty()) apply_dofs(*this);
    const auto place = [this](uint32_t node) {
        const uint32_t parent = rig->parents[node];
        globals[node] = parent == model::none ? columns_of(locals[node]) : mul(globals[parent], locals[node]);
    };
    const auto fill = [this](uint32_t entry) {
        mul_to_affine(globals[rig->palette[entry].node], rig->palette[entry].inverse_bind.c, palette.data[entry].c);
    };
    if (level && !level->active.empty()) {
        for (const uint32_t node : level->nodes) place(node);
        for (const uint32_t entry : level->entries) fill(entry);
        return;
    }
    for (uint32_t i = 0; i < rig->node_count(); ++i) place(i);
    for (uint32_t i = 0; i < rig->palette.size(); ++i) fill(i);
}

uint32_t PoseJob::run_locals(base::Span<math::Affine> out) const
{
    sample(*this);
    if (!rig->dofs.empty()) apply_dofs(*this);
    uint32_t built = 0;
    const auto build = [&](uint32_t node) {
        const math::Trs &now = locals[node], &rest = rig->rest[node];
        built += now.translation != rest.translation || now.rotation != rest.rotation || now.scale != rest.scale;
        out[node] = math::affine_of(now);
    };
    if (level && !level->active.empty())
        for (const uint32_t node : level->nodes) build(node);
    else
        for (uint32_t i = 0; i < rig->node_count(); ++i) build(i);
    return built;
}

void place_locals(const model::Rig &rig, const model::Level &level, const math::Affine *locals, Columns *globals,
                  math::Affine *palette)
{
    const auto place = [&](uint32_t node) {
        const float *c = locals[node].c;
        const Columns own = {
            {F4{c[0], c[1], c[2], 0}, F4{c[3], c[4], c[5], 0}, F4{c[6], c[7], c[8], 0}, F4{c[9], c[10], c[11], 0}}};
        const uint32_t parent = rig.parents[node];
        if (parent == model::none) {
            globals[node] = own;
            return;
        }
        const Columns &p = globals[parent];
        for (int k = 0; k < 4; ++k) globals[node].c[k] = transform(p, c[3 * k], c[3 * k + 1], c[3 * k + 2]);
        globals[node].c[3] += p.c[3];
    };
    const auto fill = [&](uint32_t entry) {
        mul_to_affine(globals[rig.palette[entry].node], rig.palette[entry].inverse_bind.c, palette[entry].c);
    };
    if (level.active.empty()) {
        for (uint32_t i = 0; i < rig.node_count(); ++i) place(i);
        for (uint32_t i = 0; i < rig.palette.size(); ++i) fill(i);
        return;
    }
    for (const uint32_t node : level.nodes) place(node);
    for (const uint32_t entry : level.entries) fill(entry);
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
