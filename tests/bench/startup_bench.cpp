// What a template costs before the first frame (SPEC 5: 0.5 s for about 1040 triangles, eight levels of detail, split, spheres of
// all clips): the steps of a first start, and a second one, from memory as a prepared file has it. One thread.
#include <claque/claque.h>
#include <claque/levels.h>

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace
{

// S1 6: eight levels, the figure itself the first of them.
constexpr uint32_t s1_targets[] = {934, 839, 753, 676, 607, 545, 490};

void check(clq_status status)
{
    if (status == CLQ_OK) return;
    std::fprintf(stderr, "%s\n", clq_last_error());
    std::abort();
}

clq_context *context()
{
    static clq_context *made = [] {
        clq_context_def def = clq_context_def_init();
        clq_context *out = nullptr;
        check(clq_context_create(&def, &out));
        return out;
    }();
    return made;
}

clq_asset *figure(const std::string &name)
{
    clq_asset *asset = nullptr;
    check(clq_asset_builtin(context(), name.c_str(), &asset));
    return asset;
}

enum class Levels { none, s1, usual };

void give_levels(clq_asset *asset, Levels levels)
{
    if (levels == Levels::none) return;
    clq_levels_def def = clq_levels_def_init();
    if (levels == Levels::s1) def.targets = s1_targets, def.target_count = 7;
    check(clq_asset_make_levels(context(), asset, &def, nullptr, 0, nullptr));
}

clq_template *split(const clq_asset *asset)
{
    clq_template *tmpl = nullptr;
    check(clq_asset_build(context(), asset, 0, &tmpl));
    return tmpl;
}

void startup_split(benchmark::State &state, const char *name, Levels levels)
{
    clq_asset *asset = figure(name);
    give_levels(asset, levels);
    for (auto _ : state) clq_template_destroy(split(asset));
    clq_asset_destroy(asset);
}

enum class Until { levels, split };

// From a figure that is there, as far as `until`.
void startup(benchmark::State &state, const char *name, Levels levels, Until until)
{
    for (auto _ : state) {
        state.PauseTiming();
        clq_asset *asset = figure(name);
        state.ResumeTiming();
        give_levels(asset, levels);
        clq_template *tmpl = until == Until::split ? split(asset) : nullptr;
        state.PauseTiming();
        clq_template_destroy(tmpl);
        clq_asset_destroy(asset);
        state.ResumeTiming();
    }
}

void startup_levels(benchmark::State &state, const char *name, Levels levels)
{
    startup(state, name, levels, Until::levels);
}

void startup_first(benchmark::State &state, const char *name, Levels levels)
{
    startup(state, name, levels, Until::split);
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
STARTUP(startup_levels, citizen_in_8, "citizen", Levels::s1);
STARTUP(startup_split, citizen_in_8, "citizen", Levels::s1);
STARTUP(startup_first, citizen_in_8, "citizen", Levels::s1);
STARTUP(startup_prepared, citizen_in_8, "citizen", Levels::s1);
STARTUP(startup_first, citizen_in_13, "citizen", Levels::usual);
STARTUP(startup_prepared, citizen_in_13, "citizen", Levels::usual);

}  // namespace
