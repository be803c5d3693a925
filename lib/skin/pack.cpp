#include "lib/skin/pack.h"

#include <cmath>
#include <cstring>

#include "lib/skin/pack_kernel.h"

namespace claque::skin
{

namespace
{

// Comparisons as the processor's minimum and maximum do them: what is no number becomes the limit.
float within(float x, float limit)
{
    const float below = x < limit ? x : limit;
    return below > -limit ? below : -limit;
}

int32_t nearest(float x)
{
    const float sum = x + rounder;
    int32_t bits, zero;
    std::memcpy(&bits, &sum, 4);
    std::memcpy(&zero, &rounder, 4);
    return bits - zero;
}

int16_t position_step(float x, float offset, float per_step)
{
    return static_cast<int16_t>(nearest(within((x - offset) * per_step, position_limit)));
}

PackedNormal packed(const float *n)
{
    const float square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    const float scale = normal_limit / std::sqrt(square > least_square ? square : least_square);
    PackedNormal out;
    out.x = static_cast<int8_t>(nearest(within(n[0] * scale, normal_limit)));
    out.y = static_cast<int8_t>(nearest(within(n[1] * scale, normal_limit)));
    out.z = static_cast<int8_t>(nearest(within(n[2] * scale, normal_limit)));
    return out;
}

}  // namespace

void pack_scalar(const PackJob &job, uint32_t first)
{
    const float per_step = 1 / job.range.step;
    const float *offset = job.range.offset;
    for (uint32_t v = first; v < job.out_positions.count; ++v) {
        const float *p = job.positions.data + 3 * size_t(v);
        PackedPosition &to = job.out_positions[v];
        to.x = position_step(p[0], offset[0], per_step);
        to.y = position_step(p[1], offset[1], per_step);
        to.z = position_step(p[2], offset[2], per_step);
        to.w = 1;
        job.out_normals[v] = packed(job.normals.data + 3 * size_t(v));
    }
}

PackRange pack_range(const model::Template &tmpl)
{
    PackRange range;
    for (int k = 0; k < 3; ++k) range.offset[k] = tmpl.sklsroot.centre[k];
    if (tmpl.sklsroot.radius > 0) range.step = tmpl.sklsroot.radius / position_limit;
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

void PackJob::run() const { pack_scalar(*this, kernel == Kernel::scalar ? 0 : pack_vector(*this)); }

}  // namespace claque::skin
