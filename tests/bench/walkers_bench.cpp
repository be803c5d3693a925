// How many people of libclaque-stage walk in a step: ways by Detour, bodies apart, pieces of tracks.
#include <claque/assets.h>
#include <claque/navigation.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include <benchmark/benchmark.h>

namespace
{

// A hall with pillars, of so many square metres a person, in which each walks from goal to goal.
class Hall
{
public:
    Hall(uint32_t people, double area_m2, bool pieces)
    {
        side_ = std::sqrt(area_m2 * people);
        const double vertices[] = {0, 0, 0, 0, 0, side_, side_, 0, side_, side_, 0, 0};
        const uint32_t triangles[] = {0, 1, 2, 0, 2, 3};
        std::vector<std::vector<double>> outlines;
        for (double x = 4; x < side_ - 2; x += 8)
            for (double z = 4; z < side_ - 2; z += 8) outlines.push_back({x, z, x + 1, z, x + 1, z + 1, x, z + 1});
        std::vector<clq_prism> holes;
        for (const std::vector<double> &outline : outlines) holes.push_back({4, outline.data(), -1, 3});
        clq_navigation_def def = clq_navigation_def_init();
        def.vertices = vertices, def.vertex_count = 4, def.triangles = triangles, def.triangle_count = 2;
        def.holes = holes.data(), def.hole_count = static_cast<uint32_t>(holes.size());
        ok(clq_navigation_create(&def, &navigation_));
        if (pieces) make_locomotion();
        clq_walkers_def wanted = clq_walkers_def_init();
        wanted.max_count = people;
        ok(clq_walkers_create(navigation_, &wanted, &walkers_));
        clq_walker_def walker = clq_walker_def_init();
        walker.locomotion = locomotion_;
        for (uint32_t i = 0; i < people; ++i) {
            place(walker.position);
            walker.seed = i, walker.speed_m_s = static_cast<float>(1.1 + 0.5 * number());
            clq_walker made;
            ok(clq_walkers_add(walkers_, &walker, &made));
            ids_.push_back(made);
        }
    }
    ~Hall()
    {
        clq_walkers_destroy(walkers_);
        clq_navigation_destroy(navigation_);
        clq_locomotion_destroy(locomotion_);
        clq_template_destroy(citizen_);
        if (context_) ok(clq_context_destroy(context_));
    }
    Hall(const Hall &) = delete;
    Hall &operator=(const Hall &) = delete;

    // Those that have arrived are sent on, which is not timed. Returns the seconds that this thread computed: a step
    // has one thread, and other programs do not count.
    double step()
    {
        for (const clq_walker id : ids_) {
            clq_walker_info info = clq_walker_info_init();
            ok(clq_walkers_get_walker(walkers_, id, &info));
            if (info.state == CLQ_WALKER_WALKS || info.state == CLQ_WALKER_WAITS) continue;
            double goal[3];
            place(goal);
            ok(clq_walker_go(walkers_, id, goal, 1, 0));
        }
        const double begin_s = cpu_s();
        ok(clq_walkers_step(walkers_));
        return cpu_s() - begin_s;
    }

private:
    static double cpu_s()
    {
        timespec now;
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
        return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
    }
    static void ok(clq_status status)
    {
        if (status != CLQ_OK) std::fprintf(stderr, "%s\n", clq_last_error()), std::abort();
    }
    double number() { return double((bits_ = bits_ * 6364136223846793005u + 1442695040888963407u) >> 33) / (1u << 31); }
    void place(double out[3])
    {
        out[0] = 0.5 + (side_ - 1) * number(), out[1] = 0, out[2] = 0.5 + (side_ - 1) * number();
    }
    void make_locomotion()
    {
        ok(clq_context_create(nullptr, &context_));
        ok(clq_template_builtin(context_, "citizen", &citizen_));
        const uint32_t stand = clq_template_find_clip(citizen_, "stand");
        clq_locomotion_def walk = clq_locomotion_def_init();
        walk.tmpl = citizen_, walk.walk = clq_template_find_clip(citizen_, "walk");
        walk.run = clq_template_find_clip(citizen_, "jog"), walk.idle_count = 1, walk.idles = &stand;
        ok(clq_locomotion_create(context_, &walk, &locomotion_));
    }

    double side_ = 0;
    uint64_t bits_ = 1;
    clq_context *context_ = nullptr;
    clq_template *citizen_ = nullptr;
    clq_locomotion *locomotion_ = nullptr;
    clq_navigation *navigation_ = nullptr;
    clq_walkers *walkers_ = nullptr;
    std::vector<clq_walker> ids_;
};

// People, square metres for each, and whether pieces of tracks are made: the time of a step of 50 ms.
void walkers(benchmark::State &state)
{
    Hall hall(static_cast<uint32_t>(state.range(0)), double(state.range(1)), state.range(2) != 0);
    for (int i = 0; i < 100; ++i) hall.step();  // until they are under way
    std::vector<double> times;
    for (auto _ : state) {
        const double seconds = hall.step();
        times.push_back(seconds);
        state.SetIterationTime(seconds);
    }
    std::sort(times.begin(), times.end());
    state.counters["min_ms"] = 1e3 * times.front();
    state.counters["median_ms"] = 1e3 * times[times.size() / 2];
    state.counters["p99_ms"] = 1e3 * times[times.size() * 99 / 100];
}

}  // namespace

BENCHMARK(walkers)
    ->ArgsProduct({{250, 500, 1000}, {2, 5, 20}, {0, 1}})
    ->UseManualTime()
    ->Iterations(100)
    ->Unit(benchmark::kMillisecond);
