#include "lib/skin/skin.h"

#include <algorithm>
#include <cmath>

#include "lib/skin/kernel.h"

namespace claque::skin
{

namespace
{

bool morphs_active(const SkinJob &job)
{
    for (const model::MorphRange &range : job.level->morph_ranges)
        if (range.weight < job.morph_weights.count && job.morph_weights[range.weight] != 0) return true;
    return false;
}

// Writes the bind-pose vertices with their morph targets.
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

template <class Form>
void fill_copies(const model::Level &level, Form *out)
{
    Form *to = out + level.source_count;
    for (const uint32_t source : level.copies) *to++ = out[source];
}

Float3 *vertices_of(base::Span<float> floats) { return reinterpret_cast<Float3 *>(floats.data); }

constexpr size_t alignment_floats = 8;

// Aligned matrices of the palette and of sets, and the same for normals if those have their own.
size_t matrix_floats(size_t palette_count, Normals normals)
{
    return aligned_matrix_floats * (palette_count + model::max_chunk_sets) *
           (normals == Normals::by_own_matrices ? 2 : 1);
}

// One job: divides its scratch memory, then runs the segments of the level's plan.
class Work
{
public:
    explicit Work(const SkinJob &job)
        : job_(job), level_(*job.level), positions_(level_.positions.data()), normals_(level_.normals.data())
    {
        float *spare = reinterpret_cast<float *>((reinterpret_cast<uintptr_t>(job.scratch.data) + 31) & ~uintptr_t(31));
        palette_ = spare;
        align_matrices(job.palette, palette_);
        set_palette_ = spare += aligned_matrix_floats * job.palette.count;
        spare += aligned_matrix_floats * model::max_chunk_sets;
        if (job.normals == Normals::by_own_matrices) {
            normal_palette_ = spare;
            for (uint32_t i = 0; i < job.palette.count; ++i, spare += aligned_matrix_floats) {
                math::Affine padded[2];  // loads run one float over
                padded[0] = math::normal_matrix(job.palette[i]);
                align_matrices({padded, 1}, spare);
            }
            set_normal_palette_ = spare;
            spare += aligned_matrix_floats * model::max_chunk_sets;
        }
        packed_.range = job.range;
        packed_.positions = job.out_packed_positions.data, packed_.normals = job.out_packed_normals.data;
        if (!morphs_active(job)) return;
        morph(job, spare, spare + 3 * size_t(level_.source_count));
        positions_ = spare;
        normals_ = spare + 3 * size_t(level_.source_count);
        morphed_ = true;
    }

    void run() const
    {
        const SimdLevel simd_level = can_run(job_.simd_level) ? job_.simd_level : SimdLevel::simd128;
        const auto &segments = level_.skinning.segments;
        if (simd_level == SimdLevel::scalar || segments.empty()) run_plainly(simd_level);
        else
            for (const model::SkinSegment &segment : segments) run_segment(segment, simd_level);
        if (packed_.positions) {
            fill_copies(level_, packed_.positions);
            fill_copies(level_, packed_.normals);
        } else {
            fill_copies(level_, vertices_of(job_.out_positions));
            fill_copies(level_, vertices_of(job_.out_normals));
        }
    }

private:
    void run_plainly(SimdLevel simd_level) const
    {
        for (const model::InfluenceRun &part : level_.runs) {
            model::SkinSegment all;
            all.influences = part.influences;
            all.first = part.first, all.count = part.count, all.first_influence = part.first_influence;
            run_vertices(run_of(all), part.first, simd_level);
        }
    }

    void run_segment(const model::SkinSegment &segment, SimdLevel simd_level) const
    {
        if (segment.method == model::SkinMethod::block && !morphed_) run_blocks(segment, simd_level);
        else if (segment.method == model::SkinMethod::set) run_sets(segment, simd_level);
        else run_vertices(run_of(segment), segment.first, simd_level);
    }

    Run run_of(const model::SkinSegment &segment) const
    {
        Run run;
        run.count = segment.count;
        run.influences = segment.influences;
        run.positions = positions_ + 3 * size_t(segment.first);
        run.normals = normals_ + 3 * size_t(segment.first);
        run.joints = level_.joints.data() + segment.first_influence;
        run.weights = level_.weights.data() + segment.first_influence;
        run.palette = palette_, run.normal_palette = normal_palette_;
        if (!packed_.positions) {
            run.out_positions = job_.out_positions.data + 3 * size_t(segment.first);
            run.out_normals = job_.out_normals.data + 3 * size_t(segment.first);
        }
        return run;
    }

    // `first`: index in the level's vertices.
    void run_vertices(const Run &run, uint32_t first, SimdLevel simd_level) const
    {
        if (packed_.positions) run_packed(run, first, simd_level);
        else run_floats(run, simd_level);
    }

