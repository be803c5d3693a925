// The members of clq_crowd_def that a record keeps: not the host's clock, nor the budget of time that needs it.
#pragma once

#include <claque/crowd.h>

namespace claque::record
{

template <class A, class Def>
void walk_crowd_def(A &a, Def &def)
{
    a.value(def.cache), a.value(def.cache_budget_bytes);
    a.value(def.period_near_s), a.value(def.period_far_s), a.value(def.distance_near_m), a.value(def.distance_far_m);
    a.value(def.metres_per_unit), a.value(def.seed), a.value(def.cull), a.value(def.rigid_mode);
    a.value(def.lod_scale), a.value(def.lod_hysteresis), a.value(def.vertex_format), a.value(def.clock);
    a.value(def.update_budget);
    for (auto &band : def.key_poses.bands) a.value(band.distance_min_m), a.value(band.mode);
    a.value(def.key_poses.band_count), a.value(def.key_poses.rate_hz), a.value(def.key_poses.max_kept);
    a.value(def.key_poses.budget_bytes), a.value(def.motion_tolerance_px);
}

}  // namespace claque::record
