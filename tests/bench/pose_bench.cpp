// ns a joint for one and two clips to a matrix palette: 1000 characters of 33 joints in clips of 1.1 s and 0.8 s with keys
// at 30 Hz, at the ticks of several rates and at random times (0), beside the textbook's way in the same binary: `ratio`
// is how many times longer that takes.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <random>
#include <vector>

#include "lib/math/slerp.h"
#include "lib/pose/pose.h"
#include "lib/pose/sampled.h"
#include "meshsplit/motion.h"

namespace
{

using namespace claque;

constexpr uint32_t joint_count = 33, character_count = 1000;
constexpr double lengths_s[] = {1.1, 0.8};

void add_clip(model::Rig &rig, double length_s, std::mt19937 &random)
{
    std::uniform_real_distribution<float> real(-1, 1);
    const uint32_t keys = uint32_t(std::lround(length_s * 30)) + 1, first_time = uint32_t(rig.times.size());
    for (uint32_t k = 0; k < keys; ++k) rig.times.push_back(float(k) / 30);
    model::Clip clip;
    clip.first_channel = uint32_t(rig.channels.size()), clip.channel_count = joint_count;
    clip.duration_s = rig.times.back();
    for (uint32_t i = 0; i < joint_count; ++i) {
        model::Channel channel;
        channel.node = i, channel.path = model::Path::rotation, channel.component_count = 4;
        channel.first_time = first_time, channel.key_count = keys;
        channel.first_value = uint32_t(rig.values.size());
        rig.channels.push_back(channel);
        const double phase = real(random);
        for (uint32_t k = 0; k < keys; ++k) {
            const glm::quat q = math::unit_quat(1, 0.4 * std::sin(k * 0.19 + phase), 0.3 * std::cos(k * 0.19), 0.1);
            rig.values.insert(rig.values.end(), {q.x, q.y, q.z, q.w});
        }
    }
    rig.clips.push_back(clip);
    rig.clip_names.emplace_back("walk");
}

const model::Template &character()
{
    static model::Template tmpl(std::pmr::get_default_resource());
    if (!tmpl.rig.clips.empty()) return tmpl;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> real(-0.3f, 0.3f);
    for (uint32_t i = 0; i < joint_count; ++i) {
        tmpl.rig.parents.push_back(i == 0 ? model::none : (i - 1) / 2);
        math::Trs trs;
        trs.translation = glm::vec3(real(random), real(random), real(random));
        tmpl.rig.rest.push_back(trs);
        tmpl.rig.node_names.emplace_back("");
        tmpl.rig.palette.push_back({i, math::affine_of(trs)});
    }
    for (const double length_s : lengths_s) add_clip(tmpl.rig, length_s, random);
    model::check(tmpl.rig);
    tmpl.levels.emplace_back(std::pmr::get_default_resource());
    // So tight that every clip keeps the rate of its keys.
    meshsplit::make_motion({0.001f, 0.01f}, tmpl);
    return tmpl;
}

constexpr uint64_t tick_count = 64;

// Times of everybody's next ticks, found before anything is measured; rate 0: at random.
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
                    times_[index(tick, c, clip)] = std::fmod(t + c * 0.0137, lengths_s[clip]);
                }
    }
    double at(uint64_t tick, uint32_t character, int clip) const { return times_[index(tick, character, clip)]; }

private:
    static size_t index(uint64_t tick, uint32_t character, int clip)
    {
        return 2 * (tick % tick_count * character_count + character) + size_t(clip);
    }
    std::vector<double> times_;
};

// The textbook: a linear search for the key, the C library's acos and sin, 4 x 4 matrices.
class Textbook
{
public:
    Textbook() : rig_(character().rig), globals_(joint_count), palettes_(character_count * joint_count)
    {
        for (const model::PaletteEntry &entry : rig_.palette) binds_.push_back(math::mat4_of(entry.inverse_bind));
    }

