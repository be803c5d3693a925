// ns per vertex for positions and normals of bodies of 650 vertices: by number of influences, instruction set, vertex
// format and working set: one body that stays in the nearest caches, 1000, and 20 000 that no cache holds.
#include <map>
#include <random>
#include <vector>

#include "lib/skin/skin.h"
#include "tests/bench/body.h"
#include "tests/bench/measure.h"
#include "tests/bench/textbook.h"

namespace
{

using namespace claque;
using bench::joint_count;
using bench::vertex_count;
using math::SimdLevel;

struct Crowd {
    explicit Crowd(const benchmark::State &state)
        : level(bench::make_level(uint32_t(state.range(0)))),
          count(uint32_t(state.range(1))),
          turns(std::max(count, 100u)),
          palettes(size_t(count) * joint_count + 1),
          out(size_t(count) * 6 * vertex_count)
    {
        std::mt19937 random(2);
        std::uniform_real_distribution<float> real(-1, 1);
        for (math::Affine &a : palettes)
            for (float &x : a.c) x = real(random);
    }
    double vertices() const { return double(turns) * vertex_count; }
    model::Level level;
    uint32_t count, turns;  // turns: bodies skinned in one iteration
    std::vector<math::Affine> palettes;
    std::vector<float> out;
};

double textbook_ns(Crowd &crowd)
{
    static std::map<std::pair<uint32_t, uint32_t>, double> known;
    double &ns = known[{crowd.level.runs[0].influences, crowd.count}];
    if (ns > 0) return ns;
    std::vector<glm::mat4> matrices;
    for (const math::Affine &a : crowd.palettes) matrices.push_back(math::mat4_of(a));
    const auto skin_all = [&] {
        for (uint32_t i = 0; i < crowd.turns; ++i) {
            const size_t c = i % crowd.count;
            bench::textbook_skin(crowd.level, matrices.data() + c * joint_count,
                                 crowd.out.data() + c * 6 * vertex_count);
        }
    };
    ns = bench::shortest_ns(crowd.count < 10000 ? 10 : 2, skin_all) / crowd.vertices();
    return ns;
}

enum class Form { floats, packed };

void skin(benchmark::State &state, SimdLevel simd_level, Form form = Form::floats)
{
    if (!bench::can_run(state, simd_level)) return;
    Crowd crowd(state);
    const double book_ns = textbook_ns(crowd);
    std::vector<float> scratch(skin::scratch_floats(crowd.level, joint_count, skin::Normals::by_palette));
    skin::SkinJob job;
    job.scratch = base::Span<float>(scratch);
    job.level = &crowd.level;
    job.simd_level = simd_level;
    job.range.step = 4.0f / 32767;
    bench::Shortest shortest;
    for (auto _ : state) {
        const bench::Shortest::Lap lap(shortest);
        for (uint32_t i = 0; i < crowd.turns; ++i) {
            const uint32_t c = i % crowd.count;
            job.palette = {crowd.palettes.data() + size_t(c) * joint_count, joint_count};
            if (form == Form::floats) {
                float *out = crowd.out.data() + size_t(c) * 6 * vertex_count;
                job.out_positions = {out, 3 * vertex_count};
                job.out_normals = {out + 3 * vertex_count, 3 * vertex_count};
            } else {
                float *out = crowd.out.data() + size_t(c) * 3 * vertex_count;
                job.out_packed_positions = {reinterpret_cast<skin::PackedPosition *>(out), vertex_count};
                job.out_packed_normals = {reinterpret_cast<skin::PackedNormal *>(out + 2 * vertex_count), vertex_count};
            }
            job.run();
        }
        benchmark::ClobberMemory();
    }
    bench::report(state, shortest, "ns/vertex", crowd.vertices(), book_ns);
}

void sizes(benchmark::internal::Benchmark *b)
{
    for (const int64_t characters : {1, 1000, 20000})
        for (int64_t influences = 1; influences <= 4; ++influences) b->Args({influences, characters});
    b->ArgNames({"influences", "characters"})->Unit(benchmark::kMicrosecond)->MinTime(0.2);
}

BENCHMARK_CAPTURE(skin, fma, SimdLevel::fma)->Apply(sizes);
BENCHMARK_CAPTURE(skin, 256, SimdLevel::simd256)->Apply(sizes);
BENCHMARK_CAPTURE(skin, 256_packed, SimdLevel::simd256, Form::packed)->Apply(sizes);
BENCHMARK_CAPTURE(skin, 128, SimdLevel::simd128)->Apply(sizes);
BENCHMARK_CAPTURE(skin, 128_packed, SimdLevel::simd128, Form::packed)->Apply(sizes);
BENCHMARK_CAPTURE(skin, scalar, SimdLevel::scalar)->Apply(sizes);

}  // namespace
