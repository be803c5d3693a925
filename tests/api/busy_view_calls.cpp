// The calls for views and renderers.
#include "tests/api/busy_calls.h"

namespace busy
{

void add_view_settings(std::vector<Call> &all)
{
    using O = const Objects &;
    const auto change = [&](const char *name, std::function<clq_status(O)> run) {
        all.push_back({name, Use::changes_crowd, std::move(run)});
    };
    change("clq_view_set_height", [](O o) { return clq_view_set_height(o.view, 600); });
    change("clq_view_set_cull_scale", [](O o) { return clq_view_set_cull_scale(o.view, 1); });
    change("clq_view_set_tile", [](O o) {
        const float whole[4] = {0, 0, 1, 1};
        return clq_view_set_tile(o.view, whole);
    });
    change("clq_view_set_shadow", [](O o) {
        const float fall[3] = {};
        return clq_view_set_shadow(o.view, fall);
    });
}

void add_view_calls(std::vector<Call> &all)
{
    using O = const Objects &;
    const auto view = [&](const char *name, std::function<clq_status(O)> run) {
        all.push_back({name, Use::reads_view, std::move(run)});
    };
    view("clq_view_get_stats", [](O o) {
        clq_view_stats stats = clq_view_stats_init();
        return clq_view_get_stats(o.view, &stats);
    });
    view("clq_view_get_hash", [](O o) { return clq_view_get_hash(o.view) == 0 ? CLQ_BUSY : CLQ_OK; });
    view("clq_view_get_drawn_actor", [](O o) {
        clq_drawn_actor drawn = clq_drawn_actor_init();
        return clq_view_get_drawn_actor(o.view, 0, &drawn);
    });
    view("clq_view_get_arrays", [](O o) {
        clq_drawn_arrays arrays = clq_drawn_arrays_init();
        return clq_view_get_arrays(o.view, 0, &arrays);
    });
    view("clq_view_get_colours", [](O o) {
        uint8_t rgb[6];
        return clq_view_get_colours(o.view, 0, rgb, 2);
    });
    view("clq_view_get_vertices", [](O o) {
        float positions[3 * 64];
        return clq_view_get_vertices(o.view, 0, positions, nullptr, 64);
    });
    view("clq_view_get_palette", [](O o) {
        float palette[12 * 8];
        return clq_view_get_palette(o.view, 0, palette, 8);
    });
    view("clq_view_get_morph_weights", [](O o) { return clq_view_get_morph_weights(o.view, 0, nullptr, 0); });
    view("clq_view_get_triangle_count", [](O o) {
        uint64_t count = 0;
        return clq_view_get_triangle_count(o.view, &count);
    });
    view("clq_view_get_pixels", [](O o) {
        const uint32_t numbers[2] = {0, 1};
        clq_pixels pixels = clq_pixels_init();
        pixels.width_px = 2, pixels.height_px = 1, pixels.numbers = numbers;
        float normals[6];
        clq_pixel_channels channels = clq_pixel_channels_init();
        channels.normals = normals;
        return clq_view_get_pixels(o.view, &pixels, &channels);
    });
    view("clq_view_get_flow", [](O o) {
        const uint32_t numbers[2] = {0, 1};
        clq_pixels pixels = clq_pixels_init();
        pixels.width_px = 2, pixels.height_px = 1, pixels.numbers = numbers;
        clq_flow_def def = clq_flow_def_init();
        const clq_look_at_def look = clq_look_at_def_init();
        const clq_status status = clq_camera_look_at(&look, &def.camera);
        float flow[4];
        return status != CLQ_OK ? status : clq_view_get_flow(o.view, &pixels, &def, flow);
    });

    const auto render = [&](const char *name, std::function<clq_status(O)> run) {
        all.push_back({name, Use::renders, std::move(run)});
    };
    render("clq_renderer_prepare", [](O o) { return clq_renderer_prepare(o.renderer, o.world->templates[0]); });
    render("clq_renderer_get_prepared", [](O o) {
        clq_prepared_info info = clq_prepared_info_init();
        return clq_renderer_get_prepared(o.renderer, o.world->templates[0], &info);
    });
    render("clq_renderer_draw", [](O o) { return clq_renderer_draw(o.renderer, o.view, nullptr); });
    render("clq_renderer_draw_shadows", [](O o) {
        const clq_shadow_def def = clq_shadow_def_init();
        return clq_renderer_draw_shadows(o.renderer, o.view, &def, nullptr);
    });
    render("clq_renderer_draw_visibility", [](O o) {
        const clq_visibility_def def = clq_visibility_def_init();
        return clq_renderer_draw_visibility(o.renderer, o.view, &def, nullptr);
    });
    render("clq_renderer_destroy", [](O o) { return clq_renderer_destroy(o.renderer); });
    render("clq_renderer_abandon", [](O o) { return clq_renderer_abandon(o.renderer); });
}

}  // namespace busy
