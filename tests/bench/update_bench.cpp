// Whole updates on one core: all actors due, by instruction set and vertex format; a crowd of which one in five is
// visible, at the rates of the law; and a crowd out of view.
#include <random>
#include <vector>

#include "lib/crowd/edits.h"
#include "tests/bench/crowd_scene.h"
#include "tests/bench/measure.h"
#include "tests/bench/textbook.h"

namespace
{

using namespace claque;
using animcache::VertexFormat;
using bench::Scene;
using math::SimdLevel;

// Posing and skinning alone, without culling, periods and lists.
double textbook_ns(const model::Template &tmpl, uint32_t count)
{
    bench::TextbookPose book(tmpl.rig);
    std::vector<glm::mat4> palette(bench::joint_count);
    std::vector<float> out(size_t(count) * 6 * bench::vertex_count);
    const auto frame = [&] {
        for (uint32_t i = 0; i < count; ++i) {
            book.pose(bench::Blend::one_clip, float(i * 137 % 1000) * 0.001f, 0, palette.data());
            bench::textbook_skin(tmpl.levels[0], palette.data(), out.data() + size_t(i) * 6 * bench::vertex_count);
        }
    };
    return bench::shortest_ns(count < 10000 ? 5 : 2, frame) / count;
}

void everybody_due(benchmark::State &state, SimdLevel simd_level, VertexFormat vertex_format)
{
    if (!bench::can_run(state, simd_level)) return;
    const SimdLevel before = math::default_simd_level();
    math::set_simd_level(simd_level);
    const uint32_t count = uint32_t(state.range(0));
    bench::AllDue scene(count, vertex_format);
    const uint32_t animated = scene.frame.stats().animated;
    const double book_ns = textbook_ns(*scene.tmpl, animated);
    double t = 0;
    bench::Shortest shortest;
    for (auto _ : state) {
        const bench::Shortest::Lap lap(shortest);
        scene.update(t += 0.0167);
    }
    if (animated != count) state.SkipWithError("not everybody is due");
    state.counters["individuals/ms"] = 1e6 * animated / shortest.ns();
    bench::report(state, shortest, "ns/individual", animated, book_ns);
    math::set_simd_level(before);
}

void one_in_five_seen(benchmark::State &state)
{
    Scene scene(uint32_t(state.range(0)), 100, frame::Settings());
    scene.view.camera = frame::look_at({0, 2, 0}, {0, 2, -1}, {0, 1, 0}, 0.9f, 1.5f, 0.1f, 1000);
    double t = 0;
    for (auto _ : state) scene.update(t += 0.0167);
    state.counters["seen"] = scene.frame.stats().visible;
    state.counters["due"] = scene.frame.stats().due;
}

// A crowd behind the eye, in as many groups as the second number says: the cost of an actor out of view.
void out_of_view(benchmark::State &state)
{
    Scene scene(0, 1, frame::Settings());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> real(-300, 300);
    const int64_t groups = state.range(1);
    std::vector<crowd::Id> ids;
    for (int64_t g = 0; g < groups; ++g) ids.push_back(crowd::create_group(scene.crowd, crowd::Transform()));
    for (int64_t i = 0; i < state.range(0); ++i) {
        crowd::Transform place;
        place.position = glm::dvec3(real(random), 0, 900 + real(random));
        const crowd::Id id = crowd::create(scene.crowd, *scene.tmpl, place, crowd::Play(), uint64_t(i));
        if (groups) crowd::join(scene.crowd, id, ids[size_t(i % groups)], nullptr);
    }
    scene.view.camera = frame::look_at({0, 2, 0}, {0, 2, -1}, {0, 1, 0}, 0.9f, 1.5f, 0.1f, 1000);
    double t = 0;
    bench::Shortest shortest;
    for (auto _ : state) {
        const bench::Shortest::Lap lap(shortest);
        scene.update(t += 0.0167);
    }
    bench::report(state, shortest, "ns/actor", double(state.range(0)), 0);
}

void crowds(benchmark::internal::Benchmark *b)
{
    b->ArgName("characters")->Arg(1000)->Arg(20000)->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(everybody_due, 256, SimdLevel::simd256, VertexFormat::floats)->Apply(crowds);
BENCHMARK_CAPTURE(everybody_due, 256_packed, SimdLevel::simd256, VertexFormat::packed)->Apply(crowds);
BENCHMARK_CAPTURE(everybody_due, 128, SimdLevel::simd128, VertexFormat::floats)->Apply(crowds);
BENCHMARK_CAPTURE(everybody_due, 128_packed, SimdLevel::simd128, VertexFormat::packed)->Apply(crowds);
BENCHMARK(one_in_five_seen)->Arg(2000)->Arg(6000)->Unit(benchmark::kMillisecond);
BENCHMARK(out_of_view)
    ->Args({1000, 0})
    ->Args({10000, 0})
    ->Args({100000, 0})
    ->Args({100000, 100})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
