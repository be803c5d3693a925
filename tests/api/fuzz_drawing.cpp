// Random calls that draw, through a GL that reads every array, and that ask what is drawn.
#include "tests/api/fuzz_world.h"

namespace fuzz
{

void World::new_renderer()
{
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = stub_gl::find;
    def.strategy = static_cast<clq_draw_strategy>(random_.below(3));
    def.guard = static_cast<clq_guard>(random_.below(3));
    def.colours = static_cast<clq_colour_format>(random_.below(2));
    const uint32_t sizes[] = {0, 4, 128, 2730};
    def.batch_triangles = sizes[random_.below(4)], def.flat_triangles = sizes[random_.below(4)];
    def.linear_clean = random_.one_in(3);
    const uint64_t budgets[] = {0, 0, 300, 1 << 20};
    def.close_texture_bytes = budgets[random_.below(4)], def.close_textures_per_draw = random_.below(3);
    def.close_distance_m = random_.one_in(2) ? 0 : 100;
    def.multisample = random_.one_in(2), def.smooth_levels = random_.one_in(2);
    def.flush_triangles = random_.one_in(3) ? 10 : 0;
    ASSERT_EQ(clq_renderer_create(test_world_.context, &def, &renderer_), CLQ_OK) << clq_last_error();
    for (clq_template *tmpl : templates_) EXPECT_EQ(clq_renderer_prepare(renderer_, tmpl), CLQ_OK) << clq_last_error();
}

void World::draw()
{
    if (views_.empty()) return;
    clq_view *view = views_[random_.below(static_cast<uint32_t>(views_.size()))];
    clq_view_stats seen = clq_view_stats_init();
    ASSERT_EQ(clq_view_get_stats(view, &seen), CLQ_OK);
    clq_draw_stats stats = clq_draw_stats_init();
    bool refused = false;
    const bool done = call("clq_renderer_draw", [&] {
        const clq_status status = clq_renderer_draw(renderer_, view, &stats);
        refused = status == CLQ_OUT_OF_MEMORY;
        return status;
    });
    EXPECT_TRUE(done || refused) << "seed " << seed_ << ", step " << step_ << ": " << clq_last_error();
    if (!done) return;
    EXPECT_LE(stats.individuals, seen.visible) << "seed " << seed_ << ", step " << step_;
    EXPECT_LE(stats.close_individuals, stats.individuals) << "seed " << seed_ << ", step " << step_;
    EXPECT_LE(stats.close_texture_bytes, uint64_t(1) << 20) << "seed " << seed_ << ", step " << step_;
    drawn_ += stats.individuals;
}

void World::draw_shadows()
{
    if (views_.empty()) return;
    clq_view *view = views_[random_.below(static_cast<uint32_t>(views_.size()))];
    clq_shadow_def def = clq_shadow_def_init();
    for (double &x : def.light) x = random_.odd(-2, 2);
    def.light[3] = random_.below(2);
    if (random_.one_in(4)) def.up[random_.below(3)] = random_.odd(-1, 1, 8);
    def.ground = static_cast<clq_shadow_ground>(random_.index(3, 40));
    def.plane_height = random_.odd(-1, 1), def.lift = random_.oddf(0, 0.1);
    def.height = [](void *, const double p[3]) { return p[0] > 10 ? NAN : 0.1 * p[0]; };
    def.darkness = random_.oddf(0, 1);
    def.stencil_bit = random_.one_in(3) ? -1 : static_cast<int32_t>(random_.index(8));
    if (random_.one_in(2)) def.blob_distance_m = random_.oddf(0, 40), def.max_distance_m = random_.oddf(0, 80);
    clq_shadow_stats stats = clq_shadow_stats_init();
    if (!call("clq_renderer_draw_shadows", [&] { return clq_renderer_draw_shadows(renderer_, view, &def, &stats); }))
        return;
    EXPECT_LE(stats.blobs, stats.individuals) << "seed " << seed_ << ", step " << step_;
}

void World::draw_visibility()
{
    if (views_.empty()) return;
    clq_view *view = views_[random_.below(static_cast<uint32_t>(views_.size()))];
    clq_visibility_def def = clq_visibility_def_init();
    def.first_number = random_.one_in(8) ? random_.below(2) * 0xffffffffu : 1 + random_.below(100);
    def.upper_bits = random_.one_in(4);
    call("clq_renderer_draw_visibility", [&] { return clq_renderer_draw_visibility(renderer_, view, &def, nullptr); });
    uint64_t count = 0;
    call("clq_view_get_triangle_count", [&] { return clq_view_get_triangle_count(view, &count); });
    uint32_t numbers[12], zones[12];
    for (uint32_t &number : numbers)
        number = random_.below(static_cast<uint32_t>(count) + (random_.one_in(4) ? 3 : 1)) + def.first_number;
    clq_pixels pixels = clq_pixels_init();
    pixels.width_px = 4, pixels.height_px = 3, pixels.numbers = numbers;
    pixels.first_number = random_.one_in(10) ? random_.below(3) : def.first_number;
    float normals[36], flow[24];
    clq_pixel_channels channels = clq_pixel_channels_init();
    channels.zones = zones, channels.normals = random_.one_in(3) ? nullptr : normals;
    call("clq_view_get_pixels", [&] { return clq_view_get_pixels(view, &pixels, &channels); });
    clq_flow_def other = clq_flow_def_init();
    other.time_s = random_.odd(-5, 20);
    const clq_look_at_def look = clq_look_at_def_init();
    if (clq_camera_look_at(&look, &other.camera) != CLQ_OK) return;
    call("clq_view_get_flow", [&] { return clq_view_get_flow(view, &pixels, &other, flow); });
}

// Of individuals that a view shows, and of numbers beyond them.
void World::ask_list()
{
    if (views_.empty()) return;
    const clq_view *view = views_[random_.below(static_cast<uint32_t>(views_.size()))];
    clq_view_stats seen = clq_view_stats_init();
    ASSERT_EQ(clq_view_get_stats(view, &seen), CLQ_OK);
    const uint32_t index = random_.index(seen.visible, 10);
    clq_drawn_actor actor = clq_drawn_actor_init();
    const bool there = call("clq_view_get_drawn_actor", [&] { return clq_view_get_drawn_actor(view, index, &actor); });
    EXPECT_EQ(there, index < seen.visible) << "seed " << seed_ << ", step " << step_ << ": " << clq_last_error();
    uint8_t rgb[3 * 8];
    const uint32_t zones = random_.below(9);
    call("clq_view_get_colours", [&] { return clq_view_get_colours(view, index, rgb, zones); });
    float positions[3 * 64], normals[3 * 64];
    const uint32_t vertices = random_.one_in(4) ? random_.below(64) : 64;
    call("clq_view_get_vertices", [&] { return clq_view_get_vertices(view, index, positions, normals, vertices); });
    float palette[16 * 4];
    call("clq_view_get_palette", [&] { return clq_view_get_palette(view, index, palette, random_.below(5)); });
}

}  // namespace fuzz
