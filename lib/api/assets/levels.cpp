// Levels of detail of an asset, and their measures.
#include <claque/levels.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lib/api/assets/asset_handle.h"
#include "lib/api/boundary.h"
#include "lib/lod/chain.h"
#include "lib/lod/surface/area_fractions.h"

using namespace claque;

namespace
{

// The context's tasks, in the form that libclaque lends to other libraries.
base::Jobs jobs_of(clq_context *context)
{
    clq_tasks tasks{};
    tasks.user = context;
    tasks.run = [](void *user, uint32_t count, void (*job)(void *, uint32_t), void *job_data) {
        clq_context_run(static_cast<clq_context *>(user), count, job, job_data);
    };
    return base::Jobs(tasks);
}

lod::ChainOptions options_of(clq_context *context, const clq_levels_def &def)
{
    lod::ChainOptions options;
    options.jobs = jobs_of(context);
    api::require_array(def.targets, def.target_count, "targets");
    options.targets.assign(def.targets, def.targets + def.target_count);
    api::require(std::isfinite(def.tolerance_px) && def.tolerance_px > 0, "tolerance_px is not above 0");
    api::require(std::isfinite(def.metres_per_unit) && def.metres_per_unit > 0, "metres_per_unit is not above 0");
    options.tolerance_px = double(def.tolerance_px);
    options.metres_per_unit = double(def.metres_per_unit);
    options.proxy_max_triangles = def.proxy_max_triangles;
    options.quadric_only = def.quadric_only;
    return options;
}

// Says in the log that levels begin to be made, which may take seconds, and at the end how many there are. Nothing is
// allocated once the model has changed.
std::vector<lod::LevelReport> made_with_notes(clq_context *context, model::Model &model,
                                              const lod::ChainOptions &options)
{
    const auto note = [&](const char *what, size_t count) {
        char text[256];
        std::snprintf(text, sizeof text, "levels of detail of '%.100s': %s %zu", model.name.c_str(), what, count);
        clq_context_log(context, CLQ_LOG_INFO, text);
    };
    size_t triangles = 0;
    for (const model::Part &part : model.parts) triangles += part.hidden ? 0 : model::triangles_of(part).size();
    note("making them; triangles:", triangles);
    std::vector<lod::LevelReport> levels;
    try {
        levels = lod::make_chain(model, options);
    } catch (...) {
        note("made:", 0);
        throw;
    }
    note("made:", levels.size());
    return levels;
}

clq_level_report made(const lod::LevelReport &level)
{
    clq_level_report out = clq_level_report_init();
    out.lod_min_m = static_cast<float>(level.distance_m);
    out.triangle_count = static_cast<uint32_t>(level.triangles);
    out.vertex_count = static_cast<uint32_t>(level.vertices);
    out.error_m = static_cast<float>(level.error_m);
    out.rest_max_m = static_cast<float>(level.deviation.rest_max_m);
    out.rest_rms_m = static_cast<float>(level.deviation.rest_rms_m);
    out.posed_max_m = static_cast<float>(level.deviation.posed_max_m);
    out.posed_rms_m = static_cast<float>(level.deviation.posed_rms_m);
    out.wrong_zone = static_cast<float>(level.deviation.wrong_zone);
    out.open_edges = static_cast<uint32_t>(level.deviation.open_edges);
    out.flipped_uvs = static_cast<uint32_t>(level.flipped);
    out.zone_area_error = static_cast<float>(level.zone_area_error);
    return out;
}

}  // namespace

extern "C" clq_status clq_asset_make_levels(clq_context *context, clq_asset *asset, const clq_levels_def *def,
                                            uint32_t *out_count)
{
    return api::boundary("clq_asset_make_levels", [&] {
        api::require(context && asset, "context or asset is NULL");
        const clq_levels_def wanted = api::read_def(def, clq_levels_def_init, "clq_levels_def_init");
        asset->levels = made_with_notes(context, asset->model, options_of(context, wanted));
        if (out_count) *out_count = static_cast<uint32_t>(asset->levels.size());
    });
}

extern "C" clq_status clq_asset_get_level_report(const clq_asset *asset, uint32_t level, clq_level_report *out)
{
    return api::boundary("clq_asset_get_level_report", [&] {
        api::require(asset && out, "asset or out is NULL");
        api::require_size(*out, "clq_level_report_init");
        if (level >= asset->levels.size())
            base::fail(CLQ_ARGUMENT, "level %u does not exist: for '%s' %zu were made", level,
                       asset->model.name.c_str(), asset->levels.size());
        api::write_out(out, made(asset->levels[level]));
    });
}

extern "C" clq_status clq_asset_get_zone_areas(const clq_asset *asset, float distance_m, float *out, uint32_t capacity,
                                               uint32_t *out_count)
{
    return api::boundary("clq_asset_get_zone_areas", [&] {
        api::require(asset != nullptr, "asset is NULL");
        api::require(std::isfinite(distance_m) && distance_m >= 0, "distance_m is below 0");
        api::require_array(out, capacity, "out");
        std::vector<const model::Part *> shown;
        for (const model::Part &part : asset->model.parts)
            if (!part.hidden && part.lod_min_m <= distance_m && distance_m < part.lod_max_m) shown.push_back(&part);
        const std::vector<double> fractions = lod::zone_area_fractions(asset->model, shown);
        for (size_t i = 0; i < std::min<size_t>(capacity, fractions.size()); ++i)
            out[i] = static_cast<float>(fractions[i]);
        if (out_count) *out_count = static_cast<uint32_t>(fractions.size());
    });
}

extern "C" const char *clq_asset_get_zone_name(const clq_asset *asset, uint32_t zone)
{
    return asset && zone < asset->model.zones.size() ? asset->model.zones[zone].name.c_str() : "";
}
