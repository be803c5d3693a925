// What a view shows, as numbers, and its meshes: skinned here again by the formula of docs/parity.md.
#include <claque/claque.h>
#include <claque/drawn_actor.h>
#include <claque/mesh.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

namespace
{

class DrawnActor : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK) << clq_last_error();
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK);
    }

    // Three actors in a row before the eye, each with its own bend.
    void fill(const clq_crowd_def &def)
    {
        clq_crowd_destroy(crowd_);
        ASSERT_EQ(clq_crowd_create(context_, &def, &crowd_), CLQ_OK) << clq_last_error();
        for (int i = 0; i < 3; ++i) {
            clq_actor_def actor = clq_actor_def_init();
            actor.tmpl = tmpl_;
            actor.transform.position[0] = 2 * i - 2, actor.transform.position[2] = -8 - i;
            actor.transform.scale = i == 2 ? -1.0f : 1.0f;
            actor.play.clip = 0, actor.play.phase_s = 0.3f * static_cast<float>(i);
            clq_actor made;
            ASSERT_EQ(clq_actor_create(crowd_, &actor, &made), CLQ_OK) << clq_last_error();
            if (i == 1) {
                ASSERT_EQ(clq_actor_randomise_colours(crowd_, made, nullptr, 0), CLQ_OK);
            }
        }
        ASSERT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
        clq_camera camera;
        const double eye[3] = {0, 1, 0}, target[3] = {0, 1, -10};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 1.2f, 1.3f, 0.1f, 100), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
        ASSERT_EQ(clq_crowd_update(crowd_, 0.2, &view_, 1), CLQ_OK) << clq_last_error();
    }

    // The largest distance between the shown vertices and those computed from palette and mesh.
    double apart(uint32_t index)
    {
        clq_drawn_actor shown = clq_drawn_actor_init();
        clq_mesh mesh = clq_mesh_init();
        EXPECT_EQ(clq_view_get_drawn_actor(view_, index, &shown), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_template_get_mesh(shown.tmpl, shown.level, &mesh), CLQ_OK);
        const uint32_t count = mesh.vertex_count, each = mesh.influence_count;
        std::vector<float> palette(12 * shown.joint_count), xyz(3 * count), weights(each * count);
        std::vector<uint16_t> joints(each * count);
        EXPECT_EQ(clq_view_get_palette(view_, index, palette.data(), shown.joint_count), CLQ_OK)
            << clq_last_error();
        EXPECT_EQ(clq_view_get_vertices(view_, index, xyz.data(), nullptr, count), CLQ_OK) << clq_last_error();
        EXPECT_EQ(
            api_test::get_influences(shown.tmpl, shown.level, each, joints.data(), weights.data(), joints.size()),
            CLQ_OK);
        double most = 0;
        for (uint32_t v = 0; v < count; ++v)
            for (uint32_t k = 0; k < 3; ++k) {
                double moved = 0;
                for (uint32_t i = 0; i < each; ++i) {
                    const float *m = palette.data() + 12 * joints[v * each + i];
                    const float *p = mesh.positions + 3 * v;
                    moved +=
                        double(weights[v * each + i]) * (double(m[k]) * double(p[0]) + double(m[3 + k]) * double(p[1]) +
                                                         double(m[6 + k]) * double(p[2]) + double(m[9 + k]));
                }
                most = std::fmax(most, std::fabs(moved - double(xyz[3 * v + k])));
            }
        return most;
    }

    SmallTemplate small_;
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
};

TEST_F(DrawnActor, IsSkinnedFromThePaletteWhateverIsCached)
{
    for (const clq_cache_mode cache : {CLQ_CACHE_FULL, CLQ_CACHE_ANIMATION, CLQ_CACHE_NONE}) {
        clq_crowd_def def = clq_crowd_def_init();
        def.cache = cache;
        fill(def);
        for (uint32_t i = 0; i < 3; ++i) EXPECT_LT(apart(i), 1e-6) << "cache " << cache;
    }
}

TEST_F(DrawnActor, UnpacksPackedVertices)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.vertex_format = CLQ_VERTEX_PACKED;
    fill(def);
    for (uint32_t i = 0; i < 3; ++i) {
        EXPECT_LT(apart(i), 1e-4);
        EXPECT_GT(apart(i), 1e-7) << "rounding leaves a difference";
    }
}

TEST_F(DrawnActor, HasThePaletteOfTheKeyPoseThatIsShared)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.key_poses.bands[0].distance_min_m = 0, def.key_poses.bands[0].mode = CLQ_KEY_POSE_INTERMITTENT;
    def.key_poses.band_count = 1, def.key_poses.max_kept = 64;
    fill(def);
    for (double time_s : {0.21, 0.22, 0.9}) {
        ASSERT_EQ(clq_crowd_update(crowd_, time_s, &view_, 1), CLQ_OK);
        for (uint32_t i = 0; i < 3; ++i) EXPECT_LT(apart(i), 1e-6);
    }
}

