// A context that is lost at any GL call, or that has no memory at one: the call says so, abandoning works without GL,
// and a new renderer draws the same.
#include <cstdio>
#include <functional>

#include <gtest/gtest.h>

#include "tests/api/failing_memory.h"
#include "tests/faults/watched_gl.h"
#include "tests/faults/world.h"

namespace faults
{
namespace
{

using watched_gl::Loss;

class LostContext : public testing::Test
{
protected:
    clq_renderer *renderer(bool prepared)
    {
        clq_renderer_def def = clq_renderer_def_init();
        def.get_proc_address = watched_gl::find;
        def.close_texture_bytes = close_bytes_, def.close_distance_m = 1000;
        clq_renderer *made = nullptr;
        EXPECT_EQ(clq_renderer_create(world_.test.context, &def, &made), CLQ_OK) << clq_last_error();
        for (clq_template *tmpl : world_.test.templates)
            if (prepared) {
                EXPECT_EQ(clq_renderer_prepare(made, tmpl), CLQ_OK) << clq_last_error();
            }
        return made;
    }

    // In a new context, by a new renderer.
    uint64_t picture()
    {
        watched_gl::new_context();
        clq_renderer *fresh = renderer(true);
        watched_gl::picture();
        EXPECT_EQ(clq_renderer_draw(fresh, world_.objects.view, nullptr), CLQ_OK) << clq_last_error();
        const uint64_t drawn = watched_gl::picture();
        EXPECT_EQ(clq_renderer_destroy(fresh), CLQ_OK);
        EXPECT_EQ(watched_gl::texture_count(), 0u);
        return drawn;
    }

    // Loses the context at each call that `work` makes of GL, the first to the last.
    void lose_at_each_call(bool prepared, const std::function<clq_status(clq_renderer *)> &work)
    {
        const uint64_t expected = picture();
        const int64_t held = failing_memory::host_bytes();
        uint64_t n = 1;
        for (;; ++n) {
            watched_gl::new_context();
            clq_renderer *doomed = renderer(prepared);
            watched_gl::lose(Loss::context, n);
            const clq_status status = work(doomed);
            const bool lost = watched_gl::calls() >= n;
            ASSERT_EQ(status, lost ? CLQ_GL_MISSING : CLQ_OK) << "call " << n << ": " << clq_last_error();
            if (lost) {
                ASSERT_NE(std::string(clq_last_error()).find("GL context"), std::string::npos) << clq_last_error();
                ASSERT_EQ(work(doomed), CLQ_GL_MISSING) << n;
            }
            const uint64_t calls = watched_gl::calls();
            ASSERT_EQ(clq_renderer_abandon(doomed), CLQ_OK) << clq_last_error();
            ASSERT_EQ(watched_gl::calls(), calls) << "abandoning called GL";
            ASSERT_EQ(failing_memory::host_bytes(), held) << "call " << n;
            ASSERT_EQ(picture(), expected) << "call " << n;
            if (!lost) break;
        }
        EXPECT_GT(n, 10u);
        std::printf("contexts lost: %llu\n", static_cast<unsigned long long>(n - 1));
    }