    void run(const Times &times, uint64_t tick, int clips)
    {
        for (uint32_t c = 0; c < character_count; ++c)
            for (uint32_t i = 0; i < joint_count; ++i) {
                glm::quat q = sample(i, float(times.at(tick, c, 0)));
                if (clips > 1) q = glm::slerp(q, sample(joint_count + i, float(times.at(tick, c, 1))), 0.4f);
                glm::mat4 local = glm::mat4_cast(q);
                local[3] = glm::vec4(rig_.rest[i].translation, 1);
                globals_[i] = rig_.parents[i] == model::none ? local : globals_[rig_.parents[i]] * local;
                palettes_[c * joint_count + i] = globals_[i] * binds_[i];
            }
        benchmark::ClobberMemory();
    }

private:
    glm::quat sample(uint32_t index, float time) const
    {
        const model::Channel &channel = rig_.channels[index];
        const float *times = rig_.times.data() + channel.first_time;
        uint32_t k = 0;
        while (k + 2 < channel.key_count && times[k + 1] <= time) ++k;
        const float f = (time - times[k]) / (times[k + 1] - times[k]);
        const float *v = rig_.values.data() + channel.first_value + 4 * k;
        return glm::slerp(glm::quat(v[3], v[0], v[1], v[2]), glm::quat(v[7], v[4], v[5], v[6]), f);
    }

    const model::Rig &rig_;
    std::vector<glm::mat4> globals_, palettes_, binds_;
};

double cpu_ns()
{
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e9 * double(now.tv_sec) + double(now.tv_nsec);
}

double ns_per_joint_of_textbook(const Times &times, int clips)
{
    Textbook book;
    book.run(times, 0, clips);
    double best = 1e300;
    for (uint64_t tick = 1; tick < 12; ++tick) {
        const double start = cpu_ns();
        book.run(times, tick, clips);
        best = std::min(best, (cpu_ns() - start) / (character_count * joint_count));
    }
    return best;
}