TEST_F(DrawnActor, HasNoMatrixPaletteForTwoBlendedKeyPoses)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.key_poses.bands[0].distance_min_m = 0, def.key_poses.bands[0].mode = CLQ_KEY_POSE_INTERPOLATED;
    def.key_poses.band_count = 1;
    fill(def);
    float palette[24], xyz[30];
    EXPECT_EQ(clq_view_get_palette(view_, 0, palette, 2), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("two key-poses"), std::string::npos) << clq_last_error();
    EXPECT_EQ(clq_view_get_vertices(view_, 0, xyz, nullptr, 10), CLQ_OK) << clq_last_error();
}

TEST_F(DrawnActor, GivesIdTransformAndColours)
{
    fill(clq_crowd_def_init());
    for (uint32_t i = 0; i < 3; ++i) {
        clq_drawn_actor shown = clq_drawn_actor_init();
        ASSERT_EQ(clq_view_get_drawn_actor(view_, i, &shown), CLQ_OK);
        EXPECT_EQ(shown.actor.index1, i + 1) << "front to back";
        EXPECT_EQ(shown.tmpl, tmpl_);
        EXPECT_EQ(shown.mirrored, i == 2);
        EXPECT_EQ(shown.vertex_count, 10u);
        EXPECT_EQ(shown.zone_count, 2u);
        EXPECT_FLOAT_EQ(shown.model_view[12], 2.0f * static_cast<float>(i) - 2);
        EXPECT_FLOAT_EQ(shown.model_view[14], -8.0f - static_cast<float>(i));
        uint8_t rgb[6];
        ASSERT_EQ(clq_view_get_colours(view_, i, rgb, 2), CLQ_OK);
        const uint8_t own[6] = {204, 51, 26, 230, 179, 153};  // the template's
        EXPECT_EQ(std::equal(rgb, rgb + 6, own), i != 1);
    }
}

TEST_F(DrawnActor, EachTriangleIsInOneBin)
{
    clq_mesh mesh = clq_mesh_init();
    ASSERT_EQ(clq_template_get_mesh(tmpl_, 0, &mesh), CLQ_OK);
    EXPECT_EQ(mesh.colours, nullptr);
    EXPECT_EQ(mesh.normals_by_inverse, 0);
    uint32_t corners = 0;
    for (uint32_t bin = 0; bin < mesh.bin_count; ++bin) {
        clq_triangles triangles = clq_triangles_init();
        ASSERT_EQ(clq_template_get_triangles(tmpl_, 0, bin, &triangles), CLQ_OK);
        EXPECT_TRUE(triangles.zone == CLQ_NONE || triangles.zone < 2);
        for (uint32_t i = 0; i < triangles.index_count; ++i) EXPECT_LT(triangles.indices[i], mesh.vertex_count);
        corners += triangles.index_count;
    }
    clq_template_info info = clq_template_info_init();
    ASSERT_EQ(clq_template_get_info(tmpl_, &info), CLQ_OK);
    EXPECT_EQ(corners, 3 * info.triangle_count);
    clq_wrap s, t;
    ASSERT_EQ(clq_template_get_wrap(tmpl_, 0, &s, &t), CLQ_OK);
    EXPECT_EQ(s, CLQ_WRAP_REPEAT);
}

TEST_F(DrawnActor, RefusesMissingItemsAndTooSmallBuffers)
{
    fill(clq_crowd_def_init());
    clq_drawn_actor shown = clq_drawn_actor_init();
    clq_mesh mesh = clq_mesh_init();
    clq_triangles triangles = clq_triangles_init();
    clq_morph_target target = clq_morph_target_init();
    float numbers[64];
    uint16_t joints[64];
    uint8_t rgb[6];
    const auto refused = [](clq_status status, const char *named) {
        EXPECT_EQ(status, CLQ_ARGUMENT);
        EXPECT_NE(std::string(clq_last_error()).find(named), std::string::npos) << clq_last_error();
    };
    refused(clq_view_get_drawn_actor(view_, 3, &shown), "individual 3");
    refused(clq_view_get_vertices(view_, 0, numbers, nullptr, 9), "room for 9 vertices");
    refused(clq_view_get_colours(view_, 0, rgb, 1), "room for 1 zones");
    refused(clq_view_get_palette(view_, 0, numbers, 1), "room for 1 joints");
    refused(clq_template_get_mesh(tmpl_, 1, &mesh), "level 1");
    refused(clq_template_get_triangles(tmpl_, 0, 99, &triangles), "bin 99");
    refused(clq_template_get_morph_target(tmpl_, 0, 0, &target), "morph target 0");
    refused(api_test::get_influences(tmpl_, 0, 1, joints, numbers, 64), "1 influences");
    refused(api_test::get_influences(tmpl_, 0, 2, joints, numbers, 19), "room for 19");
    clq_wrap s, t;
    refused(clq_template_get_wrap(tmpl_, 1, &s, &t), "texture 1");
    refused(clq_view_get_drawn_actor(nullptr, 0, &shown), "NULL");
}

}  // namespace
