// Checks the description of shadows and draws them.
#include <claque/shadow.h>

#include <cmath>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/renderer_handle.h"

using namespace claque;

namespace
{

using api::require;

bool finite(const double (&v)[3]) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }

double length(const double *v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

void set_light(const clq_shadow_def &def, passes::ShadowOptions &options)
{
    const double up = length(def.up);
    require(finite(def.up) && up > 0 && std::isfinite(up), "up is not finite, or has no length");
    double along = 0;
    for (int k = 0; k < 3; ++k) {
        require(std::isfinite(def.light[k]), "light is not finite");
        options.light[k] = def.light[k];
        options.up[k] = def.up[k] / up;
        along += options.up[k] * def.light[k];
    }
    options.light[3] = def.light[3];
    if (def.light[3] != 0 && def.light[3] != 1)
        base::fail(CLQ_ARGUMENT, "light[3] is %g: 0 (a direction) or 1 (a position) is wanted", def.light[3]);
    if (def.light[3] != 0) return;
    const double far = length(def.light);
    require(far > 0 && std::isfinite(far), "light is a direction without a length");
    if (!(along / far >= 0.02))
        base::fail(CLQ_ARGUMENT, "the sine of the light's angle above the ground is %g: 0.02 or more is wanted",
                   along / far);
}

void set_ground(const clq_shadow_def &def, passes::ShadowOptions &options)
{
    require(api::number_of(def.ground) <= CLQ_SHADOW_GROUND_HOST, "ground is none of CLQ_SHADOW_GROUND_...");
    require(def.ground != CLQ_SHADOW_GROUND_HOST || def.height, "ground is the host's, but height is NULL");
    require(std::isfinite(def.plane_height), "plane_height is not finite");
    options.ground = static_cast<passes::ShadowGround>(def.ground);
    options.plane_height = def.plane_height;
    options.height = def.height;
    options.user = def.user;
    require(def.lift >= 0 && std::isfinite(def.lift), "lift is negative or not finite");
    options.lift = static_cast<double>(def.lift);
}

void set_look(const clq_shadow_def &def, passes::ShadowOptions &options)
{
    require(def.darkness >= 0 && def.darkness <= 1, "darkness is not in [0, 1]");
    for (int k = 0; k < 3; ++k) {
        require(def.rgb[k] >= 0 && def.rgb[k] <= 1, "rgb is not in [0, 1]");
        options.rgb[k] = def.rgb[k];
    }
    options.darkness = def.darkness;
    if (def.stencil_bit < -1 || def.stencil_bit > 31)
        base::fail(CLQ_ARGUMENT, "stencil_bit is %d: 0 to 31, or -1 for none, is wanted", def.stencil_bit);
    options.stencil_bit = def.stencil_bit;
    require(def.blob_distance_m >= 0 && def.max_distance_m >= 0, "a distance is negative or not a number");
    options.blob_from_m = def.blob_distance_m;
    options.none_from_m = def.max_distance_m;
}

}  // namespace

clq_status clq_renderer_draw_shadows(clq_renderer *renderer, clq_view *view, const clq_shadow_def *def,
                                     clq_shadow_stats *out_stats)
{
    return api::boundary("clq_renderer_draw_shadows", [&] {
        require(renderer && view && def, "renderer, view or def is NULL");
        if (out_stats) api::require_size(*out_stats, "clq_shadow_stats_init");
        const clq_shadow_def wanted = api::read_def(def, clq_shadow_def_init, "clq_shadow_def_init");
        require(view->crowd->context == renderer->context, "the view belongs to another context");
        passes::ShadowOptions options;
        set_light(wanted, options);
        set_ground(wanted, options);
        set_look(wanted, options);
        const api::Rendering rendering(renderer);
        const api::Drawing drawing(view);
        passes::ShadowStats stats;
        require(renderer->renderer.draw_shadows(view->view.list, options, &stats));
        if (!out_stats) return;
        clq_shadow_stats told = clq_shadow_stats_init();
        told.individuals = stats.individuals, told.blobs = stats.blobs;
        told.shadow_only = stats.shadow_only;
        told.draws = stats.draws, told.triangles = stats.triangles, told.vertices = stats.vertices;
        api::write_out(out_stats, told);
    });
}