    // Packs through a buffer that stays in the L1 cache.
    void run_packed(Run run, uint32_t first, SimdLevel simd_level) const
    {
        constexpr uint32_t maximum = 64;
        float positions[3 * maximum], normals[3 * maximum];
        run.out_positions = positions, run.out_normals = normals;
        PackJob pack;
        pack.range = packed_.range;
        pack.simd_level = simd_level;
        for (uint32_t left = run.count; left > 0; left -= run.count) {
            run.count = std::min(left, maximum);
            run_floats(run, simd_level);
            pack.positions = {positions, 3 * run.count}, pack.normals = {normals, 3 * run.count};
            pack.out_positions = {packed_.positions + first, run.count};
            pack.out_normals = {packed_.normals + first, run.count};
            pack.run();
            first += run.count;
            run.advance(run.count);
        }
    }

    static void run_floats(const Run &run, SimdLevel simd_level)
    {
        if (simd_level == SimdLevel::scalar) run_scalar(run);
        else if (simd_level == SimdLevel::simd256 || simd_level == SimdLevel::fma) run_256(run);
        else run_128(run);
    }

    void run_sets(const model::SkinSegment &segment, SimdLevel simd_level) const
    {
        SetRun sets;
        sets.count = segment.item_count;
        sets.influences = segment.influences;
        sets.joints = level_.skinning.set_joints.data() + segment.first_item;
        sets.weights = level_.skinning.set_weights.data() + segment.first_item;
        sets.palette = palette_, sets.out = set_palette_;
        blend_128(sets);
        Run run = run_of(segment);
        run.influences = 1;
        run.joints = level_.skinning.set_of.data() + segment.first_set_of;
        run.palette = set_palette_;
        if (normal_palette_) {
            sets.palette = normal_palette_, sets.out = set_normal_palette_;
            blend_128(sets);
            run.normal_palette = set_normal_palette_;
        }
        run_vertices(run, segment.first, simd_level);
    }

    void run_blocks(const model::SkinSegment &segment, SimdLevel simd_level) const
    {
        BlockRun run;
        run.blocks = level_.skinning.blocks.data() + segment.first_item;
        run.count = segment.item_count;
        run.influences = segment.influences;
        run.lanes = level_.skinning.lanes.data();
        run.palette = palette_, run.normal_palette = normal_palette_;
        run.vertex_count = level_.vertex_count;
        run.out_positions = vertices_of(job_.out_positions), run.out_normals = vertices_of(job_.out_normals);
        run.packed = packed_;
        if (simd_level == SimdLevel::fma) run_256_fma_blocks(run);
        else if (simd_level == SimdLevel::simd256) run_256_blocks(run);
        else if (math::has_avx()) run_128_avx_blocks(run);
        else run_128_blocks(run);
    }

    const SkinJob &job_;
    const model::Level &level_;
    const float *positions_, *normals_;  // bind pose, or morphed
    bool morphed_ = false;
    PackedOutput packed_;
    float *palette_ = nullptr, *normal_palette_ = nullptr;
    float *set_palette_ = nullptr, *set_normal_palette_ = nullptr;
};

}  // namespace

size_t scratch_floats(const model::Level &level, size_t palette_count, Normals normals)
{
    return alignment_floats + matrix_floats(palette_count, normals) +
           (level.morph_ranges.empty() ? 0 : 6 * size_t(level.source_count));
}

base::Status SkinJob::check() const
{
    using base::Status;
    if (!level) return Status::bad(CLQ_ARGUMENT, "a skin job has no level");
    const uint64_t floats = 3 * uint64_t(level->vertex_count);
    const bool packs = out_packed_positions.count || out_packed_normals.count;
    if (packs && (out_packed_positions.count < level->vertex_count || out_packed_normals.count < level->vertex_count))
        return Status::bad(CLQ_ARGUMENT, "a skin job has room for %u and %u of %u packed vertices",
                           out_packed_positions.count, out_packed_normals.count, level->vertex_count);
    if (packs && (!(range.step > 0) || !std::isfinite(range.step)))
        return Status::bad(CLQ_ARGUMENT, "a skin job packs in steps of %g", static_cast<double>(range.step));
    if (!packs && (out_positions.count < floats || out_normals.count < floats))
        return Status::bad(CLQ_ARGUMENT, "a skin job has room for %u and %u of %llu numbers", out_positions.count,
                           out_normals.count, static_cast<unsigned long long>(floats));
    const size_t needed = scratch_floats(*level, palette.count, normals);
    if (scratch.count < needed)
        return Status::bad(CLQ_ARGUMENT, "a skin job has %u of %zu numbers of scratch", scratch.count, needed);
    return Status::good();
}

void SkinJob::run() const { Work(*this).run(); }

}  // namespace claque::skin
