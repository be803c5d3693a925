// clq_renderer_...: preparing templates and drawing views.
#include <claque/renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "lib/api/renderer_handle.h"

using namespace claque;

namespace
{

passes::RendererOptions options_of(const clq_renderer_def &def)
{
    using api::require;
    require(api::number_of(def.strategy) <= CLQ_STRATEGY_PER_ZONE, "strategy is none of CLQ_STRATEGY_...");
    require(api::number_of(def.guard) <= CLQ_GUARD_NONE, "guard is none of CLQ_GUARD_...");
    require(api::number_of(def.colours) <= CLQ_COLOUR_FLOAT, "colours is none of CLQ_COLOUR_...");
    require(api::number_of(def.key_test) <= CLQ_KEY_EQUAL, "key_test is none of CLQ_KEY_...");
    passes::RendererOptions options;
    options.strategy = static_cast<passes::Strategy>(def.strategy);
    options.guard = static_cast<passes::Guard>(def.guard);
    options.colours = static_cast<passes::ColourFormat>(def.colours);
    options.key_test = static_cast<passes::KeyTest>(def.key_test);
    options.batch_triangles = def.batch_triangles;
    options.flush_triangles = def.flush_triangles;
    options.flat_triangles = def.flat_triangles;
    options.linear_clean = def.linear_clean;
    options.close_bytes = def.close_texture_bytes;
    require(def.close_distance_m >= 0 && std::isfinite(def.close_distance_m),
            "close_distance_m is negative or not finite");
    options.close_distance_m = def.close_distance_m;
    options.close_per_draw = def.close_textures_per_draw;
    options.multisample = def.multisample;
    options.smooth_levels = def.smooth_levels;
    return options;
}

// Logs that a strategy that cannot separate a template's zones is replaced by another. Allocates nothing, since a
// failure would come after all the work.
void report_fallback(const clq_renderer &renderer, const clq_template &tmpl) noexcept
{
    if (renderer.requested != passes::Strategy::fused || renderer.renderer.strategy_of(tmpl) == renderer.requested)
        return;
    size_t maximum = 0;
    for (const model::Texture &texture : tmpl.textures) maximum = std::max(maximum, texture.keys.size());
    char text[512];
    std::snprintf(text, sizeof text,
                  "template '%.300s' is drawn binned instead of fused: its %zu zones are more than one draw can tell "
                  "apart on this target",
                  tmpl.name.c_str(), maximum);
    renderer.context->log.warn(text);
}

void end(clq_renderer *renderer)
{
    std::pmr::vector<clq_template *> held(std::move(renderer->held));
    api::unmake(renderer->context, renderer);
    for (clq_template *tmpl : held) api::release(tmpl);
}

}  // namespace

extern "C" {

clq_status clq_renderer_create(clq_context *context, const clq_renderer_def *def, clq_renderer **out)
{
    return api::boundary("clq_renderer_create", [&] {
        api::require(context && def && out, "context, def or out is NULL");
        const clq_renderer_def wanted = api::read_def(def, clq_renderer_def_init, "clq_renderer_def_init");
        api::require(wanted.get_proc_address != nullptr, "get_proc_address is NULL");
        api::Making<clq_renderer> made(context, context, options_of(wanted));
        api::require(made->renderer.open(wanted.get_proc_address, wanted.user));
        *out = made.release();
    });
}

clq_status clq_renderer_prepare(clq_renderer *renderer, clq_template *tmpl)
{
    return api::boundary("clq_renderer_prepare", [&] {
        api::require(renderer && tmpl, "renderer or tmpl is NULL");
        api::require(tmpl->context == renderer->context, "the template was made from another context");
        const api::Rendering rendering(renderer);
        const bool known = std::find(renderer->held.begin(), renderer->held.end(), tmpl) != renderer->held.end();
        if (!known) renderer->held.reserve(renderer->held.size() + 1);
        api::require(renderer->renderer.prepare(*tmpl));
        if (known) return;
        renderer->held.push_back(tmpl);
        api::hold(tmpl);
        report_fallback(*renderer, *tmpl);
    });
}

clq_status clq_renderer_get_prepared(const clq_renderer *renderer, const clq_template *tmpl, clq_prepared_info *out)
{
    return api::boundary("clq_renderer_get_prepared", [&] {
        api::require(renderer && tmpl && out, "renderer, tmpl or out is NULL");
        api::require_size(*out, "clq_prepared_info_init");
        const api::Rendering rendering(renderer);
        if (std::find(renderer->held.begin(), renderer->held.end(), tmpl) == renderer->held.end())
            base::fail(CLQ_ARGUMENT, "the template '%s' has not been prepared for this renderer", tmpl->name.c_str());
        const passes::LuminanceStep step = renderer->renderer.step_of(*tmpl);
        clq_prepared_info info = clq_prepared_info_init();
        info.strategy = static_cast<clq_draw_strategy>(renderer->renderer.strategy_of(*tmpl));
        info.triangle_count = step.triangles, info.linear_count = step.linear_triangles;
        info.edge_count = step.edges;
        info.step_mean = step.mean, info.step_max = step.max;
        info.close_distance_m = renderer->renderer.close_distance_of(*tmpl);
        api::write_out(out, info);
    });
}

clq_status clq_renderer_draw(clq_renderer *renderer, clq_view *view, clq_draw_stats *out_stats)
{
    return api::boundary("clq_renderer_draw", [&] {
        api::require(renderer && view, "renderer or view is NULL");
        if (out_stats) api::require_size(*out_stats, "clq_draw_stats_init");
        api::require(view->crowd->context == renderer->context, "the view belongs to another context");
        const api::Rendering rendering(renderer);
        const api::Drawing drawing(view);
        passes::DrawStats stats;
        api::require(renderer->renderer.draw(view->view.list, &stats));
        if (!out_stats) return;
        clq_draw_stats told = clq_draw_stats_init();
        told.individuals = stats.individuals, told.draws = stats.draws;
        told.triangles = stats.triangles, told.vertices = stats.vertices;
        told.parts = stats.parts, told.matrices = stats.matrices;
        told.close_individuals = stats.close_individuals, told.close_textures_made = stats.close_made;
        told.close_texture_bytes = stats.close_bytes;
        api::write_out(out_stats, told);
    });
}

clq_status clq_renderer_destroy(clq_renderer *renderer)
{
    return api::boundary("clq_renderer_destroy", [&] {
        if (!renderer) return;
        api::Rendering rendering(renderer);
        renderer->renderer.destroy();
        rendering.end();
        end(renderer);
    });
}

clq_status clq_renderer_abandon(clq_renderer *renderer)
{
    return api::boundary("clq_renderer_abandon", [&] {
        if (!renderer) return;
        api::Rendering rendering(renderer);
        renderer->renderer.abandon();
        rendering.end();
        end(renderer);
    });
}

}  // extern "C"
