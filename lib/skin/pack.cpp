#include "lib/skin/pack.h"

#include <cmath>

#include "lib/skin/pack_kernel.h"

namespace claque::skin
{

void pack_scalar(const PackJob &job, uint32_t first)
{
    for (uint32_t v = first; v < job.out_positions.count; ++v) {
        const float *p = job.positions.data + 3 * size_t(v), *n = job.normals.data + 3 * size_t(v);
        job.out_positions[v] = packed_position(p[0], p[1], p[2], job.range);
        job.out_normals[v] = packed_normal(n[0], n[1], n[2]);
    }
}

PackRange pack_range(const model::Template &tmpl, float blend_radius)
{
    PackRange range;
    const float radius = blend_radius > tmpl.sklsroot.radius ? blend_radius : tmpl.sklsroot.radius;
    for (int k = 0; k < 3; ++k) range.offset[k] = tmpl.sklsroot.centre[k];
    if (radius > 0) range.step = radius / position_limit;
    return range;
}

base::Status PackJob::check() const
{
    using base::Status;
    if (positions.count % 3 != 0 || normals.count != positions.count)
        return Status::bad(CLQ_ARGUMENT, "a pack job has %u numbers of positions and %u of normals", positions.count,
                           normals.count);
    const uint32_t vertices = positions.count / 3;
    if (out_positions.count != vertices || out_normals.count != vertices)
        return Status::bad(CLQ_ARGUMENT, "a pack job of %u vertices has room for %u positions and %u normals", vertices,
                           out_positions.count, out_normals.count);
    if (!(range.step > 0) || !std::isfinite(range.step))
        return Status::bad(CLQ_ARGUMENT, "a pack job has steps of %g", static_cast<double>(range.step));
    return Status::good();
}

void PackJob::run() const { pack_scalar(*this, simd_level == SimdLevel::scalar ? 0 : pack_128(*this)); }

}  // namespace claque::skin
