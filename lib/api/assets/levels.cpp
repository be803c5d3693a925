#include <claque/levels.h>

#include <algorithm>
#include <cmath>

#include "lib/api/assets/asset_handle.h"
#include "lib/api/boundary.h"
#include "lib/lod/chain.h"
#include "lib/lod/shares.h"

using namespace claque;

namespace
{

// What the context spreads over, as libclaque lends it to other libraries.
base::Jobs jobs_of(clq_context *context)
{
    clq_tasks tasks{};
    tasks.user = context;
    tasks.run = [](void *user, uint32_t count, void (*job)(void *, uint32_t), void *job_data) {
        clq_context_run(static_cast<clq_context *>(user), count, job, job_data);
    };
    return base::Jobs(tasks);
}

lod::ChainWish wish_of(clq_context *context, const clq_levels_def &def)
{
    lod::ChainWish wish;
    wish.jobs = jobs_of(context);
    api::require_array(def.targets, def.target_count, "targets");
    wish.targets.assign(def.targets, def.targets + def.target_count);
    api::require(std::isfinite(def.tolerance_px) && def.tolerance_px > 0, "tolerance_px is not above 0");
    api::require(std::isfinite(def.metres_per_unit) && def.metres_per_unit > 0, "metres_per_unit is not above 0");
    wish.tolerance_px = double(def.tolerance_px);
    wish.metres_per_unit = double(def.metres_per_unit);
    wish.far_from = def.far_from;
    wish.plain = def.plain != 0;
    return wish;
}

clq_made_level made(const lod::ChainLevel &level)
{
    clq_made_level out;
    out.first_m = static_cast<float>(level.first_m);
    out.triangle_count = static_cast<uint32_t>(level.triangles);
    out.vertex_count = static_cast<uint32_t>(level.vertices);
    out.error_m = static_cast<float>(level.error_m);
    out.rest_max_m = static_cast<float>(level.deviation.rest_m);
    out.rest_rms_m = static_cast<float>(level.deviation.rest_rms_m);
    out.posed_max_m = static_cast<float>(level.deviation.posed_m);
    out.posed_rms_m = static_cast<float>(level.deviation.posed_rms_m);
    out.wrong_zone = static_cast<float>(level.deviation.wrong_zone);
    out.open_edges = static_cast<uint32_t>(level.deviation.open_edges);
    out.flipped_uvs = static_cast<uint32_t>(level.flipped);
    out.zone_drift = static_cast<float>(level.zone_drift);
    return out;
}

}  // namespace

extern "C" clq_status clq_asset_make_levels(clq_context *context, clq_asset *asset, const clq_levels_def *def,
                                            clq_made_level *out, uint32_t capacity, uint32_t *count)
{
    return api::boundary("clq_asset_make_levels", [&] {
        api::require(context && asset, "context or asset is NULL");
        api::require_array(out, capacity, "out");
        api::require_size(def, "clq_levels_def_init");
        const std::vector<lod::ChainLevel> levels =
            lod::make_chain(asset->model, wish_of(context, def ? *def : clq_levels_def_init()));
        for (size_t i = 0; i < std::min<size_t>(capacity, levels.size()); ++i) out[i] = made(levels[i]);
        if (count) *count = static_cast<uint32_t>(levels.size());
    });
}

extern "C" clq_status clq_asset_zone_shares(const clq_asset *asset, float distance_m, float *out, uint32_t capacity,
                                            uint32_t *count)
{
    return api::boundary("clq_asset_zone_shares", [&] {
        api::require(asset != nullptr, "asset is NULL");
        api::require(std::isfinite(distance_m) && distance_m >= 0, "distance_m is below 0");
        api::require_array(out, capacity, "out");
        std::vector<const model::Part *> shown;
        for (const model::Part &part : asset->model.parts)
            if (!part.hidden && part.lod_first_m <= distance_m && distance_m < part.lod_last_m) shown.push_back(&part);
        const std::vector<double> shares = lod::zone_shares(asset->model, shown);
        for (size_t i = 0; i < std::min<size_t>(capacity, shares.size()); ++i) out[i] = static_cast<float>(shares[i]);
        if (count) *count = static_cast<uint32_t>(shares.size());
    });
}

extern "C" const char *clq_asset_get_zone_name(const clq_asset *asset, uint32_t zone)
{
    return asset && zone < asset->model.zones.size() ? asset->model.zones[zone].name.c_str() : "";
}
