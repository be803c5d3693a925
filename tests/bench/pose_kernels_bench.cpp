// ns per joint of each step from rotations to palettes by itself, to see which step a pose's time goes into.
#include <vector>

#include "lib/pose/pose_kernels.h"
#include "tests/bench/body.h"
#include "tests/bench/measure.h"

namespace
{

using namespace claque;
using bench::joint_count;
using math::SimdLevel;

constexpr uint32_t turns = 1000;  // in one iteration

enum class Step { blend, locals, chain, palette };

void step(benchmark::State &state, SimdLevel simd_level, Step which)
{
    if (!bench::can_run(state, simd_level)) return;
    static const std::unique_ptr<model::Template> tmpl = bench::make_body(2);
    const model::Motion &motion = tmpl->motion;
    const pose::PoseKernels &kernels = pose::pose_kernels_of(simd_level);
    std::vector<float> rotations(motion.rest_rotations.begin(), motion.rest_rotations.end()), others = rotations;
    std::vector<math::Columns> columns(joint_count);
    std::vector<math::Affine> palette(joint_count + 1);
    const pose::JointTransforms places = {motion.nodes.data(), motion.rest_scales.data(), motion.rest_offsets.data(),
                                          motion.block_count()};
    kernels.local_matrices(rotations.data(), places, columns.data());
    bench::Shortest shortest;
    for (auto _ : state) {
        const bench::Shortest::Lap lap(shortest);
        for (uint32_t turn = 0; turn < turns; ++turn) {
            if (which == Step::blend)
                kernels.replace(rotations.data(), others.data(), {0.4f, nullptr}, motion.block_count());
            if (which == Step::chain)
                kernels.local_to_model(tmpl->rig.parents.data(), nullptr, joint_count, columns.data());
            // A chain of repeated products would leave the range of floats.
            if (which == Step::locals || (which == Step::chain && turn % 8 == 7))
                kernels.local_matrices(rotations.data(), places, columns.data());
            if (which == Step::palette)
                kernels.fill_palette(tmpl->rig.palette.data(), nullptr, joint_count, columns.data(), palette.data());
            benchmark::ClobberMemory();
        }
    }
    bench::report(state, shortest, "ns/joint", turns * joint_count, 0);
}

BENCHMARK_CAPTURE(step, blend_256, SimdLevel::simd256, Step::blend);
BENCHMARK_CAPTURE(step, blend_128, SimdLevel::simd128, Step::blend);
BENCHMARK_CAPTURE(step, locals_256, SimdLevel::simd256, Step::locals);
BENCHMARK_CAPTURE(step, locals_128, SimdLevel::simd128, Step::locals);
BENCHMARK_CAPTURE(step, chain_256, SimdLevel::simd256, Step::chain);
BENCHMARK_CAPTURE(step, chain_128, SimdLevel::simd128, Step::chain);
BENCHMARK_CAPTURE(step, palette_256, SimdLevel::simd256, Step::palette);
BENCHMARK_CAPTURE(step, palette_128, SimdLevel::simd128, Step::palette);

}  // namespace
