// The two ways to build a template: from a host's own arrays, and from a Model of libclaque-assets. Both share all
// steps after the Model.
#include <claque/template.h>

#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/build_id.h"
#include "lib/api/handles.h"
#include "lib/api/model_entry.h"
#include "lib/api/template_def.h"
#include "meshsplit/build.h"

using namespace claque;

namespace
{

meshsplit::MotionTolerance tolerance_of(const clq_template_def &def)
{
    if (!std::isfinite(def.motion_error) || !std::isfinite(def.motion_error_rad) || def.motion_error_rad < 0)
        base::fail(CLQ_ARGUMENT,
                   "motion_error is %g and motion_error_rad %g: finite numbers, no negative angle, are wanted",
                   static_cast<double>(def.motion_error), static_cast<double>(def.motion_error_rad));
    meshsplit::MotionTolerance out;
    if (def.motion_error != 0) out.metres = def.motion_error > 0 ? def.motion_error : 0;
    if (def.motion_error_rad > 0) out.radians = def.motion_error_rad;
    return out;
}

clq_template *split(clq_context *context, const model::Model &model, uint32_t max_texture_px,
                    const meshsplit::MotionTolerance &motion)
{
    meshsplit::BuildOptions options;
    if (max_texture_px) options.max_texture_px = max_texture_px;
    options.motion = motion;
    options.jobs = context->jobs;
    api::Making<clq_template> made(context, context);
    meshsplit::build(model, options, *made);
    api::log_report(context, *made);
    return made.release();
}

}  // namespace

extern "C" {

clq_status clq_template_build(clq_context *context, const clq_template_def *def, clq_template **out)
{
    return api::boundary("clq_template_build", [&] {
        api::require(context && def && out, "context, def or out is NULL");
        const clq_template_def wanted = api::read_def(def, clq_template_def_init, "clq_template_def_init");
        *out = split(context, api::model_of(wanted), wanted.max_texture_px, tolerance_of(wanted));
    });
}

clq_status clq_private_template_from_model(clq_context *context, const char *build_id, const model::Model *model,
                                           uint32_t max_texture_px, clq_template **out)
{
    return api::boundary("clq_asset_build", [&] {
        api::require(context && build_id && model && out, "context, build_id, asset or out is NULL");
        const std::string own = api::build_id_of(api::runtime_sources());
        if (own != build_id)
            base::fail(CLQ_UNSUPPORTED,
                       "libclaque-assets (%s) and libclaque (%s) are not of one build: install both from the same one",
                       build_id, own.c_str());
        *out = split(context, *model, max_texture_px, {});
    });
}

}  // extern "C"
