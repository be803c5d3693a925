#include "lib/api/key_poses.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "animcache/keypose_choice.h"
#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"

using namespace claque;

namespace claque::api
{

animcache::KeyPoseSettings settings_of(const clq_key_poses &wanted, float metres_per_unit)
{
    static_assert(CLQ_KEY_POSE_BAND_MAX == animcache::max_key_pose_bands, "the C API shows every band");
    if (wanted.band_count > CLQ_KEY_POSE_BAND_MAX)
        base::fail(CLQ_ARGUMENT, "key_poses has %u bands: %d at most", wanted.band_count, CLQ_KEY_POSE_BAND_MAX);
    if (!(wanted.rate_hz >= 0.5f && wanted.rate_hz <= 120))
        base::fail(CLQ_ARGUMENT, "key_poses.rate_hz is %g: 0.5 to 120 is wanted", static_cast<double>(wanted.rate_hz));
    animcache::KeyPoseSettings out;
    for (uint32_t i = 0; i < wanted.band_count; ++i) {
        const clq_key_pose_band &band = wanted.bands[i];
        if (number_of(band.mode) > CLQ_KEY_POSE_SKINNED)
            base::fail(CLQ_ARGUMENT,
                       "key_poses.bands[%u].mode is %u: none of CLQ_KEY_POSE_INDIVIDUAL to "
                       "CLQ_KEY_POSE_SKINNED",
                       i, static_cast<unsigned>(number_of(band.mode)));
        if (!(band.distance_min_m >= 0) || !std::isfinite(band.distance_min_m) ||
            (i > 0 && !(band.distance_min_m > wanted.bands[i - 1].distance_min_m)))
            base::fail(CLQ_ARGUMENT,
                       "key_poses.bands[%u].distance_min_m is %g: 0 or more, and more than that of the band before", i,
                       static_cast<double>(band.distance_min_m));
        out.bands[i] = {band.distance_min_m / metres_per_unit, static_cast<animcache::KeyPoseMode>(band.mode)};
    }
    out.band_count = wanted.band_count;
    out.rate_hz = wanted.rate_hz;
    out.max_kept = wanted.max_kept;
    if (wanted.budget_bytes) out.budget_bytes = wanted.budget_bytes;
    return out;
}

}  // namespace claque::api

extern "C" clq_status clq_crowd_get_key_pose_stats(const clq_crowd *crowd, clq_key_pose_stats *out)
{
    return api::boundary("clq_crowd_get_key_pose_stats", [&] {
        api::require(crowd && out, "crowd or out is NULL");
        api::require_size(*out, "clq_key_pose_stats_init");
        const api::Reading reading(crowd);
        const animcache::KeyPoseCounters &counters = crowd->frame.stats().key_poses;
        clq_key_pose_stats stats = clq_key_pose_stats_init();
        stats.requested = counters.requested, stats.served = counters.served;
        stats.wanted = counters.wanted, stats.updated = counters.updated;
        stats.held = counters.held, stats.bytes = counters.bytes;
        api::write_out(out, stats);
    });
}

extern "C" clq_status clq_key_poses_choose(const clq_key_pose_bin *bins, uint32_t bin_count, uint32_t max_kept,
                                           bool *out_chosen, uint32_t pose_count)
{
    return api::boundary("clq_key_poses_choose", [&] {
        api::require((bins || bin_count == 0) && (out_chosen || pose_count == 0), "bins or out_chosen is NULL");
        std::vector<animcache::KeyPoseBin> wanted;
        wanted.reserve(bin_count);
        for (uint32_t i = 0; i < bin_count; ++i) {
            if (bins[i].first >= pose_count || bins[i].second >= pose_count)
                base::fail(CLQ_ARGUMENT, "bin %u asks for key-poses %u and %u: there are %u", i, bins[i].first,
                           bins[i].second, pose_count);
            wanted.push_back({bins[i].first, bins[i].second, bins[i].count});
        }
        std::vector<uint8_t> chosen(pose_count, uint8_t(0));
        animcache::KeyPoseChoice choice(std::pmr::get_default_resource(), pose_count, bin_count);
        choice.choose(wanted.data(), bin_count, max_kept, nullptr, chosen.data());
        for (uint32_t i = 0; i < pose_count; ++i) out_chosen[i] = chosen[i] != 0;
    });
}
