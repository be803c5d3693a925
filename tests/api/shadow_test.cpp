// Shadows through the C API: limits of the definition; no actor is posed or skinned for them.
#include <claque/shadow.h>

#include <cmath>
#include <functional>
#include <string>

#include "samples/contexts/offscreen.h"
#include "tests/api/calls.h"
#include "tests/api/test_world.h"
#include "tests/gl/support/absent.h"

namespace
{

class Shadow : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string why_not;
        screen_ = contexts::make_offscreen(contexts::Kind::any, 96, 72, contexts::PixelFormat::rgba8888, why_not);
        if (!screen_) END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
        crowd_ = test_world_.new_crowd();
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = test_world_.templates[0];
        for (int k = 0; k < 12; ++k) {
            def.transform.position[0] = k;
            def.transform.position[1] = 1;
            clq_actor actor;
            ASSERT_EQ(clq_actor_create(crowd_, &def, &actor), CLQ_OK) << clq_last_error();
        }
        view_ = test_world_.new_view(crowd_, 5);
        clq_camera camera;
        const double eye[3] = {5, 6, 14}, target[3] = {5, 1, 0};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.9f, 4.0f / 3.0f, 0.5f, 100), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
        ASSERT_EQ(clq_crowd_update(crowd_, 1.0, &view_, 1), CLQ_OK) << clq_last_error();
        clq_renderer_def renderer = clq_renderer_def_init();
        renderer.get_proc_address = screen_->get_proc_address();
        renderer.user = screen_->user();
        ASSERT_EQ(clq_renderer_create(test_world_.context, &renderer, &renderer_), CLQ_OK) << clq_last_error();
        for (clq_template *tmpl : test_world_.templates) ASSERT_EQ(clq_renderer_prepare(renderer_, tmpl), CLQ_OK);
    }
    void TearDown() override { clq_renderer_destroy(renderer_); }

    clq_status draw(const clq_shadow_def &def, clq_shadow_stats *stats = nullptr)
    {
        return clq_renderer_draw_shadows(renderer_, view_, &def, stats);
    }
    void refused(const char *because, const std::function<void(clq_shadow_def &)> &change)
    {
        clq_shadow_def def = clq_shadow_def_init();
        change(def);
        EXPECT_EQ(draw(def), CLQ_ARGUMENT) << because;
        EXPECT_NE(std::string(clq_last_error()).find(because), std::string::npos) << clq_last_error();
    }

    TestWorld test_world_;
    std::unique_ptr<contexts::Offscreen> screen_;
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
    clq_renderer *renderer_ = nullptr;
};

TEST_F(Shadow, ADefThatMakesNoSenseIsRefusedWithItsReason)
{
    refused("light is not finite", [](clq_shadow_def &d) { d.light[1] = NAN; });
    refused("light[3] is 0.5", [](clq_shadow_def &d) { d.light[3] = 0.5; });
    refused("without a length", [](clq_shadow_def &d) { d.light[1] = 0; });
    refused("angle above the ground is -1", [](clq_shadow_def &d) { d.light[1] = -2; });
    refused("up is not finite", [](clq_shadow_def &d) { d.up[1] = 0; });
    refused("ground is none", [](clq_shadow_def &d) { d.ground = static_cast<clq_shadow_ground>(3); });
    refused("height is NULL", [](clq_shadow_def &d) { d.ground = CLQ_SHADOW_GROUND_HOST; });
    refused("plane_height", [](clq_shadow_def &d) { d.plane_height = INFINITY; });
    refused("lift", [](clq_shadow_def &d) { d.lift = -1; });
    refused("darkness", [](clq_shadow_def &d) { d.darkness = 1.5f; });
    refused("rgb", [](clq_shadow_def &d) { d.rgb[2] = -0.5f; });
    refused("stencil_bit is 32", [](clq_shadow_def &d) { d.stencil_bit = 32; });
    refused("distance", [](clq_shadow_def &d) { d.blob_distance_m = NAN; });
    clq_shadow_def def = clq_shadow_def_init();
    def.struct_bytes -= 4;
    EXPECT_EQ(draw(def), CLQ_STRUCT_SIZE);
    def = clq_shadow_def_init();
    def.stencil_bit = 20;
    EXPECT_EQ(draw(def), CLQ_GL_STATE);
}

TEST_F(Shadow, NothingIsPosedOrSkinnedForIt)
{
    clq_crowd_stats before = clq_crowd_stats_init(), after = clq_crowd_stats_init();
    ASSERT_EQ(clq_crowd_get_stats(crowd_, &before), CLQ_OK);
    EXPECT_EQ(before.skinned, 12u);
    clq_shadow_def def = clq_shadow_def_init();
    def.light[0] = 0.5, def.light[2] = 0.4;
    for (const int32_t bit : {-1, 0}) {
        def.stencil_bit = bit;
        clq_shadow_stats stats = clq_shadow_stats_init();
        ASSERT_EQ(draw(def, &stats), CLQ_OK) << clq_last_error();
        EXPECT_EQ(stats.individuals, 12u);
        EXPECT_GT(stats.triangles, 0u);
    }
    ASSERT_EQ(clq_crowd_get_stats(crowd_, &after), CLQ_OK);
    EXPECT_EQ(after.skinned, before.skinned);
    EXPECT_EQ(after.animated, before.animated);
}

TEST_F(Shadow, TheHostsGroundIsSampledAtEveryReferencePoint)
{
    struct Asked {
        double sum = 0;
        int count = 0;
    } asked;
    clq_shadow_def def = clq_shadow_def_init();
    def.ground = CLQ_SHADOW_GROUND_HOST;
    def.user = &asked;
    def.height = [](void *user, const double point[3]) {
        static_cast<Asked *>(user)->sum += point[0] + 100 * point[1];
        ++static_cast<Asked *>(user)->count;
        return 0.0;
    };
    ASSERT_EQ(draw(def), CLQ_OK) << clq_last_error();
    EXPECT_EQ(asked.count, 12);
    EXPECT_EQ(asked.sum, 66 + 12 * 100);
}

}  // namespace
