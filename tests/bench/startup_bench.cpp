// The cost of a template before the first frame (goal: 0.5 s for about 1040 triangles, eight levels of detail, split,
// spheres of all clips): the steps of a first start on one thread and on two, and a second start, from a prepared file
// in memory. Then levels of characters that are larger.
#include <claque/claque.h>
#include <claque/levels.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "tests/support/written_armour.h"

namespace
{

// S1 6: eight levels; the source mesh is the first.
constexpr uint32_t s1_targets[] = {934, 839, 753, 676, 607, 545, 490};

void check(clq_status status)
{
    if (status == CLQ_OK) return;
    std::fprintf(stderr, "%s\n", clq_last_error());
    std::abort();
}

// The calling thread and one more, created for each loop: there are only a few dozen loops.
void run_on_two(void *, uint32_t count, void (*job)(void *, uint32_t), void *data)
{
    std::atomic<uint32_t> next{0};
    const auto work = [&] {
        for (uint32_t i = next++; i < count; i = next++) job(data, i);
    };
    std::thread other(work);
    work();
    other.join();
}

clq_context *new_context(bool two_threads)
{
    clq_context_def def = clq_context_def_init();
    if (two_threads) def.tasks.run = run_on_two;
    clq_context *out = nullptr;
    check(clq_context_create(&def, &out));
    return out;
}

enum class Threads { one, two };

clq_context *context(Threads threads = Threads::one)
{
    static clq_context *const one = new_context(false), *const two = new_context(true);
    return threads == Threads::one ? one : two;
}

// A built-in character, or a written one of "PLATES plates, TRIANGLES triangles".
clq_asset *figure(const std::string &name)
{
    clq_asset *asset = nullptr;
    unsigned plates = 0, triangles = 0;
    if (std::sscanf(name.c_str(), "%u plates, %u triangles", &plates, &triangles) == 2) {
        const std::vector<uint8_t> file = claque::testing::written_armour(plates, triangles);
        check(clq_asset_load(context(), file.data(), file.size(), nullptr, &asset));
        return asset;
    }
    check(clq_asset_builtin(context(), name.c_str(), &asset));
    return asset;
}

enum class Levels { none, s1, usual };

void give_levels(clq_asset *asset, Levels levels, Threads threads = Threads::one)
{
    if (levels == Levels::none) return;
    clq_levels_def def = clq_levels_def_init();
    if (levels == Levels::s1) def.targets = s1_targets, def.target_count = 7;
    check(clq_asset_make_levels(context(threads), asset, &def, nullptr));
}

clq_template *split(const clq_asset *asset, Threads threads = Threads::one)
{
    clq_template *tmpl = nullptr;
    check(clq_asset_build(context(threads), asset, 0, &tmpl));
    return tmpl;
}

void startup_split(benchmark::State &state, const char *name, Levels levels, Threads threads)
{
    clq_asset *asset = figure(name);
    give_levels(asset, levels);
    for (auto _ : state) clq_template_destroy(split(asset, threads));
    clq_asset_destroy(asset);
}

enum class Until { levels, split };

// From a finished character up to and including `until`.
void startup(benchmark::State &state, const char *name, Levels levels, Threads threads, Until until)
{
    for (auto _ : state) {
        state.PauseTiming();
        clq_asset *asset = figure(name);
        state.ResumeTiming();
        give_levels(asset, levels, threads);
        clq_template *tmpl = until == Until::split ? split(asset, threads) : nullptr;
        state.PauseTiming();
        clq_template_destroy(tmpl);
        clq_asset_destroy(asset);
        state.ResumeTiming();
    }
}

void startup_levels(benchmark::State &state, const char *name, Levels levels, Threads threads)
{
    startup(state, name, levels, threads, Until::levels);
}

void startup_first(benchmark::State &state, const char *name, Levels levels, Threads threads)
{
    startup(state, name, levels, threads, Until::split);
}

int append(void *user, const void *bytes, size_t size_bytes)
{
    const uint8_t *from = static_cast<const uint8_t *>(bytes);
    std::vector<uint8_t> &file = *static_cast<std::vector<uint8_t> *>(user);
    file.insert(file.end(), from, from + size_bytes);
    return 0;
}

void startup_prepared(benchmark::State &state, const char *name, Levels levels)
{
    clq_asset *asset = figure(name);
    give_levels(asset, levels);
    clq_template *tmpl = split(asset);
    std::vector<uint8_t> file;
    check(clq_template_save(tmpl, append, &file));
    clq_template_destroy(tmpl);
    clq_asset_destroy(asset);
    for (auto _ : state) {
        check(clq_template_load(context(), file.data(), file.size(), &tmpl));
        clq_template_destroy(tmpl);
    }
    state.counters["bytes"] = double(file.size());
}

void startup_figure(benchmark::State &state, const char *name)
{
    for (auto _ : state) clq_asset_destroy(figure(name));
}

#define STARTUP(step, ...) \
    BENCHMARK_CAPTURE(step, __VA_ARGS__)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime()

STARTUP(startup_figure, citizen, "citizen");
STARTUP(startup_levels, citizen_in_8, "citizen", Levels::s1, Threads::one);
STARTUP(startup_levels, citizen_in_8_two_threads, "citizen", Levels::s1, Threads::two);
STARTUP(startup_split, citizen_in_8, "citizen", Levels::s1, Threads::one);
STARTUP(startup_split, citizen_in_8_two_threads, "citizen", Levels::s1, Threads::two);
STARTUP(startup_first, citizen_in_8, "citizen", Levels::s1, Threads::one);
STARTUP(startup_first, citizen_in_8_two_threads, "citizen", Levels::s1, Threads::two);
STARTUP(startup_prepared, citizen_in_8, "citizen", Levels::s1);
STARTUP(startup_first, citizen_in_13, "citizen", Levels::usual, Threads::one);
STARTUP(startup_first, citizen_in_13_two_threads, "citizen", Levels::usual, Threads::two);
STARTUP(startup_first, patrician_in_13, "patrician", Levels::usual, Threads::one);
STARTUP(startup_first, plebeian_in_13, "plebeian", Levels::usual, Threads::one);
STARTUP(startup_first, decurion_in_13, "decurion", Levels::usual, Threads::one);
STARTUP(startup_prepared, citizen_in_13, "citizen", Levels::usual);
// How the time of levels grows with triangles and materials (docs/levels.md).
STARTUP(startup_levels, armour_1_plate_7000_triangles, "1 plates, 7000 triangles", Levels::usual, Threads::two);
STARTUP(startup_levels, armour_60_plates_7000_triangles, "60 plates, 7000 triangles", Levels::usual, Threads::two);
STARTUP(startup_levels, armour_1_plate_50000_triangles, "1 plates, 50000 triangles", Levels::usual, Threads::two);
STARTUP(startup_levels, armour_60_plates_62000_triangles, "60 plates, 62000 triangles", Levels::usual, Threads::two);

}  // namespace
