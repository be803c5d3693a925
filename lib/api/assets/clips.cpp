// Copies clips of one asset to another.
#include <claque/assets.h>

#include "lib/api/assets/asset_handle.h"
#include "lib/api/assets/placement.h"
#include "lib/api/boundary.h"
#include "lib/model/model_size.h"
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
        out.joints.push_back({pair.source, pair.target, enum_of<retarget::RestAlignment>(pair.rest, 2, "rest")});
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
    out.mode = enum_of<retarget::Mode>(def.mode, 3, "mode");
    out.rest = enum_of<retarget::SourceRest>(def.rest, 5, "rest");
    out.rest_frame = def.rest_frame;
    out.travel = enum_of<retarget::RootTravel>(def.travel, 2, "travel");
    if (def.rate_hz != 0) out.rate_hz = static_cast<double>(def.rate_hz);
    out.start_s = static_cast<double>(def.start_s);
    if (def.end_s != 0) out.end_s = static_cast<double>(def.end_s);
    out.close_s = static_cast<double>(def.close_s);
    return out;
}

// The root motion requests of the source's clips, if their joints are bound.
std::vector<model::RootMotionRequest> root_motions_of(const clq_asset &source, const retarget::Report &made,
                                                      clq_root_travel travel, uint32_t first_clip,
                                                      std::vector<std::string> &warnings)
{
    std::vector<model::RootMotionRequest> out;
    for (uint32_t i = 0; i < made.clips.size(); ++i)
        for (const model::RootMotionRequest &motion : source.model.root_motions) {
            if (motion.clip != made.clips[i]) continue;
            const char *clip = source.model.rig.clip_names[motion.clip].c_str();
            if (made.mode == retarget::Mode::motion && travel == CLQ_ROOT_TRAVEL_IN_PLACE) {
                warnings.push_back(base::text_of("clip '%s' has no root motion: it is taken in place", clip));
                continue;
            }
            uint32_t node = model::none;
            for (const auto &[from, to] : made.joints)
                if (from == motion.node) node = to;
            if (node != model::none) out.push_back({first_clip + i, node});
            else
                warnings.push_back(base::text_of("clip '%s' has no root motion: '%s' is not bound", clip,
                                                 source.model.rig.node_names[motion.node].c_str()));
        }
    return out;
}

// Adds the clips and what belongs to them. Everything that may fail comes before the first change.
retarget::Report add(clq_asset &asset, const clq_asset &source, const retarget::Options &options,
                     clq_root_travel travel, const std::string &prefix)
{
    model::Model &model = asset.model;
    std::vector<model::RootMotionRequest> motions;
    const auto prepare = [&](retarget::Report &report) {
        motions =
            root_motions_of(source, report, travel, static_cast<uint32_t>(model.rig.clips.size()), report.warnings);
        for (std::string &warning : report.warnings) warning.insert(0, prefix);
        model.root_motions.reserve(model.root_motions.size() + motions.size());
        model.warnings.reserve(model.warnings.size() + report.warnings.size());
    };
    // What was read for the clips was read for the asset.
    const uint64_t bytes = model.source_bytes ? model::source_bytes(source.model) : 0;
    const api::AsInFile own(model.rig, asset.placed);
    model::Rig copy;
    if (source.placed) copy = model::Rig(source.model.rig, std::pmr::get_default_resource());
    const api::AsInFile others(copy, source.placed);
    retarget::Report made = retarget::add_clips(model.rig, source.placed ? copy : source.model.rig, options, prepare);
    model.root_motions.insert(model.root_motions.end(), motions.begin(), motions.end());
    for (std::string &warning : made.warnings) model.warnings.push_back(std::move(warning));
    model.source_bytes += bytes;
    return made;
}

}  // namespace

extern "C" {

clq_status clq_asset_add_clips(clq_context *context, clq_asset *asset, const clq_asset *source,
                               const clq_clips_def *def, clq_clips_report *out_report)
{
    return api::boundary("clq_asset_add_clips", [&] {
        api::require(context && asset && source, "context, asset or source is NULL");
        api::require(asset != source, "the source of clips is the asset itself");
        if (out_report) api::require_size(*out_report, "clq_clips_report_init");
        const clq_clips_def wanted = api::read_def(def, clq_clips_def_init, "clq_clips_def_init");
        retarget::Options options = options_of(wanted);
        options.target_bones = asset->model.human_bones, options.source_bones = source->model.human_bones;
        const std::string prefix = "clips of '" + source->model.name + "' for '" + asset->model.name + "': ";
        try {
            const size_t warnings = asset->model.warnings.size();
            const retarget::Report made = add(*asset, *source, options, wanted.travel, prefix);
            if (out_report) {
                clq_clips_report report = clq_clips_report_init();
                report.mode = static_cast<clq_retarget_mode>(made.mode);
                report.clip_count = made.clip_count, report.joint_count = made.joint_count;
                api::write_out(out_report, report);
            }
            for (size_t i = warnings; i < asset->model.warnings.size(); ++i)
                clq_context_log(context, CLQ_LOG_WARNING, asset->model.warnings[i].c_str());
        } catch (const base::Error &error) {
            base::fail(error.status(), "%s%s", prefix.c_str(), error.what());
        }
    });
}

}  // extern "C"
