// Questions to a scene and the work of keeping it, through the C API, in crowds of one person to four square metres:
// there are as many answers whatever the size of the crowd.
#include <algorithm>

#include "tests/bench/measure.h"
#include "tests/bench/scene_town.h"

namespace
{

using namespace scene_bench;

// One question; `answers` says how many answers it had on the average.
template <class Question>
void ask(benchmark::State &state, Kind kind, const Question &question)
{
    Town &t = town(state.range(0), kind);
    check(clq_scene_update(t.scene, 0));
    uint64_t answers = 0;
    for (auto _ : state) answers += question(t);
    state.counters["answers"] = double(answers) / double(state.iterations());
}

uint32_t room(const Town &t) { return uint32_t(t.hits.size()); }

void get_by_id(benchmark::State &state)
{
    size_t next = 0;
    ask(state, Kind::standing, [&](Town &t) {
        clq_scene_actor out = clq_scene_actor_init();
        check(clq_scene_get_actor(t.scene, t.actors[next = (next + 7919) % t.actors.size()], 0, &out));
        return 1u;
    });
}

void find_category(benchmark::State &state)
{
    clq_actor found[100];
    clq_scene_filter filter = clq_scene_filter_init();
    filter.all_of = 2, filter.tmpl = Town::citizen();
    ask(state, Kind::standing, [&](Town &t) {
        uint32_t count = 0;
        check(clq_scene_find(t.scene, &filter, found, 100, &count));
        return count;
    });
}

void find_keys(benchmark::State &state)
{
    clq_actor found[20];
    double low = 0;
    ask(state, Kind::standing, [&](Town &t) {
        uint32_t count = 0;
        low = std::fmod(low + 7919, double(t.actors.size() - 10));
        check(clq_scene_find_keys(t.scene, low, low + 9, nullptr, found, 20, &count));
        return count;
    });
}

void find_nearest(benchmark::State &state, Kind kind, double time_s)
{
    ask(state, kind, [=](Town &t) {
        uint32_t count = 0;
        check(clq_scene_find_nearest(t.scene, time_s, t.middle(), HUGE_VAL, nullptr, t.hits.data(), 8, &count));
        return count;
    });
}

void find_within(benchmark::State &state, Kind kind, double radius)
{
    ask(state, kind, [=](Town &t) {
        uint32_t count = 0;
        check(clq_scene_find_within(t.scene, 0, t.middle(), radius, nullptr, t.hits.data(), room(t), &count));
        return count;
    });
}

void find_in_box(benchmark::State &state)
{
    ask(state, Kind::standing, [](Town &t) {
        uint32_t count = 0;
        const double *at = t.middle(), low[3] = {at[0] - 4, -1, at[2] - 4}, high[3] = {at[0] + 4, 3, at[2] + 4};
        check(clq_scene_find_in_box(t.scene, 0, low, high, nullptr, t.hits.data(), room(t), &count));
        return count;
    });
}

void find_in_frustum(benchmark::State &state)
{
    ask(state, Kind::standing, [](Town &t) {
        uint32_t count = 0;
        check(clq_scene_find_in_frustum(t.scene, 0, &t.camera, nullptr, t.hits.data(), room(t), &count));
        return count;
    });
}

void find_on_ray(benchmark::State &state)
{
    ask(state, Kind::standing, [](Town &t) {
        uint32_t count = 0;
        const double *at = t.middle();
        const clq_ray ray = {{at[0], 1.2, at[2]}, {0.6, 0, -0.8}, 40};
        check(clq_scene_find_on_ray(t.scene, 0, &ray, nullptr, t.hits.data(), room(t), &count));
        return count;
    });
}

void pick_triangle(benchmark::State &state)
{
    check(clq_crowd_update(town(state.range(0)).crowd, 0, &town(state.range(0)).view, 1));
    Town &t = town(state.range(0));
    uint32_t met = 0, round = 0;
    for (auto _ : state) {
        clq_ray ray;
        clq_scene_pick pick = clq_scene_pick_init();
        const float x = float(++round % 200) / 100 - 1;
        check(clq_camera_get_ray(&t.camera, x, -0.1f, &ray));
        check(clq_scene_pick_triangle(t.scene, t.view, &ray, nullptr, &pick));
        met += pick.actor.index1 != 0;
    }
    state.counters["answers"] = double(met) / double(state.iterations());
}

// Updates alone, in processor time, without the calls that move people.
template <class Move, class Update>
void update(benchmark::State &state, Kind kind, const Move &move, const Update &update_scene)
{
    Town &t = town(state.range(0), kind);
    clq_scene_stats before = clq_scene_stats_init(), after = before;
    check(clq_scene_get_stats(t.scene, &before));
    for (auto _ : state) {
        move(t);
        const double start_ns = claque::bench::cpu_ns();
        update_scene(t);
        state.SetIterationTime(1e-9 * (claque::bench::cpu_ns() - start_ns));
    }
    check(clq_scene_get_stats(t.scene, &after));
    state.counters["placed"] = double(after.placed - before.placed) / double(state.iterations());
    state.counters["bytes/actor"] = double(after.bytes) / double(t.actors.size());
}

// Each step of `share` of all, at 1.4 m/s and 60 frames a second, back and forth over some metres.
void update_walk(benchmark::State &state, double share)
{
    uint32_t round = 0;
    update(
        state, Kind::standing,
        [&](Town &t) {
            const uint32_t count = uint32_t(share * double(t.actors.size()));
            const double step = ++round / 240 % 2 ? -1.4 / 60 : 1.4 / 60;
            for (uint32_t i = 0; i < count; ++i) t.places[i].position[0] += step;
            check(clq_crowd_set_transforms(t.crowd, t.actors.data(), t.places.data(), count));
        },
        [](Town &t) { check(clq_scene_update(t.scene, 0)); });
}

// Everyone to the place of another one.
void update_jump(benchmark::State &state)
{
    std::mt19937 random(3);
    update(
        state, Kind::standing,
        [&](Town &t) {
            std::shuffle(t.places.begin(), t.places.end(), random);
            check(clq_crowd_set_transforms(t.crowd, t.actors.data(), t.places.data(), uint32_t(t.actors.size())));
        },
        [](Town &t) { check(clq_scene_update(t.scene, 0)); });
}

void update_tracks(benchmark::State &state)
{
    double time_s = 0;
    update(
        state, Kind::walking, [&](Town &) { time_s = time_s > 9 ? 0 : time_s + 1.0 / 60; },
        [&](Town &t) { check(clq_scene_update(t.scene, time_s)); });
}

void make_scene(benchmark::State &state)
{
    clq_scene *made = nullptr;
    update(
        state, Kind::standing,
        [&](Town &) {
            if (made) check(clq_scene_destroy(made));
        },
        [&](Town &t) { check(clq_scene_create(t.crowd, &made)); });
    check(clq_scene_destroy(made));
}

double least(const std::vector<double> &all) { return *std::min_element(all.begin(), all.end()); }

void counts(benchmark::internal::Benchmark *b)
{
    b->ArgName("actors")->Arg(1000)->Arg(10000)->Arg(100000)->Repetitions(9)->ReportAggregatesOnly();
    b->ComputeStatistics("min", least)->Unit(benchmark::kMicrosecond);
}

void sizes(benchmark::internal::Benchmark *b)
{
    counts(b);
    b->MinTime(0.05);
}

void updates(benchmark::internal::Benchmark *b)
{
    counts(b);
    b->UseManualTime()->Iterations(60);
}

void rebuilds(benchmark::internal::Benchmark *b)
{
    counts(b);
    b->UseManualTime()->Iterations(3);
}

BENCHMARK(get_by_id)->Apply(sizes);
BENCHMARK(find_category)->Apply(sizes);
BENCHMARK(find_keys)->Apply(sizes);
BENCHMARK_CAPTURE(find_nearest, standing, Kind::standing, 0.0)->Apply(sizes);
BENCHMARK_CAPTURE(find_nearest, on_tracks, Kind::walking, 0.0)->Apply(sizes);
BENCHMARK_CAPTURE(find_nearest, on_tracks_a_second_ahead, Kind::walking, 1.0)->Apply(sizes);
BENCHMARK_CAPTURE(find_within, 3_m, Kind::standing, 3.0)->Apply(sizes);
BENCHMARK_CAPTURE(find_within, 30_m, Kind::standing, 30.0)->Apply(sizes);
BENCHMARK(find_in_box)->Apply(sizes);
BENCHMARK(find_in_frustum)->Apply(sizes);
BENCHMARK(find_on_ray)->Apply(sizes);
BENCHMARK(pick_triangle)->Apply(sizes);
BENCHMARK_CAPTURE(update_walk, a_hundredth, 0.01)->Apply(updates);
BENCHMARK_CAPTURE(update_walk, all, 1.0)->Apply(updates);
BENCHMARK(update_tracks)->Apply(updates);
BENCHMARK(update_jump)->Apply(rebuilds);
BENCHMARK(make_scene)->Apply(rebuilds);

}  // namespace
