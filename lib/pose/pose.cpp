#include "lib/pose/pose.h"

#include <algorithm>
#include <cmath>

#include "lib/pose/dofs.h"
#include "lib/pose/exact.h"
#include "lib/pose/sampled.h"

namespace claque::pose
{

using math::Columns;
using math::F4;

namespace
{

template <class A>
uint32_t count32(const A &array)
{
    return static_cast<uint32_t>(array.size());
}

constexpr size_t exact_node_floats = sizeof(math::Trs) / sizeof(float);

// The same steps as math::affine_of(Trs), in plain floats.
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

const uint8_t *active_of(const PoseJob &job)
{
    return job.level && !job.level->active.empty() ? job.level->active.data() : nullptr;
}

// The scratch memory holds as many local poses as layers need.
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

// Local transforms that degrees of freedom modify.
struct TrsPose {
    math::Trs *nodes;

    void turn(uint32_t node, const glm::quat &by) { nodes[node].rotation = nodes[node].rotation * by; }
    void shift(uint32_t node, const glm::vec3 &along)
    {
        nodes[node].translation = nodes[node].translation + nodes[node].rotation * along;
    }
};

// Applies the clip or layers and the degrees of freedom to the sampler's rows, and writes morph weights.
void take(const PoseJob &job, Sampler &sampler)
{
    if (active_of(job)) sampler.limit_to({job.level->nodes.data(), count32(job.level->nodes)});
    if (job.layers.empty()) sampler.sample(job.clip, job.time_s);
    else sampler.blend(job.layers);
    std::copy(job.rig->rest_weights.begin(), job.rig->rest_weights.end(), job.weights.data);
    sampler.read_weights(job.weights.data);
    if (!job.rig->dofs.empty()) apply_dofs(*job.rig, job.dofs, job.weights.data, sampler);
}

}  // namespace

size_t scratch_floats(const model::Rig &rig, const model::Motion *motion)
{
    const size_t exact = 2 * (exact_node_floats * rig.node_count() + rig.rest_weights.size());
    // The bound also holds for motion without clips yet: motion is measured while it is built.
    return motion ? std::max(exact, sampled_floats(*motion)) : exact;
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
    if ((!layers.empty() || has_rows()) && scratch.count < scratch_floats(*rig, motion))
        return Status::bad(CLQ_ARGUMENT, "a pose job of %u layers has %u of %zu numbers of scratch", layers.count,
                           scratch.count, scratch_floats(*rig, motion));
    if (has_rows() && motion->clips.size() != rig->clips.size())
        return Status::bad(CLQ_ARGUMENT, "a pose job has motion of %zu clips and a rig of %zu", motion->clips.size(),
                           rig->clips.size());
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

bool PoseJob::has_rows() const { return motion && !motion->empty(); }

void PoseJob::run_local_transforms() const
{
    if (has_rows()) {
        Sampler sampler(*rig, *motion, simd_level, scratch.data);
        take(*this, sampler);
        sampler.read_locals(layers.empty() && clip != model::none ? clip : model::none, locals.data);
        return;
    }
    sample(*this);
    TrsPose pose{locals.data};
    if (!rig->dofs.empty()) apply_dofs(*rig, dofs, weights.data, pose);
}

void PoseJob::move_feet(const uint32_t *nodes, uint32_t node_count) const
{
    const float sink = feet.count > 0 ? feet[0].sink * feet[0].weight : 0;
    for (uint32_t i = 0; sink > 0 && i < node_count; ++i) {
        Columns &node = globals[nodes ? nodes[i] : i];
        node.c[3] = node.c[3] - F4{0, sink, 0, 0};
    }
    for (const FootTarget &foot : feet)
        if (!nodes || level->active[foot.leg->foot]) move_foot(foot, globals.data);
}

void PoseJob::run() const
{
    const PoseKernels &kernels = pose_kernels_of(simd_level);
    const bool some = active_of(*this);
    const uint32_t *nodes = some ? level->nodes.data() : nullptr;
    const uint32_t node_count = some ? count32(level->nodes) : rig->node_count();
    if (has_rows()) {
        Sampler sampler(*rig, *motion, simd_level, scratch.data);
        take(*this, sampler);
        sampler.local_matrices(globals.data);
    } else {
        run_local_transforms();
        for (uint32_t i = 0; i < node_count; ++i) {
            const uint32_t node = some ? nodes[i] : i;
            globals[node] = columns_of(locals[node]);
        }
    }
    kernels.local_to_model(rig->parents.data(), nodes, node_count, globals.data);
    if (upper.upper) turn_upper(upper, some ? level->active.data() : nullptr, globals.data);
    move_feet(nodes, node_count);
    kernels.fill_palette(rig->palette.data(), some ? level->entries.data() : nullptr,
                         some ? count32(level->entries) : count32(rig->palette), globals.data, palette.data);
}

uint32_t PoseJob::run_local_matrices(base::Span<math::Affine> out) const
{
    run_local_transforms();
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

}  // namespace claque::pose
