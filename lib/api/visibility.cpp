// Draws visibility pictures.
#include <claque/visibility.h>

#include "lib/api/boundary.h"
#include "lib/api/inspected.h"
#include "lib/api/renderer_handle.h"

using namespace claque;

extern "C" {

clq_status clq_view_get_triangle_count(const clq_view *view, uint64_t *out)
{
    return api::boundary("clq_view_get_triangle_count", [&] {
        api::require(view && out, "view or out is NULL");
        const api::Drawing drawing(view);
        *out = draw::triangle_count(view->view.list);
    });
}

clq_status clq_renderer_draw_visibility(clq_renderer *renderer, clq_view *view, const clq_visibility_def *def,
                                        clq_draw_stats *out_stats)
{
    return api::boundary("clq_renderer_draw_visibility", [&] {
        api::require(renderer && view, "renderer or view is NULL");
        if (out_stats) api::require_size(*out_stats, "clq_draw_stats_init");
        const clq_visibility_def wanted = api::read_def(def, clq_visibility_def_init, "clq_visibility_def_init");
        api::require(wanted.first_number > 0, "first_number is 0, which stands for no triangle");
        api::require(view->crowd->context == renderer->context, "the view belongs to another context");
        const api::Rendering rendering(renderer);
        const api::Drawing drawing(view);
        const uint64_t count = draw::triangle_count(view->view.list);
        if (wanted.first_number + count > uint64_t(UINT32_MAX) + 1)
            base::fail(CLQ_LIMIT, "%llu triangles from number %u on: numbers have 32 bits",
                       static_cast<unsigned long long>(count), wanted.first_number);
        api::InspectedSource placed_by_gl(view);
        passes::VisibilityOptions options;
        options.first_number = wanted.first_number;
        options.upper_bits = wanted.upper_bits;
        options.drawn = wanted.drawn;
        options.placed_by_gl = &placed_by_gl;
        passes::DrawStats stats;
        api::require(renderer->renderer.draw_visibility(view->view.list, options, &stats));
        if (!out_stats) return;
        clq_draw_stats told = clq_draw_stats_init();
        told.individuals = stats.individuals, told.draws = stats.draws;
        told.triangles = stats.triangles, told.vertices = stats.vertices, told.parts = stats.parts;
        api::write_out(out_stats, told);
    });
}

}  // extern "C"
