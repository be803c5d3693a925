// Times of the steps of an update: they are those of the host's clock, and nothing else changes.
#include <claque/claque.h>

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

namespace
{

class UpdateTimes : public testing::Test
{
protected:
    void SetUp() override
    {
        clq_context_def def = clq_context_def_init();
        def.log = {&log_, [](void *log, clq_log_level, const char *text) { *static_cast<std::string *>(log) += text; }};
        ASSERT_EQ(clq_context_create(&def, &context_), CLQ_OK);
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_crowd_create(context_, nullptr, &crowd_), CLQ_OK);
        ASSERT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
        clq_camera camera;
        const double eye[3] = {0, 1, 6}, target[3] = {0, 1, 0};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.8f, 1.33f, 0.1f, 100), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
        clq_actor_def actor = clq_actor_def_init();
        actor.tmpl = tmpl_;
        clq_actor out = {0, 0};
        ASSERT_EQ(clq_actor_create(crowd_, &actor, &out), CLQ_OK);
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK);
    }
    uint64_t update(double time_s)
    {
        EXPECT_EQ(clq_crowd_update(crowd_, time_s, &view_, 1), CLQ_OK) << clq_last_error();
        return clq_view_get_hash(view_);
    }
    clq_update_times times() const
    {
        clq_update_times out = clq_update_times_init();
        EXPECT_EQ(clq_crowd_get_update_times(crowd_, &out), CLQ_OK);
        return out;
    }
    static double sum(const clq_update_times &t)
    {
        return t.cull_s + t.choose_s + t.behave_s + t.animate_s + t.cull_parts_s + t.skin_s + t.list_s;
    }

    // The n-th call gives the sum of the numbers to n, so that the n-th step takes n + 1 seconds.
    struct Ticks {
        int calls = 0;
        static double now(void *user)
        {
            const int n = ++static_cast<Ticks *>(user)->calls;
            return 0.5 * n * (n + 1);
        }
    };

    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
    std::string log_;
    SmallTemplate small_;
};

TEST_F(UpdateTimes, AreThoseOfTheHostsClockInTheOrderOfTheSteps)
{
    Ticks ticks;
    ASSERT_EQ(clq_crowd_set_step_clock(crowd_, Ticks::now, &ticks), CLQ_OK);
    EXPECT_FALSE(times().measured);
    update(1);
    EXPECT_EQ(ticks.calls, 8);
    const clq_update_times t = times();
    EXPECT_TRUE(t.measured);
    const double steps[] = {t.cull_s, t.choose_s, t.behave_s, t.animate_s, t.cull_parts_s, t.skin_s, t.list_s};
    for (int k = 0; k < 7; ++k) EXPECT_EQ(steps[k], k + 2) << "step " << k;
    ASSERT_EQ(clq_crowd_set_step_clock(crowd_, nullptr, nullptr), CLQ_OK);
    EXPECT_TRUE(times().measured) << "of the last update, until the next";
    update(2);
    EXPECT_EQ(ticks.calls, 8);
    EXPECT_FALSE(times().measured);
    EXPECT_EQ(sum(times()), 0);
}

TEST_F(UpdateTimes, ChangeNothingThatIsShown)
{
    const uint64_t one = update(1), two = update(2), state = clq_crowd_get_hash(crowd_);
    Ticks ticks;
    ASSERT_EQ(clq_crowd_set_step_clock(crowd_, Ticks::now, &ticks), CLQ_OK);
    EXPECT_EQ(clq_crowd_get_hash(crowd_), state);
    EXPECT_EQ(update(1), one);
    EXPECT_EQ(update(2), two);
}

TEST_F(UpdateTimes, AreZeroWhereTheClockThrows)
{
    const uint64_t shown = update(1);
    const auto broken = [](void *) -> double { throw std::runtime_error("stopped"); };
    ASSERT_EQ(clq_crowd_set_step_clock(crowd_, broken, nullptr), CLQ_OK);
    EXPECT_EQ(update(1), shown);
    EXPECT_FALSE(times().measured);
    EXPECT_EQ(sum(times()), 0);
    EXPECT_EQ(log_, "the step clock threw an exception: stopped; the steps of the update have no times");
}

TEST_F(UpdateTimes, AreRefusedWithoutACrowdOrAPlace)
{
    clq_update_times out = clq_update_times_init();
    EXPECT_EQ(clq_crowd_set_step_clock(nullptr, nullptr, nullptr), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_get_update_times(nullptr, &out), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_get_update_times(crowd_, nullptr), CLQ_ARGUMENT);
    out.struct_bytes = 3;
    EXPECT_EQ(clq_crowd_get_update_times(crowd_, &out), CLQ_STRUCT_SIZE);
}

}  // namespace
