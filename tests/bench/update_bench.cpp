// A whole update on one core: individuals of 33 joints and 650 vertices of 2 influences, everybody due; and a crowd of
// which one in five is seen, at the rates of the law.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "lib/frame/frame.h"
#include "lib/math/slerp.h"
#include "tests/bench/body.h"

namespace
{

using namespace claque;

void add_rig(model::Rig &rig, std::mt19937 &random)
{
    std::uniform_real_distribution<float> real(-0.2f, 0.2f);
    const uint32_t joints = 33, keys = 34;
    for (uint32_t k = 0; k < keys; ++k) rig.times.push_back(float(k) / 30);
    for (uint32_t i = 0; i < joints; ++i) {
        rig.parents.push_back(i == 0 ? model::none : (i - 1) / 2);
        math::Trs trs;
        trs.translation = glm::vec3(real(random), real(random), real(random));
        rig.rest.push_back(trs);
        rig.node_names.emplace_back("");
        rig.palette.push_back({i, math::affine_of(trs)});
        model::Channel channel;
        channel.node = i;
        channel.path = model::Path::rotation;
        channel.component_count = 4;
        channel.key_count = keys;
        channel.first_value = uint32_t(rig.values.size());
        rig.channels.push_back(channel);
        for (uint32_t k = 0; k < keys; ++k) {
            const glm::quat q = math::unit_quat(1, 0.4 * std::sin(k * 0.19 + i), 0.3 * std::cos(k * 0.19), 0.1);
            rig.values.insert(rig.values.end(), {q.x, q.y, q.z, q.w});
        }
    }
    model::Clip clip;
    clip.channel_count = joints;
    clip.duration_s = rig.times.back();
    rig.clips.push_back(clip);
    rig.clip_names.emplace_back("walk");
}

std::unique_ptr<model::Template> make_template()
{
    auto out = std::make_unique<model::Template>(std::pmr::get_default_resource());
    std::mt19937 random(1);
    add_rig(out->rig, random);
    out->levels.push_back(bench::make_level(2));
    out->sklsroot.radius = 2;
    return out;
}

struct Scene {
    Scene(uint32_t count, double field_m, const frame::Settings &settings)
        : tmpl(make_template()),
          crowd(std::pmr::get_default_resource()),
          frame(std::pmr::get_default_resource(), settings),
          view(std::pmr::get_default_resource())
    {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> real(-field_m, field_m);
        for (uint32_t i = 0; i < count; ++i) {
            crowd::Place place;
            place.position = glm::dvec3(real(random), 0, real(random));
            crowd::Play play;
            play.clip = 0;
            play.phase_s = float(i) * 0.137f;
            crowd.create(*tmpl, place, play, i);
        }
    }
    void update(double time_s)
    {
        frame::View *views[1] = {&view};
        frame::update(crowd, frame, {views, 1}, time_s, base::Jobs());
    }
    std::unique_ptr<model::Template> tmpl;
    crowd::Crowd crowd;
    frame::Frame frame;
    frame::View view;
};

void everybody_due(benchmark::State &state)
{
    frame::Settings settings;
    settings.caches.period = {0, 0, 1, 2};
    Scene scene(1000, 50, settings);
    scene.view.camera = frame::look_at({0, 10, 120}, {0, 0, 0}, {0, 1, 0}, 1.2f, 1.5f, 0.1f, 1000);
    double t = 0;
    for (auto _ : state) scene.update(t += 0.0167);
    state.counters["individuals/ms"] = benchmark::Counter(
        double(state.iterations()) * scene.frame.stats().animated * 1e-3, benchmark::Counter::kIsRate);
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

// A crowd behind the eye, in as many groups as the second number says: what an actor out of view costs.
void out_of_view(benchmark::State &state)
{
    Scene scene(0, 1, frame::Settings());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> real(-300, 300);
    const int64_t groups = state.range(1);
    std::vector<crowd::Id> ids;
    for (int64_t g = 0; g < groups; ++g) ids.push_back(scene.crowd.create_group(crowd::Place()));
    for (int64_t i = 0; i < state.range(0); ++i) {
        crowd::Place place;
        place.position = glm::dvec3(real(random), 0, 900 + real(random));
        const crowd::Id id = scene.crowd.create(*scene.tmpl, place, crowd::Play(), uint64_t(i));
        if (groups) scene.crowd.join(id, ids[size_t(i % groups)], nullptr);
    }
    scene.view.camera = frame::look_at({0, 2, 0}, {0, 2, -1}, {0, 1, 0}, 0.9f, 1.5f, 0.1f, 1000);
    double t = 0;
    for (auto _ : state) scene.update(t += 0.0167);
    state.counters["ns/actor"] = benchmark::Counter(double(state.iterations()) * double(state.range(0)) * 1e-9,
                                                    benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

BENCHMARK(everybody_due)->Unit(benchmark::kMillisecond);
BENCHMARK(one_in_five_seen)->Arg(2000)->Arg(6000)->Unit(benchmark::kMillisecond);
BENCHMARK(out_of_view)
    ->Args({1000, 0})
    ->Args({10000, 0})
    ->Args({100000, 0})
    ->Args({100000, 100})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
