#include "lib/skin/skin.h"

#include <algorithm>

#include "lib/skin/kernel.h"

namespace claque::skin
{

namespace
{

size_t normal_floats(size_t palette_count, Normals normals)
{
    return normals == Normals::by_own_matrices ? 12 * (palette_count + 1) : 0;
}

bool morphs_active(const SkinJob &job)
{
    for (const model::MorphRange &range : job.level->morph_ranges)
        if (range.weight < job.morph_weights.count && job.morph_weights[range.weight] != 0) return true;
    return false;
}

// Bind-pose vertices with their morph targets, into `out`: positions, then normals.
void morph(const SkinJob &job, float *positions, float *normals)
{
    const model::Level &level = *job.level;
    std::copy(level.positions.begin(), level.positions.end(), positions);
    std::copy(level.normals.begin(), level.normals.end(), normals);
    for (const model::MorphRange &range : level.morph_ranges) {
        const float weight = range.weight < job.morph_weights.count ? job.morph_weights[range.weight] : 0;
        if (weight == 0) continue;
        for (uint32_t i = range.first; i < range.first + range.count; ++i) {
            const model::MorphDelta &delta = level.morph_deltas[i];
            for (int k = 0; k < 3; ++k) {
                positions[3 * size_t(delta.vertex) + k] += weight * delta.position[k];
                normals[3 * size_t(delta.vertex) + k] += weight * delta.normal[k];
            }
        }
    }
}

void fill_copies(const model::Level &level, float *out)
{
    float *to = out + 3 * size_t(level.source_count);
    for (const uint32_t source : level.copies) {
        const float *from = out + 3 * size_t(source);
        to[0] = from[0], to[1] = from[1], to[2] = from[2];
        to += 3;
    }
}

// Aligned matrices for the wide kernel, and the room to align them.
size_t wide_floats(size_t palette_count, Normals normals)
{
    return wide_matrix_floats * palette_count * (normals == Normals::by_own_matrices ? 2 : 1) + 8;
}

}  // namespace

size_t scratch_floats(const model::Level &level, size_t palette_count, Normals normals)
{
    return wide_floats(palette_count, normals) + normal_floats(palette_count, normals) +
           (level.morph_ranges.empty() ? 0 : 6 * size_t(level.source_count));
}

base::Status SkinJob::check() const
{
    using base::Status;
    if (!level) return Status::bad(CLQ_ARGUMENT, "a skin job has no level");
    const uint64_t floats = 3 * uint64_t(level->vertex_count);
    if (out_positions.count < floats || out_normals.count < floats)
        return Status::bad(CLQ_ARGUMENT, "a skin job has room for %u and %u of %llu numbers", out_positions.count,
                           out_normals.count, static_cast<unsigned long long>(floats));
    const size_t needed = scratch_floats(*level, palette.count, normals);
    if (scratch.count < needed)
        return Status::bad(CLQ_ARGUMENT, "a skin job has %u of %zu numbers of scratch", scratch.count, needed);
    return Status::good();
}

void SkinJob::run() const
{
    const float *positions = level->positions.data(), *bind_normals = level->normals.data();
    const math::Affine *normal_palette = nullptr;
    float *spare = scratch.data + wide_floats(palette.count, normals);
    if (normals == Normals::by_own_matrices) {
        math::Affine *matrices = reinterpret_cast<math::Affine *>(spare);
        for (uint32_t i = 0; i < palette.count; ++i) matrices[i] = math::normal_matrix(palette[i]);
        normal_palette = matrices;
    }
    if (morphs_active(*this)) {
        float *morphed = spare + normal_floats(palette.count, normals);
        morph(*this, morphed, morphed + 3 * size_t(level->source_count));
        positions = morphed;
        bind_normals = morphed + 3 * size_t(level->source_count);
    }
    float *wide = nullptr;
    const size_t wide_count = wide_matrix_floats * palette.count;
    const bool runs_wide = kernel == Kernel::wide && can_run(Kernel::wide);
    if (runs_wide) {
        wide = reinterpret_cast<float *>((reinterpret_cast<uintptr_t>(scratch.data) + 31) & ~uintptr_t(31));
        widen(palette, wide);
        if (normal_palette) widen({normal_palette, palette.count}, wide + wide_count);
    }
    for (const model::InfluenceRun &part : level->runs) {
        Run run;
        run.wide_palette = wide;
        run.wide_normal_palette = normal_palette ? wide + wide_count : nullptr;
        run.count = part.count;
        run.influences = part.influences;
        run.positions = positions + 3 * size_t(part.first);
        run.normals = bind_normals + 3 * size_t(part.first);
        run.joints = level->joints.data() + part.first_influence;
        run.weights = level->weights.data() + part.first_influence;
        run.palette = palette.data;
        run.normal_palette = normal_palette;
        run.out_positions = out_positions.data + 3 * size_t(part.first);
        run.out_normals = out_normals.data + 3 * size_t(part.first);
        if (kernel == Kernel::scalar) run_scalar(run);
        else if (runs_wide) run_wide(run);
        else run_vector(run);
    }
    fill_copies(*level, out_positions.data);
    fill_copies(*level, out_normals.data);
}

}  // namespace claque::skin
