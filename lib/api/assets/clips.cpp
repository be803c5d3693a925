// Clips of one asset for another.
#include <claque/assets.h>

#include "lib/api/assets/asset_handle.h"
#include "lib/api/boundary.h"
#include "lib/retarget/retarget.h"

using namespace claque;

namespace
{

template <class To, class From>
To enum_of(const From &value, unsigned count, const char *what)
{
    const unsigned number = api::number_of(value);
    if (number >= count) base::fail(CLQ_ARGUMENT, "%s is %u: 0 to %u are known", what, number, count - 1);
    return static_cast<To>(number);
}

retarget::Options options_of(const clq_clips_def &def)
{
    retarget::Options out;
    api::require_array(def.joints, def.joint_count, "joints");
    for (uint32_t i = 0; i < def.joint_count; ++i) {
        const clq_joint_pair &pair = def.joints[i];
        api::require(pair.source && pair.target, "a joint's source or target is NULL");
        out.joints.push_back({pair.source, pair.target, enum_of<retarget::Rest>(pair.rest, 2, "rest")});
    }
    api::require_array(def.clips, def.clip_count, "clips");
    for (uint32_t i = 0; i < def.clip_count; ++i) {
        api::require(def.clips[i] != nullptr, "a clip's name is NULL");
        out.clips.emplace_back(def.clips[i]);
    }
    api::require_array(def.followers, def.follower_count, "followers");
    for (uint32_t i = 0; i < def.follower_count; ++i) {
        const clq_follower &follower = def.followers[i];
        api::require(follower.joint && follower.leader, "a follower's joint or leader is NULL");
        out.followers.push_back({follower.joint, follower.leader, static_cast<double>(follower.share)});
    }
    out.prefix = api::name_of(def.prefix);
    out.way = enum_of<retarget::Way>(def.way, 3, "way");
    out.travel = enum_of<retarget::Travel>(def.travel, 2, "travel");
    if (def.rate_hz != 0) out.rate_hz = static_cast<double>(def.rate_hz);
    out.first_s = static_cast<double>(def.first_s);
    if (def.last_s != 0) out.last_s = static_cast<double>(def.last_s);
    out.close_s = static_cast<double>(def.close_s);
    return out;
}

}  // namespace

extern "C" {

clq_status clq_asset_add_clips(clq_context *context, clq_asset *asset, const clq_asset *source,
                               const clq_clips_def *def, clq_clips_report *report)
{
    return api::boundary("clq_asset_add_clips", [&] {
        api::require(context && asset && source, "context, asset or source is NULL");
        api::require(asset != source, "an asset is no source of clips for itself");
        api::require_size(def, "clq_clips_def_init");
        const retarget::Options options = options_of(def ? *def : clq_clips_def_init());
        const std::string who = "clips of '" + source->model.name + "' for '" + asset->model.name + "': ";
        std::vector<std::string> &warnings = asset->model.warnings;
        try {
            const retarget::Report made = retarget::add_clips(asset->model.rig, source->model.rig, options);
            if (report) *report = {static_cast<clq_clip_way>(made.way), made.clip_count, made.joint_count};
            for (const std::string &warning : made.warnings) {
                warnings.push_back(who + warning);
                clq_context_log(context, CLQ_LOG_WARNING, warnings.back().c_str());
            }
        } catch (const base::Error &error) {
            base::fail(error.status(), "%s%s", who.c_str(), error.what());
        }
    });
}

}  // extern "C"
