#include "tests/fuzz/shown.h"

#include <cmath>

#include "tests/api/calls.h"
#include "tests/api/stub_gl.h"

namespace fuzzing
{
namespace
{

constexpr uint32_t most = 6;  // of each thing that is asked for

void ask(const clq_template *tmpl, const clq_template_info &info)
{
    EXPECT_EQ(clq_template_get_level(tmpl, info.level_count, nullptr), CLQ_ARGUMENT);
    for (uint32_t i = 0; i < info.clip_count && i < most; ++i) {
        clq_clip_info clip = clq_clip_info_init();
        ASSERT_EQ(clq_template_get_clip(tmpl, i, &clip), CLQ_OK) << clq_last_error();
        EXPECT_LE(clq_template_find_clip(tmpl, clip.name), i);
    }
    for (uint32_t i = 0; i < info.zone_count && i < most; ++i) {
        clq_zone_info zone = clq_zone_info_init();
        ASSERT_EQ(clq_template_get_zone(tmpl, i, &zone), CLQ_OK) << clq_last_error();
    }
    for (uint32_t i = 0; i < info.level_count && i < most; ++i) {
        clq_mesh mesh = clq_mesh_init();
        ASSERT_EQ(clq_template_get_mesh(tmpl, i, &mesh), CLQ_OK) << clq_last_error();
        for (uint32_t k = 0; k < 3 * mesh.vertex_count; ++k) ASSERT_TRUE(std::isfinite(mesh.positions[k]));
        for (uint32_t bin = 0; bin < mesh.bin_count; ++bin) {
            clq_triangles triangles = clq_triangles_init();
            ASSERT_EQ(clq_template_get_triangles(tmpl, i, bin, &triangles), CLQ_OK) << clq_last_error();
            for (uint32_t k = 0; k < triangles.index_count; ++k) ASSERT_LT(triangles.indices[k], mesh.vertex_count);
        }
    }
}

void save_and_load(clq_context *context, const clq_template *tmpl)
{
    const Bytes bytes = bytes_of(tmpl);
    clq_template *again = nullptr;
    ASSERT_EQ(clq_template_load(context, bytes.data(), bytes.size(), &again), CLQ_OK) << clq_last_error();
    EXPECT_EQ(bytes_of(again), bytes);
    clq_template_destroy(again);
}

void people(clq_crowd *crowd, clq_template *tmpl, uint32_t clips)
{
    for (uint32_t i = 0; i < 4; ++i) {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl;
        def.transform.position[0] = i, def.transform.position[2] = -3.0 - 14.0 * i * i;
        if (i == 3) def.transform.scale = -0.5f;
        def.play.clip = i < clips ? i : CLQ_NONE;
        def.seed = i;
        clq_actor actor;
        EXPECT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK) << clq_last_error();
    }
}

// False if the renderer cannot take the template.
bool draw(clq_context *context, clq_template *tmpl, clq_view *view, uint32_t strategy)
{
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = stub_gl::find;
    def.strategy = static_cast<clq_draw_strategy>(strategy);
    def.linear_clean = strategy == CLQ_STRATEGY_FUSED;
    def.close_texture_bytes = strategy == CLQ_STRATEGY_BINNED ? 1 << 24 : 0;
    clq_renderer *renderer = nullptr;
    EXPECT_EQ(clq_renderer_create(context, &def, &renderer), CLQ_OK) << clq_last_error();
    const bool taken = done(clq_renderer_prepare(renderer, tmpl), {CLQ_LIMIT, CLQ_KEY_RESOLUTION});
    if (taken) {
        EXPECT_EQ(clq_renderer_draw(renderer, view, nullptr), CLQ_OK) << clq_last_error();
        const clq_shadow_def shadow = clq_shadow_def_init();
        EXPECT_EQ(clq_renderer_draw_shadows(renderer, view, &shadow, nullptr), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_renderer_draw_visibility(renderer, view, nullptr, nullptr), CLQ_OK) << clq_last_error();
    }
    EXPECT_EQ(clq_renderer_destroy(renderer), CLQ_OK) << clq_last_error();
    stub_gl::expect_balance();
    return taken;
}

}  // namespace

Bytes bytes_of(const clq_template *tmpl)
{
    Bytes out;
    const auto keep = [](void *user, const void *bytes, size_t size) {
        const uint8_t *first = static_cast<const uint8_t *>(bytes);
        static_cast<Bytes *>(user)->insert(static_cast<Bytes *>(user)->end(), first, first + size);
        return 0;
    };
    EXPECT_EQ(clq_template_save(tmpl, keep, &out), CLQ_OK) << clq_last_error();
    return out;
}

void show(clq_context *context, clq_template *tmpl)
{
    clq_template_info info = clq_template_info_init();
    ASSERT_EQ(clq_template_get_info(tmpl, &info), CLQ_OK) << clq_last_error();
    ask(tmpl, info);
    save_and_load(context, tmpl);
    clq_crowd_def def = clq_crowd_def_init();
    def.cache = CLQ_CACHE_FULL;
    def.cache_budget_bytes = 1u << 20;
    clq_crowd *crowd = nullptr;
    ASSERT_EQ(clq_crowd_create(context, &def, &crowd), CLQ_OK) << clq_last_error();
    people(crowd, tmpl, info.clip_count);
    clq_view *view = nullptr;
    EXPECT_EQ(clq_view_create(crowd, &view), CLQ_OK) << clq_last_error();
    clq_camera camera;
    EXPECT_EQ(api_test::look_at(&camera, {0, 1, 3}, {0, 1, -10}, {0, 1, 0}, 1.0f, 1.3f, 0.1f, 500), CLQ_OK);
    EXPECT_EQ(clq_view_set_camera(view, &camera), CLQ_OK) << clq_last_error();
    for (const double time_s : {0.0, 0.4}) {
        EXPECT_EQ(clq_crowd_update(crowd, time_s, &view, 1), CLQ_OK) << clq_last_error();
        for (uint32_t strategy = 0; strategy < 3; ++strategy)
            if (!draw(context, tmpl, view, strategy)) break;
    }
    clq_crowd_destroy(crowd);
}

}  // namespace fuzzing
