// Callbacks of drawing that throw.
#include <cstring>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/api/stub_gl.h"

namespace
{

// Counts its calls and throws in the n-th.
struct Countdown {
    uint32_t at = 0, calls = 0;
    void pass()
    {
        if (++calls == at) throw std::runtime_error("thrown on purpose");
    }
};

struct Hooked {
    Countdown before, after;
};

class ThrowingDraw : public testing::Test
{
protected:
    void SetUp() override
    {
        crowd_ = world_.new_crowd();
        world_.set_up(crowd_);
        actors_ = world_.fill(crowd_, 40, 5);
        view_ = world_.new_view(crowd_, 0);
        renderer_ = stub_gl::new_renderer(world_);
    }
    void TearDown() override { EXPECT_EQ(clq_renderer_destroy(renderer_), CLQ_OK); }

    void hook(Hooked &hooked)
    {
        clq_actor_hooks hooks = {};
        hooks.user = &hooked;
        hooks.before = [](void *user, clq_actor) {
            static_cast<Hooked *>(user)->before.pass();
            return false;
        };
        hooks.after = [](void *user, clq_actor) { static_cast<Hooked *>(user)->after.pass(); };
        for (const clq_actor actor : actors_) ASSERT_EQ(clq_actor_set_hooks(crowd_, actor, &hooks), CLQ_OK);
        ASSERT_EQ(clq_crowd_update(crowd_, 1, &view_, 1), CLQ_OK) << clq_last_error();
    }

    static void expect_thrown(const char *callback)
    {
        EXPECT_NE(std::strstr(clq_last_error(), callback), nullptr) << clq_last_error();
        EXPECT_NE(std::strstr(clq_last_error(), "threw an exception at actor "), nullptr) << clq_last_error();
    }

    TestWorld world_;
    clq_crowd *crowd_ = nullptr;
    std::vector<clq_actor> actors_;
    clq_view *view_ = nullptr;
    clq_renderer *renderer_ = nullptr;
};

TEST_F(ThrowingDraw, AnIndividualWhoseFirstHookThrowsIsNotDrawnAndAllOthersAre)
{
    Hooked hooked;
    hook(hooked);
    clq_draw_stats whole = clq_draw_stats_init();
    ASSERT_EQ(clq_renderer_draw(renderer_, view_, &whole), CLQ_OK) << clq_last_error();
    const uint32_t calls = hooked.before.calls;
    ASSERT_GT(calls, 5u);
    const uint64_t list = clq_view_get_hash(view_);
    for (uint32_t n = 1; n <= calls; ++n) {
        hooked = Hooked();
        hooked.before.at = n;
        ASSERT_EQ(clq_renderer_draw(renderer_, view_, nullptr), CLQ_CALLBACK);
        expect_thrown("the hook 'before'");
        EXPECT_EQ(hooked.before.calls, calls);
        EXPECT_EQ(hooked.after.calls, calls) << "the second hook undoes the first, and is always called";
        EXPECT_EQ(clq_view_get_hash(view_), list);
        hooked = Hooked();
        hooked.after.at = n;
        ASSERT_EQ(clq_renderer_draw(renderer_, view_, nullptr), CLQ_CALLBACK);
        expect_thrown("the hook 'after'");
        EXPECT_EQ(hooked.after.calls, calls);
    }
    hooked = Hooked();
    clq_draw_stats again = clq_draw_stats_init();
    EXPECT_EQ(clq_renderer_draw(renderer_, view_, &again), CLQ_OK) << clq_last_error();
    EXPECT_EQ(again.individuals, whole.individuals);
}

TEST_F(ThrowingDraw, AHeightThatThrowsEndsTheShadows)
{
    ASSERT_EQ(clq_crowd_update(crowd_, 1, &view_, 1), CLQ_OK) << clq_last_error();
    Countdown countdown;
    clq_shadow_def def = clq_shadow_def_init();
    def.ground = CLQ_SHADOW_GROUND_HOST;
    def.user = &countdown;
    def.height = [](void *user, const double *) {
        static_cast<Countdown *>(user)->pass();
        return 0.0;
    };
    ASSERT_EQ(clq_renderer_draw_shadows(renderer_, view_, &def, nullptr), CLQ_OK) << clq_last_error();
    const uint32_t calls = countdown.calls;
    ASSERT_GT(calls, 5u);
    for (uint32_t n = 1; n <= calls; ++n) {
        countdown = Countdown();
        countdown.at = n;
        ASSERT_EQ(clq_renderer_draw_shadows(renderer_, view_, &def, nullptr), CLQ_CALLBACK);
        expect_thrown("clq_shadow_def.height");
        EXPECT_EQ(countdown.calls, n);
    }
}

TEST_F(ThrowingDraw, ARendererWhoseFunctionsAreAskedForWithAnExceptionIsNotMade)
{
    Countdown countdown;
    clq_renderer_def def = clq_renderer_def_init();
    def.user = &countdown;
    def.get_proc_address = [](void *user, const char *name) {
        static_cast<Countdown *>(user)->pass();
        return stub_gl::find(nullptr, name);
    };
    uint32_t n = 1;
    for (;; ++n) {
        countdown = Countdown();
        countdown.at = n;
        clq_renderer *made = nullptr;
        const clq_status status = clq_renderer_create(world_.context, &def, &made);
        if (countdown.calls < n) {
            EXPECT_EQ(status, CLQ_OK) << clq_last_error();
            EXPECT_EQ(clq_renderer_destroy(made), CLQ_OK);
            break;
        }
        ASSERT_EQ(status, CLQ_CALLBACK) << clq_last_error();
        ASSERT_NE(std::strstr(clq_last_error(), "get_proc_address threw an exception: thrown on purpose"), nullptr);
        ASSERT_EQ(made, nullptr);
    }
    EXPECT_GT(n, 40u);
}

}  // namespace