void count(benchmark::State &state, double textbook_ns = 0)
{
    const double joints = double(state.iterations()) * character_count * joint_count;
    state.counters["ns/joint"] =
        benchmark::Counter(joints * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    if (textbook_ns > 0)
        state.counters["ratio"] = benchmark::Counter(joints * 1e-9 * textbook_ns, benchmark::Counter::kIsRate);
}

bool can_run(benchmark::State &state, math::Kernel kernel)
{
    if (math::can_run(kernel)) return true;
    state.SkipWithError("this processor cannot run it");
    return false;
}

enum class Source { rows, channels };

// Clips to palette, blended where there are two.
void pose_palette(benchmark::State &state, math::Kernel kernel, Source source, int clips)
{
    if (!can_run(state, kernel)) return;
    const model::Template &tmpl = character();
    pose::Workspace workspace(tmpl.rig, source == Source::rows ? &tmpl.motion : nullptr);
    std::vector<math::Affine> palettes(character_count * joint_count + 1);
    pose::PoseJob job = workspace.job();
    job.kernel = kernel;
    job.clip = 0;
    pose::Layer layers[2];
    layers[0].clip = 0, layers[1].clip = 1, layers[1].weight = 0.4f;
    if (clips > 1) job.layers = {layers, 2};
    uint64_t tick = 0;
    const Times times(state.range(0));
    for (auto _ : state) {
        for (uint32_t c = 0; c < character_count; ++c) {
            job.time_s = layers[0].time_s = times.at(tick, c, 0);
            if (clips > 1) layers[1].time_s = times.at(tick, c, 1);
            job.palette = {palettes.data() + c * joint_count, joint_count};
            job.run();
        }
        ++tick;
        benchmark::ClobberMemory();
    }
    count(state, ns_per_joint_of_textbook(times, clips));
}

// Two rows to rotations, no more.
void sample(benchmark::State &state, math::Kernel kernel)
{
    if (!can_run(state, kernel)) return;
    const model::Template &tmpl = character();
    std::vector<float> scratch(pose::sampled_floats(tmpl.motion));
    pose::Sampler sampler(tmpl.rig, tmpl.motion, kernel, scratch.data());
    const Times times(state.range(0));
    uint64_t tick = 0;
    for (auto _ : state) {
        for (uint32_t c = 0; c < character_count; ++c) {
            sampler.sample(0, times.at(tick, c, 0));
            benchmark::ClobberMemory();
        }
        ++tick;
    }
    count(state);
}

// What the steps after sampling take.
void step(benchmark::State &state, math::Kernel kernel, int which)
{
    if (!can_run(state, kernel)) return;
    const model::Template &tmpl = character();
    const model::Motion &motion = tmpl.motion;
    const pose::Steps &steps = pose::steps_of(kernel);
    std::vector<float> rotations(motion.rest_rotations.begin(), motion.rest_rotations.end()), others = rotations;
    std::vector<math::Columns> columns(joint_count);
    std::vector<math::Affine> palettes(character_count * joint_count + 1);
    const pose::JointPlaces places = {motion.nodes.data(), motion.rest_scales.data(), motion.rest_offsets.data(),
                                      motion.block_count()};
    steps.place(rotations.data(), places, columns.data());
    for (auto _ : state)
        for (uint32_t c = 0; c < character_count; ++c) {
            if (which == 0) steps.replace(rotations.data(), others.data(), {0.4f, nullptr}, motion.block_count());
            if (which == 1) steps.place(rotations.data(), places, columns.data());
            if (which == 2) steps.chain(tmpl.rig.parents.data(), nullptr, joint_count, columns.data());
            if (which == 3)
                steps.fill(tmpl.rig.palette.data(), nullptr, joint_count, columns.data(),
                           palettes.data() + c * joint_count);
            if (which == 2 && c % 8 == 7) steps.place(rotations.data(), places, columns.data());
            benchmark::ClobberMemory();
        }
    count(state);
}

void textbook(benchmark::State &state, int clips)
{
    Textbook book;
    const Times times(state.range(0));
    uint64_t tick = 0;
    for (auto _ : state) book.run(times, tick++, clips);
    count(state);
}

void at_rates(benchmark::internal::Benchmark *b)
{
    for (const int rate : {60, 25, 10, 4, 0}) b->Arg(rate);
    b->ArgName("Hz")->Unit(benchmark::kMicrosecond);
}

using math::Kernel;
BENCHMARK_CAPTURE(sample, 256, Kernel::wide)->Apply(at_rates);
BENCHMARK_CAPTURE(sample, 128, Kernel::vector)->Apply(at_rates);
BENCHMARK_CAPTURE(step, blend_256, Kernel::wide, 0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, blend_128, Kernel::vector, 0)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, locals_256, Kernel::wide, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, locals_128, Kernel::vector, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, chain_256, Kernel::wide, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, chain_128, Kernel::vector, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, palette_256, Kernel::wide, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(step, palette_128, Kernel::vector, 3)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(pose_palette, one_clip_256, Kernel::wide, Source::rows, 1)->Apply(at_rates);
BENCHMARK_CAPTURE(pose_palette, one_clip_128, Kernel::vector, Source::rows, 1)->Apply(at_rates);
BENCHMARK_CAPTURE(pose_palette, one_clip_exact, Kernel::wide, Source::channels, 1)->Apply(at_rates);
BENCHMARK_CAPTURE(pose_palette, two_clips_256, Kernel::wide, Source::rows, 2)->Apply(at_rates);
BENCHMARK_CAPTURE(pose_palette, two_clips_128, Kernel::vector, Source::rows, 2)->Apply(at_rates);
BENCHMARK_CAPTURE(pose_palette, two_clips_scalar, Kernel::scalar, Source::rows, 2)->Apply(at_rates);
BENCHMARK_CAPTURE(pose_palette, two_clips_exact, Kernel::wide, Source::channels, 2)->Apply(at_rates);
BENCHMARK_CAPTURE(textbook, one_clip, 1)->Apply(at_rates);
BENCHMARK_CAPTURE(textbook, two_clips, 2)->Apply(at_rates);

}  // namespace
