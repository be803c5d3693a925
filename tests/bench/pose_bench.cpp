// ns per joint: rows of clips to rotations, to blended rotations and to matrix palettes, of 1000 characters at the
// ticks of several rates and at random times (0).
#include <cmath>
#include <vector>

#include "lib/pose/pose.h"
#include "lib/pose/sampled.h"
#include "tests/bench/body.h"
#include "tests/bench/measure.h"
#include "tests/bench/textbook.h"

namespace
{

using namespace claque;
using bench::Blend;
using bench::joint_count;
using math::SimdLevel;

constexpr uint32_t character_count = 1000;
constexpr double joints = double(character_count) * joint_count;

const model::Template &character()
{
    static const std::unique_ptr<model::Template> tmpl = bench::make_body(2);
    return *tmpl;
}

// Times of all next ticks, computed before the measurement; rate 0: random times.
class Times
{
public:
    explicit Times(int64_t rate) : times_(tick_count * character_count * 2)
    {
        for (uint64_t tick = 0; tick < tick_count; ++tick)
            for (uint32_t c = 0; c < character_count; ++c)
                for (int clip = 0; clip < 2; ++clip) {
                    const double t =
                        rate ? double(tick) / double(rate) : double((c * 7919 + tick * 104729) % 1000) * 0.0011;
                    times_[index(tick, c, clip)] = std::fmod(t + c * 0.0137, bench::clip_lengths_s[clip]);
                }
    }
    double at(uint64_t tick, uint32_t character, int clip) const { return times_[index(tick, character, clip)]; }

private:
    static constexpr uint64_t tick_count = 64;
    static size_t index(uint64_t tick, uint32_t character, int clip)
    {
        return 2 * (tick % tick_count * character_count + character) + size_t(clip);
    }
    std::vector<double> times_;
};

double textbook_sample_ns(const Times &times)
{
    const bench::TextbookPose book(character().rig);
    std::vector<glm::quat> out(joint_count);
    uint64_t tick = 0;
    return bench::shortest_ns(10,
                              [&] {
                                  for (uint32_t c = 0; c < character_count; ++c) {
                                      for (uint32_t i = 0; i < joint_count; ++i)
                                          out[i] = book.sample(0, i, float(times.at(tick, c, 0)));
                                      benchmark::DoNotOptimize(out.data());
                                      benchmark::ClobberMemory();
                                  }
                                  ++tick;
                              }) /
           joints;
}

double textbook_palette_ns(const Times &times, Blend blend)
{
    bench::TextbookPose book(character().rig);
    std::vector<glm::mat4> palettes(character_count * joint_count);
    uint64_t tick = 0;
    return bench::shortest_ns(10,
                              [&] {
                                  for (uint32_t c = 0; c < character_count; ++c)
                                      book.pose(blend, float(times.at(tick, c, 0)), float(times.at(tick, c, 1)),
                                                palettes.data() + c * joint_count);
                                  ++tick;
                              }) /
           joints;
}

// Two rows to rotations only.
void sample(benchmark::State &state, SimdLevel simd_level)
{
    if (!bench::can_run(state, simd_level)) return;
    const model::Template &tmpl = character();
    std::vector<float> scratch(pose::sampled_floats(tmpl.motion));
    pose::Sampler sampler(tmpl.rig, tmpl.motion, simd_level, scratch.data());
    const Times times(state.range(0));
    const double textbook_ns = textbook_sample_ns(times);
    uint64_t tick = 0;
    bench::Shortest shortest;
    for (auto _ : state) {
        const bench::Shortest::Lap lap(shortest);
        for (uint32_t c = 0; c < character_count; ++c) {
            sampler.sample(0, times.at(tick, c, 0));
            benchmark::ClobberMemory();
        }
        ++tick;
    }
    bench::report(state, shortest, "ns/joint", joints, textbook_ns);
}

// The parts of a blend as lib/behave makes them; an inertial one has what is left of an offset and of its velocity.
class Layers
{
public:
    explicit Layers(Blend blend)
    {
        layers_[0].clip = 0, layers_[1].clip = 1, layers_[1].weight = bench::blend_weight;
        if (blend != Blend::one_clip) count_ = 2;
        if (blend == Blend::upper_body) {
            for (uint32_t i = 0; i < joint_count; ++i) mask_[i] = bench::mask_of(i);
            layers_[1].mask = mask_;
        }
        if (blend != Blend::inertial) return;
        count_ = 3;
        layers_[2] = layers_[1];
        layers_[1].time_s = 0.3, layers_[2].time_s = 0.25, layers_[2].weight = -bench::velocity_weight;
        for (pose::Layer *layer : {layers_ + 1, layers_ + 2}) {
            layer->kind = pose::LayerKind::add;
            layer->reference_clip = 0, layer->reference_time_s = layer->time_s;
        }
    }
    // The layers at a time; none for a clip alone.
    base::Span<const pose::Layer> at(double time_s, double other_s)
    {
        layers_[0].time_s = time_s;
        if (count_ == 2) layers_[1].time_s = other_s;
        return {layers_, count_};
    }

private:
    pose::Layer layers_[3];
    float mask_[joint_count];
    uint32_t count_ = 0;
};

enum class Source { rows, channels };

void palette(benchmark::State &state, SimdLevel simd_level, Blend blend, Source source = Source::rows)
{
    if (!bench::can_run(state, simd_level)) return;
    const model::Template &tmpl = character();
    pose::Workspace workspace(tmpl.rig, source == Source::rows ? &tmpl.motion : nullptr);
    std::vector<math::Affine> palettes(character_count * joint_count + 1);
    pose::PoseJob job = workspace.job();
    job.simd_level = simd_level;
    job.clip = 0;
    Layers layers(blend);
    const Times times(state.range(0));
    const double textbook_ns = textbook_palette_ns(times, blend);
    uint64_t tick = 0;
    bench::Shortest shortest;
    for (auto _ : state) {
        const bench::Shortest::Lap lap(shortest);
        for (uint32_t c = 0; c < character_count; ++c) {
            job.time_s = times.at(tick, c, 0);
            job.layers = layers.at(job.time_s, times.at(tick, c, 1));
            job.palette = {palettes.data() + c * joint_count, joint_count};
            job.run();
        }
        ++tick;
        benchmark::ClobberMemory();
    }
    bench::report(state, shortest, "ns/joint", joints, textbook_ns);
}

void at_rates(benchmark::internal::Benchmark *b)
{
    for (const int rate : {60, 25, 10, 4, 0}) b->Arg(rate);
    b->ArgName("Hz")->Unit(benchmark::kMicrosecond)->MinTime(0.2);
}

BENCHMARK_CAPTURE(sample, 256, SimdLevel::simd256)->Apply(at_rates);
BENCHMARK_CAPTURE(sample, 128, SimdLevel::simd128)->Apply(at_rates);
BENCHMARK_CAPTURE(palette, one_clip_256, SimdLevel::simd256, Blend::one_clip)->Apply(at_rates);
BENCHMARK_CAPTURE(palette, one_clip_128, SimdLevel::simd128, Blend::one_clip)->Apply(at_rates);
BENCHMARK_CAPTURE(palette, one_clip_exact, SimdLevel::simd256, Blend::one_clip, Source::channels)->Apply(at_rates);
BENCHMARK_CAPTURE(palette, two_clips_256, SimdLevel::simd256, Blend::two_clips)->Apply(at_rates);
BENCHMARK_CAPTURE(palette, two_clips_128, SimdLevel::simd128, Blend::two_clips)->Apply(at_rates);
BENCHMARK_CAPTURE(palette, two_clips_scalar, SimdLevel::scalar, Blend::two_clips)->Apply(at_rates);
BENCHMARK_CAPTURE(palette, two_clips_exact, SimdLevel::simd256, Blend::two_clips, Source::channels)->Apply(at_rates);
BENCHMARK_CAPTURE(palette, upper_body_256, SimdLevel::simd256, Blend::upper_body)->Apply(at_rates);
BENCHMARK_CAPTURE(palette, upper_body_128, SimdLevel::simd128, Blend::upper_body)->Apply(at_rates);
BENCHMARK_CAPTURE(palette, inertial_256, SimdLevel::simd256, Blend::inertial)->Apply(at_rates);
BENCHMARK_CAPTURE(palette, inertial_128, SimdLevel::simd128, Blend::inertial)->Apply(at_rates);

}  // namespace
