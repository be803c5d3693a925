// Visibility pictures that no drawing made, with one triangle in each pixel.
#include <claque/visibility.h>

#include <cmath>

#include "tests/api/calls.h"
#include "tests/api/saved_bytes.h"
#include "tests/api/small_template.h"

namespace
{

class Pixels : public testing::Test
{
protected:
    static constexpr uint32_t side = 4, count = side * side;

    void SetUp() override { ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK); }
    void TearDown() override
    {
        for (clq_crowd *crowd : crowds_) clq_crowd_destroy(crowd);
        for (clq_template *tmpl : templates_) clq_template_destroy(tmpl);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK);
    }

    clq_template *build(const clq_template_def &def)
    {
        clq_template *made = nullptr;
        EXPECT_EQ(clq_template_build(context_, &def, &made), CLQ_OK) << clq_last_error();
        templates_.push_back(made);
        return made;
    }
    // With one actor at the origin.
    clq_crowd *crowd_of(clq_template *tmpl)
    {
        clq_crowd *crowd = nullptr;
        EXPECT_EQ(clq_crowd_create(context_, nullptr, &crowd), CLQ_OK);
        crowds_.push_back(crowd);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl;
        clq_actor actor;
        EXPECT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK) << clq_last_error();
        return crowd;
    }
    clq_view *updated(clq_crowd *crowd)
    {
        clq_view *view = nullptr;
        EXPECT_EQ(clq_view_create(crowd, &view), CLQ_OK);
        const double eye[3] = {0, 1, 5}, target[3] = {0, 1, 0};
        const float up[3] = {0, 1, 0};
        EXPECT_EQ(api_test::look_at(&camera_, eye, target, up, 1, 1, 0.1f, 100), CLQ_OK);
        EXPECT_EQ(clq_view_set_camera(view, &camera_), CLQ_OK);
        EXPECT_EQ(clq_crowd_update(crowd, 0, &view, 1), CLQ_OK) << clq_last_error();
        clq_view_stats stats = clq_view_stats_init();
        EXPECT_EQ(clq_view_get_stats(view, &stats), CLQ_OK);
        EXPECT_EQ(stats.visible, 1u);
        return view;
    }
    clq_pixels pixels() const
    {
        clq_pixels out = clq_pixels_init();
        out.width_px = out.height_px = side, out.numbers = numbers_.data();
        return out;
    }

    clq_context *context_ = nullptr;
    std::vector<clq_template *> templates_;
    std::vector<clq_crowd *> crowds_;
    clq_camera camera_ = {};
    const std::vector<uint32_t> numbers_ = std::vector<uint32_t>(count, 1);  // the first triangle
};

// GL may round the corners of such a triangle so that it fills a pixel.
TEST_F(Pixels, OfATriangleThatIsSeenEdgeOnHaveNoPointAndNoZone)
{
    SmallTemplate strip;
    std::vector<float> turned(3 * 10), normals(3 * 10, 0);
    for (size_t v = 0; v < 10; ++v) {  // from the plane of the picture into that of x = 0, where the eye is
        turned[3 * v + 1] = strip.parts[0].positions[3 * v + 1], turned[3 * v + 2] = strip.parts[0].positions[3 * v];
        normals[3 * v] = 1;
    }
    for (const bool edge_on : {false, true}) {
        if (edge_on) strip.parts[0].positions = turned.data(), strip.parts[0].normals = normals.data();
        const clq_view *view = updated(crowd_of(build(strip.def)));
        std::vector<uint32_t> triangles(count, 77), zones(count, 77);
        std::vector<float> weights(3 * size_t(count));
        clq_pixel_channels channels = clq_pixel_channels_init();
        channels.triangles = triangles.data(), channels.zones = zones.data(), channels.barycentric = weights.data();
        const clq_pixels given = pixels();
        ASSERT_EQ(clq_view_get_pixels(view, &given, &channels), CLQ_OK) << clq_last_error();
        for (size_t i = 0; i < count; ++i) {
            EXPECT_EQ(triangles[i], 0u);
            EXPECT_EQ(std::isnan(weights[3 * i]), edge_on);
            if (edge_on) EXPECT_EQ(zones[i], CLQ_NONE);
            else EXPECT_LT(zones[i], 2u);
        }
    }
}

TEST_F(Pixels, OfAnActorWithAnotherTemplateSinceHaveNoFlow)
{
    SmallTemplate strip;
    clq_template *one = build(strip.def);
    strip.def.name = "other";
    clq_template *other = build(strip.def);
    clq_template *const both[] = {one, other};
    clq_crowd *crowd = crowd_of(one);
    const clq_view *view = updated(crowd);
    const auto flows_after = [&](const saved::Bytes &state) {
        EXPECT_EQ(clq_crowd_restore(crowd, state.data(), state.size(), both, 2), CLQ_OK) << clq_last_error();
        clq_flow_def def = clq_flow_def_init();
        def.camera = camera_;
        std::vector<float> flow(2 * size_t(count), 77);
        const clq_pixels given = pixels();
        EXPECT_EQ(clq_view_get_flow(view, &given, &def, flow.data()), CLQ_OK) << clq_last_error();
        return flow;
    };
    for (const float px : flows_after(saved::save(crowd))) EXPECT_FALSE(std::isnan(px));
    for (const float px : flows_after(saved::save(crowd_of(other)))) EXPECT_TRUE(std::isnan(px)) << px;
}

}  // namespace
