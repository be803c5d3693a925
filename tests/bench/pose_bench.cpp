// ns a joint for one clip to a matrix palette: 1000 characters of 33 joints in a clip of 1.1 s at 30 Hz, at the ticks
// of several rates and at random times, beside the textbook's way in the same binary.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "lib/math/slerp.h"
#include "lib/pose/pose.h"

namespace
{

using namespace claque;

constexpr uint32_t joint_count = 33, character_count = 1000;

model::Rig make_rig()
{
    model::Rig rig;
    std::mt19937 random(1);
    std::uniform_real_distribution<float> real(-1, 1);
    for (uint32_t i = 0; i < joint_count; ++i) {
        rig.parents.push_back(i == 0 ? model::none : (i - 1) / 2);
        math::Trs trs;
        trs.translation = glm::vec3(real(random), real(random), real(random));
        rig.rest.push_back(trs);
        rig.node_names.emplace_back("");
        rig.palette.push_back({i, math::affine_of(trs)});
    }
    const uint32_t keys = 34;
    for (uint32_t k = 0; k < keys; ++k) rig.times.push_back(float(k) / 30);
    for (uint32_t i = 0; i < joint_count; ++i) {
        model::Channel channel;
        channel.node = i;
        channel.path = model::Path::rotation;
        channel.component_count = 4;
        channel.key_count = keys;
        channel.first_value = uint32_t(rig.values.size());
        rig.channels.push_back(channel);
        const double phase = real(random);
        for (uint32_t k = 0; k < keys; ++k) {
            const glm::quat q = math::unit_quat(1, 0.4 * std::sin(k * 0.19 + phase), 0.3 * std::cos(k * 0.19), 0.1);
            rig.values.insert(rig.values.end(), {q.x, q.y, q.z, q.w});
        }
    }
    model::Clip clip;
    clip.channel_count = joint_count;
    clip.duration_s = rig.times.back();
    rig.clips.push_back(clip);
    rig.clip_names.emplace_back("walk");
    model::check(rig);
    return rig;
}

void count(benchmark::State &state)
{
    const double joints = double(state.iterations()) * character_count * joint_count;
    state.counters["ns/joint"] =
        benchmark::Counter(joints * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// Times of everybody's next tick; rate 0: at random.
double next_time(uint32_t character, uint64_t tick, int64_t rate)
{
    const double t = rate ? double(tick) / double(rate) : double((character * 7919 + tick * 104729) % 1000) * 0.0011;
    return std::fmod(t + character * 0.0137, 1.1);
}

void pose_palette(benchmark::State &state)
{
    const model::Rig rig = make_rig();
    std::vector<math::Trs> locals(joint_count);
    std::vector<math::Columns> globals(joint_count);
    std::vector<math::Affine> palettes(character_count * joint_count + 1);
    uint64_t tick = 0;
    for (auto _ : state) {
        for (uint32_t c = 0; c < character_count; ++c) {
            pose::PoseJob job;
            job.rig = &rig;
            job.clip = 0;
            job.time_s = next_time(c, tick, state.range(0));
            job.locals = base::Span<math::Trs>(locals);
            job.globals = base::Span<math::Columns>(globals);
            job.palette = {palettes.data() + c * joint_count, joint_count};
            job.run();
        }
        ++tick;
        benchmark::ClobberMemory();
    }
    count(state);
}

// A linear search for the key, the C library's acos and sin, 4 x 4 matrices.
void textbook(benchmark::State &state)
{
    const model::Rig rig = make_rig();
    std::vector<glm::mat4> globals(joint_count), palettes(character_count * joint_count);
    std::vector<glm::mat4> inverse_binds;
    for (const model::PaletteEntry &entry : rig.palette) inverse_binds.push_back(math::mat4_of(entry.inverse_bind));
    uint64_t tick = 0;
    for (auto _ : state) {
        for (uint32_t c = 0; c < character_count; ++c) {
            const float time = float(next_time(c, tick, state.range(0)));
            for (uint32_t i = 0; i < joint_count; ++i) {
                const model::Channel &channel = rig.channels[i];
                uint32_t k = 0;
                while (k + 2 < channel.key_count && rig.times[k + 1] <= time) ++k;
                const float f = (time - rig.times[k]) / (rig.times[k + 1] - rig.times[k]);
                const float *v = rig.values.data() + channel.first_value + 4 * k;
                const glm::quat q = glm::slerp(glm::quat(v[3], v[0], v[1], v[2]), glm::quat(v[7], v[4], v[5], v[6]), f);
                glm::mat4 local = glm::mat4_cast(q);
                local[3] = glm::vec4(rig.rest[i].translation, 1);
                globals[i] = rig.parents[i] == model::none ? local : globals[rig.parents[i]] * local;
                palettes[c * joint_count + i] = globals[i] * inverse_binds[i];
            }
        }
        ++tick;
        benchmark::ClobberMemory();
    }
    count(state);
}

BENCHMARK(pose_palette)->ArgName("Hz")->Arg(60)->Arg(25)->Arg(10)->Arg(4)->Arg(0)->Unit(benchmark::kMillisecond);
BENCHMARK(textbook)->ArgName("Hz")->Arg(60)->Arg(10)->Arg(0)->Unit(benchmark::kMillisecond);

}  // namespace
