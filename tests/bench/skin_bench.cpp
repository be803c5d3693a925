// ns a vertex for positions and normals, 1000 characters of 650 vertices, beside the textbook's loop in the same
// binary: quote ratios of one run.
#include <benchmark/benchmark.h>

#include <memory>
#include <random>
#include <vector>

#include "lib/skin/skin.h"
#include "tests/bench/body.h"

namespace
{

using namespace claque;

using bench::joint_count;
using bench::make_level;
using bench::vertex_count;

struct Crowd {
    Crowd(uint32_t influences, uint32_t characters) : level(make_level(influences)), count(characters)
    {
        std::mt19937 random(2);
        std::uniform_real_distribution<float> real(-1, 1);
        palettes.resize(count * joint_count + 1);
        for (math::Affine &a : palettes)
            for (float &x : a.c) x = real(random);
        out.resize(size_t(count) * 6 * vertex_count);
    }
    model::Level level;
    uint32_t count;
    std::vector<math::Affine> palettes;
    std::vector<float> out;
};

void count(benchmark::State &state, uint32_t character_count)
{
    const double vertices = double(state.iterations()) * character_count * vertex_count;
    state.counters["ns/vertex"] =
        benchmark::Counter(vertices * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void skin(benchmark::State &state, skin::Kernel kernel)
{
    if (!skin::can_run(kernel)) return state.SkipWithError("this processor has not these vectors");
    Crowd crowd(uint32_t(state.range(0)), uint32_t(state.range(1)));
    std::vector<float> scratch(skin::scratch_floats(crowd.level, joint_count, skin::Normals::by_palette));
    for (auto _ : state) {
        for (uint32_t c = 0; c < crowd.count; ++c) {
            skin::SkinJob job;
            job.scratch = base::Span<float>(scratch);
            job.level = &crowd.level;
            job.palette = {crowd.palettes.data() + c * joint_count, joint_count};
            job.kernel = kernel;
            float *out = crowd.out.data() + size_t(c) * 6 * vertex_count;
            job.out_positions = {out, 3 * vertex_count};
            job.out_normals = {out + 3 * vertex_count, 3 * vertex_count};
            job.run();
        }
        benchmark::ClobberMemory();
    }
    count(state, crowd.count);
}

// For each influence: matrix times vertex, times weight, summed. 4 x 4 matrices, as most write it.
void textbook(benchmark::State &state)
{
    Crowd crowd(uint32_t(state.range(0)), uint32_t(state.range(1)));
    const uint32_t influences = uint32_t(state.range(0));
    std::vector<glm::mat4> matrices;
    for (const math::Affine &a : crowd.palettes) matrices.push_back(math::mat4_of(a));
    for (auto _ : state) {
        for (uint32_t c = 0; c < crowd.count; ++c) {
            const glm::mat4 *palette = matrices.data() + c * joint_count;
            float *out = crowd.out.data() + size_t(c) * 6 * vertex_count;
            for (uint32_t v = 0; v < vertex_count; ++v) {
                const float *p = crowd.level.positions.data() + 3 * v, *n = crowd.level.normals.data() + 3 * v;
                glm::vec4 position(0), normal(0);
                for (uint32_t i = 0; i < influences; ++i) {
                    const glm::mat4 &m = palette[crowd.level.joints[v * influences + i]];
                    const float w = crowd.level.weights[v * influences + i];
                    position += w * (m * glm::vec4(p[0], p[1], p[2], 1));
                    normal += w * (m * glm::vec4(n[0], n[1], n[2], 0));
                }
                for (int k = 0; k < 3; ++k) out[3 * v + k] = position[k], out[3 * (vertex_count + v) + k] = normal[k];
            }
        }
        benchmark::ClobberMemory();
    }
    count(state, crowd.count);
}

void sizes(benchmark::internal::Benchmark *bench)
{
    for (const int64_t characters : {1000, 20000})
        for (int64_t influences = 1; influences <= 4; ++influences) bench->Args({influences, characters});
    bench->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(skin, fused, skin::Kernel::fused)->Apply(sizes);
BENCHMARK_CAPTURE(skin, wide, skin::Kernel::wide)->Apply(sizes);
BENCHMARK_CAPTURE(skin, vector, skin::Kernel::vector)->Apply(sizes);
BENCHMARK_CAPTURE(skin, scalar, skin::Kernel::scalar)->Apply(sizes);
BENCHMARK(textbook)->Apply(sizes);

}  // namespace
