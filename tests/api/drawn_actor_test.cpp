// What a view shows, as numbers, and its meshes.
#include "tests/api/drawn_actor_fixture.h"
#include "tests/api/saved_bytes.h"

namespace
{

using DrawnActor = api_test::DrawnActor;

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

// The list holds no palette of key-poses that are kept: it is found again, and not by the row, which restoring empties.
TEST_F(DrawnActor, StaysWhenAnotherStateIsRestored)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.key_poses.bands[0].distance_min_m = 0, def.key_poses.bands[0].mode = CLQ_KEY_POSE_INTERMITTENT;
    def.key_poses.band_count = 1, def.key_poses.max_kept = 64;
    fill(def);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.9, &view_, 1), CLQ_OK);
    const std::vector<uint8_t> saved = saved::save(crowd_);
    float before[3][24], after[24];
    for (uint32_t i = 0; i < 3; ++i)
        ASSERT_EQ(clq_view_get_palette(view_, i, before[i], 2), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_crowd_restore(crowd_, saved.data(), saved.size(), &tmpl_, 1), CLQ_OK) << clq_last_error();
    for (uint32_t i = 0; i < 3; ++i) {
        ASSERT_EQ(clq_view_get_palette(view_, i, after, 2), CLQ_OK) << clq_last_error();
        EXPECT_EQ(std::vector<float>(after, after + 24), std::vector<float>(before[i], before[i] + 24)) << i;
        EXPECT_LT(apart(i), 1e-6);
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
    clq_drawn_arrays held = clq_drawn_arrays_init();
    EXPECT_EQ(clq_view_get_arrays(view_, 0, &held), CLQ_OK) << clq_last_error();
    EXPECT_EQ(held.palette, nullptr);
    EXPECT_NE(held.positions, nullptr);
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
    clq_drawn_arrays held = clq_drawn_arrays_init();
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
    refused(clq_view_get_arrays(view_, 3, &held), "individual 3");
    refused(clq_view_get_arrays(view_, 0, nullptr), "NULL");
    held.struct_bytes = 0;
    EXPECT_EQ(clq_view_get_arrays(view_, 0, &held), CLQ_STRUCT_SIZE);
}

}  // namespace
