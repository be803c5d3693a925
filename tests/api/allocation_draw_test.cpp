// Allocations that fail in drawing.
#include "samples/contexts/offscreen.h"
#include "tests/api/allocation.h"
#include "tests/gl/support/absent.h"

using namespace allocation;

namespace
{

template <class Function>
Function screen_function(const contexts::Offscreen &screen, const char *name)
{
    return reinterpret_cast<Function>(screen.get_proc_address()(screen.user(), name));
}

}  // namespace

TEST_F(Allocation, ARendererFailsCleanlyAndDrawingAllocatesNothing)
{
    make_crowd(50);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.5, &view_, 1), CLQ_OK);
    std::string why_not;
    const auto screen = contexts::make_offscreen(contexts::Kind::any, 64, 64, contexts::PixelFormat::rgba8888, why_not);
    if (!screen) END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
    ASSERT_TRUE(screen->make_current());
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = screen->get_proc_address();
    def.user = screen->user();
    clq_renderer *renderer = nullptr;
    ASSERT_EQ(clq_renderer_create(context_, &def, &renderer), CLQ_OK);
    ASSERT_EQ(clq_renderer_prepare(renderer, tmpl_), CLQ_OK);
    const auto clear_colour = screen_function<void (*)(float, float, float, float)>(*screen, "glClearColor");
    const auto clear = screen_function<void (*)(unsigned)>(*screen, "glClear");
    std::vector<uint8_t> empty, drawn, now;
    clear_colour(0.1f, 0.6f, 0.2f, 1);
    clear(0x4100);
    screen->read_rgb(empty);
    ASSERT_EQ(clq_renderer_draw(renderer, view_, nullptr), CLQ_OK) << clq_last_error();
    screen->read_rgb(drawn);
    ASSERT_NE(drawn, empty);
    // Only the host's allocator may fail here: what GL itself allocates is not ours to test.
    clq_renderer *out = nullptr;
    fail_each(
        "clq_renderer_create and prepare", fm::Reach::host_only, 1,
        [&] {
            out = nullptr;
            clq_status status = clq_renderer_create(context_, &def, &out);
            if (status == CLQ_OK) status = clq_renderer_prepare(out, tmpl_);
            clq_renderer_destroy(out);
            return status;
        },
        [&] {
            clear(0x4100);
            ASSERT_EQ(clq_renderer_draw(renderer, view_, nullptr), CLQ_OK) << clq_last_error();
            screen->read_rgb(now);
            ASSERT_EQ(now, drawn) << "another renderer draws another picture";
        });
    // With textures of single individuals, which are chosen and painted in a draw.
    def.close_texture_bytes = 1 << 20, def.close_distance_m = 1000;
    clq_renderer *close = nullptr;
    ASSERT_EQ(clq_renderer_create(context_, &def, &close), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_renderer_prepare(close, tmpl_), CLQ_OK) << clq_last_error();
    clear(0x4100);
    fail_each(
        "clq_renderer_draw with close textures", fm::Reach::host_only, 1,
        [&] { return clq_renderer_draw(close, view_, nullptr); },
        [&] {
            screen->read_rgb(now);
            ASSERT_EQ(now, empty) << "a call that failed has drawn";
        },
        Memory::may_be_kept);
    clq_draw_stats stats = clq_draw_stats_init();
    ASSERT_EQ(clq_renderer_draw(close, view_, &stats), CLQ_OK) << clq_last_error();
    EXPECT_GT(stats.close_individuals, 0u);
    clq_renderer_destroy(close);
    draw_without_memory(renderer);
    // The mask of the viewport is made at the first shadows, and kept.
    const clq_shadow_def shadows = clq_shadow_def_init();
    clear(0x4100);
    fail_each(
        "clq_renderer_draw_shadows", fm::Reach::host_only, 1,
        [&] { return clq_renderer_draw_shadows(renderer, view_, &shadows, nullptr); },
        [&] {
            screen->read_rgb(now);
            ASSERT_EQ(now, empty) << "a call that failed has drawn";
        },
        Memory::may_be_kept);
    fm::arm(1, fm::Reach::host_only, true);
    EXPECT_EQ(clq_renderer_draw_shadows(renderer, view_, &shadows, nullptr), CLQ_OK) << clq_last_error();
    EXPECT_EQ(fm::disarm(), 0u);
    // Of a crowd without caches.
    clq_crowd_destroy(crowd_);
    clq_template_destroy(tmpl_);
    crowd_ = nullptr;
    make_crowd(50, CLQ_CACHE_NONE);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.5, &view_, 1), CLQ_OK);
    ASSERT_EQ(clq_renderer_prepare(renderer, tmpl_), CLQ_OK);
    draw_without_memory(renderer);
    clq_renderer_destroy(renderer);
}