    World world_;
    uint64_t close_bytes_ = 0;
};

TEST_F(LostContext, AtAnyCallOfADrawThatMakesCloseTexturesIsReported)
{
    close_bytes_ = 1 << 20;
    lose_at_each_call(true, [&](clq_renderer *one) { return clq_renderer_draw(one, world_.objects.view, nullptr); });
}

// The individual is then drawn by the strategy.
TEST_F(LostContext, ACloseTextureForWhichGlHasNoMemoryIsReportedAndTheNextDrawMakesIt)
{
    const uint64_t without = picture();
    close_bytes_ = 1 << 20;
    const uint64_t expected = picture();
    ASSERT_NE(expected, without);
    uint64_t calls = 1;
    uint32_t refused = 0;
    for (uint64_t n = 1; n <= calls; ++n) {
        watched_gl::new_context();
        clq_renderer *poor = renderer(true);
        watched_gl::lose(Loss::image_memory, n);
        clq_draw_stats stats = clq_draw_stats_init();
        const clq_status status = clq_renderer_draw(poor, world_.objects.view, &stats);
        calls = watched_gl::calls();
        watched_gl::lose(Loss::none, 0);
        if (status != CLQ_OK) {
            ++refused;
            EXPECT_EQ(status, CLQ_OUT_OF_MEMORY) << n << ": " << clq_last_error();
            EXPECT_NE(std::string(clq_last_error()).find("GL has no memory for 1 "), std::string::npos);
            EXPECT_EQ(clq_renderer_draw(poor, world_.objects.view, &stats), CLQ_OK) << clq_last_error();
            EXPECT_EQ(stats.close_textures_made, 1u);
        }
        EXPECT_EQ(clq_renderer_destroy(poor), CLQ_OK);
        EXPECT_EQ(watched_gl::texture_count(), 0u) << "textures stay behind";
    }
    EXPECT_GT(refused, 3u);
    EXPECT_EQ(picture(), expected);
}

TEST_F(LostContext, AtAnyCallOfADrawIsReported)
{
    lose_at_each_call(true, [&](clq_renderer *one) { return clq_renderer_draw(one, world_.objects.view, nullptr); });
}

TEST_F(LostContext, AtAnyCallOfShadowsIsReported)
{
    const clq_shadow_def def = clq_shadow_def_init();
    lose_at_each_call(
        true, [&](clq_renderer *one) { return clq_renderer_draw_shadows(one, world_.objects.view, &def, nullptr); });
}

TEST_F(LostContext, AtAnyCallOfVisibilityIsReported)
{
    lose_at_each_call(true, [&](clq_renderer *one) {
        return clq_renderer_draw_visibility(one, world_.objects.view, nullptr, nullptr);
    });
}

TEST_F(LostContext, AtAnyCallOfPreparingIsReported)
{
    lose_at_each_call(false, [&](clq_renderer *one) { return clq_renderer_prepare(one, world_.test.templates[0]); });
}

TEST_F(LostContext, IsNotTouchedByDestroying)
{
    watched_gl::new_context();
    clq_renderer *doomed = renderer(true);
    watched_gl::lose(Loss::context, 1);
    EXPECT_EQ(clq_renderer_destroy(doomed), CLQ_OK);
    EXPECT_LE(watched_gl::calls(), 1u) << "one question whether there is a context";
}

// GL ignores a call for which it has no memory. Textures are what takes much of it.
TEST_F(LostContext, ATextureForWhichGlHasNoMemoryIsReportedAndTheNextTryMakesIt)
{
    const uint64_t expected = picture();
    watched_gl::new_context();
    clq_renderer *one = renderer(false);
    watched_gl::lose(Loss::none, 0);
    ASSERT_EQ(clq_renderer_prepare(one, world_.person_template), CLQ_OK);
    const uint64_t calls = watched_gl::calls();
    uint32_t refused = 0;
    for (uint64_t n = 1; n <= calls; ++n) {
        watched_gl::new_context();
        clq_renderer *poor = renderer(false);
        watched_gl::lose(Loss::image_memory, n);
        const clq_status status = clq_renderer_prepare(poor, world_.person_template);
        watched_gl::lose(Loss::none, 0);
        if (status != CLQ_OK) {
            ++refused;
            EXPECT_EQ(status, CLQ_OUT_OF_MEMORY) << n << ": " << clq_last_error();
            EXPECT_NE(std::string(clq_last_error()).find("WrittenPerson"), std::string::npos) << clq_last_error();
            EXPECT_EQ(watched_gl::texture_count(), 0u) << "textures stay behind";
            EXPECT_EQ(clq_renderer_prepare(poor, world_.person_template), CLQ_OK) << clq_last_error();
        }
        EXPECT_EQ(clq_renderer_destroy(poor), CLQ_OK);
    }
    EXPECT_GT(refused, 0u);
    EXPECT_EQ(clq_renderer_abandon(one), CLQ_OK);
    EXPECT_EQ(picture(), expected);
}

TEST(GlFunctions, ThatTheHostLacksAreNamedEachOfThem)
{
    World world;
    static uint32_t left = 0;
    clq_renderer_def def = clq_renderer_def_init();
    def.get_proc_address = [](void *user, const char *name) {
        return left-- > 0 ? watched_gl::find(user, name) : nullptr;
    };
    const int64_t held = failing_memory::host_bytes();
    for (uint32_t n = 0;; ++n) {
        left = n;
        clq_renderer *made = nullptr;
        const clq_status status = clq_renderer_create(world.test.context, &def, &made);
        if (status == CLQ_OK) {
            EXPECT_GT(n, 50u);
            EXPECT_EQ(clq_renderer_destroy(made), CLQ_OK);
            break;
        }
        ASSERT_EQ(status, CLQ_GL_MISSING) << clq_last_error();
        ASSERT_NE(std::string(clq_last_error()).find(" gl"), std::string::npos) << clq_last_error();
        ASSERT_EQ(made, nullptr);
        ASSERT_EQ(failing_memory::host_bytes(), held);
        ASSERT_LT(n, 100u);
    }
}

}  // namespace
}  // namespace faults
