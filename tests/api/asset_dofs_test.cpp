// Degrees of freedom that a host adds to a character: templates have them, a gaze writes them, and what breaks a rule
// changes nothing.
#include <claque/behave.h>
#include <claque/prepare.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace
{

clq_asset_dof turning(const char *node, const char *name, int axis, float most_rad)
{
    clq_asset_dof made = clq_asset_dof_init();
    made.node_name = node;
    made.dof.name = name, made.dof.axis[axis] = 1, made.dof.min = -most_rad, made.dof.max = most_rad;
    made.dof.node = 1000000;  // not read
    return made;
}

class AssetDofs : public testing::Test
{
protected:
    void SetUp() override { ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK); }
    void TearDown() override
    {
        clq_asset_destroy(asset_);
        clq_template_destroy(tmpl_);
        clq_context_destroy(context_);
    }
    void load(const char *name) { ASSERT_EQ(clq_asset_builtin(context_, name, &asset_), CLQ_OK); }
    clq_status add(const std::vector<clq_asset_dof> &dofs)
    {
        return clq_asset_add_dofs(context_, asset_, dofs.data(), static_cast<uint32_t>(dofs.size()));
    }
    uint32_t built_dofs()
    {
        clq_template_destroy(tmpl_);
        EXPECT_EQ(clq_asset_build(context_, asset_, 0, &tmpl_), CLQ_OK) << clq_last_error();
        clq_template_info info = clq_template_info_init();
        EXPECT_EQ(clq_template_get_info(tmpl_, &info), CLQ_OK);
        return info.dof_count;
    }

    const std::vector<clq_asset_dof> head_ = {turning("neck", "neck_yaw", 1, 0.6f),
                                              turning("head", "head_yaw", 1, 0.6f)};
    clq_context *context_ = nullptr;
    clq_asset *asset_ = nullptr;
    clq_template *tmpl_ = nullptr;
};

TEST_F(AssetDofs, StandBehindThoseOfTheCharacter)
{
    load("owl");
    const uint32_t own = built_dofs();
    ASSERT_EQ(add({turning("neck", "roll", 2, 0.5f)}), CLQ_OK) << clq_last_error();
    ASSERT_EQ(built_dofs(), own + 1);
    clq_dof_info info = clq_dof_info_init();
    ASSERT_EQ(clq_template_get_dof(tmpl_, own, &info), CLQ_OK);
    EXPECT_STREQ(info.name, "roll");
    EXPECT_EQ(info.node, clq_template_find_node(tmpl_, "neck"));
    EXPECT_FLOAT_EQ(info.max, 0.5f);
}

// Where the head of a person looks along x, one second after it was told to look at a point.
double head_to_the_left(clq_context *context, clq_template *tmpl, double x)
{
    clq_crowd *crowd = nullptr;
    EXPECT_EQ(clq_crowd_create(context, nullptr, &crowd), CLQ_OK);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = tmpl;
    clq_actor actor = {};
    EXPECT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK);
    clq_mechanism_def gaze = clq_mechanism_def_init();
    gaze.kind = CLQ_MECHANISM_GAZE, gaze.tmpl = tmpl;
    gaze.gaze.neck_yaw = 0, gaze.gaze.eye_yaw[0] = 1, gaze.gaze.eyes[1] = 1.6f;
    clq_mechanism_attachment use = clq_mechanism_attachment_init();
    EXPECT_EQ(clq_crowd_add_mechanism(crowd, &gaze, &use.mechanism), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_actor_attach_mechanism(crowd, actor, &use), CLQ_OK);
    const double point[3] = {x, 1.6, 2};
    EXPECT_EQ(clq_actor_gaze(crowd, actor, use.mechanism, point, 0), CLQ_OK);
    double m[16] = {};
    EXPECT_EQ(clq_actor_get_node(crowd, actor, clq_template_find_node(tmpl, "head"), 1, m), CLQ_OK);
    clq_crowd_destroy(crowd);
    return m[8];
}

TEST_F(AssetDofs, LetAGazeTurnTheHeadOfABuiltInPerson)
{
    load("citizen");
    ASSERT_EQ(add(head_), CLQ_OK) << clq_last_error();
    ASSERT_EQ(built_dofs(), 2u);
    EXPECT_NEAR(head_to_the_left(context_, tmpl_, 1), std::sin(std::atan2(1, 2)), 0.05);
    EXPECT_NEAR(head_to_the_left(context_, tmpl_, -1), -std::sin(std::atan2(1, 2)), 0.05);
}

TEST_F(AssetDofs, ThatBreakARuleChangeNothing)
{
    load("citizen");
    const auto refused = [&](const std::function<void(clq_asset_dof &)> &breaks, const char *told) {
        std::vector<clq_asset_dof> dofs = head_;
        breaks(dofs[1]);
        EXPECT_EQ(add(dofs), CLQ_ARGUMENT);
        EXPECT_NE(std::string(clq_last_error()).find(told), std::string::npos) << clq_last_error();
    };
    refused([](clq_asset_dof &dof) { dof.node_name = "beak"; }, "'beak'");
    refused([](clq_asset_dof &dof) { dof.node_name = nullptr; }, "does not exist");
    refused([](clq_asset_dof &dof) { dof.dof.axis[1] = 2; }, "axis of length 2");
    refused([](clq_asset_dof &dof) { dof.dof.rest = 3; }, "rests at 3");
    refused([](clq_asset_dof &dof) { dof.dof.kind = static_cast<clq_dof_kind>(7); }, "unknown kind");
    refused([](clq_asset_dof &dof) { dof.dof.kind = CLQ_DOF_MORPH; }, "has no morphed part");
    EXPECT_EQ(clq_asset_add_dofs(context_, asset_, nullptr, 1), CLQ_ARGUMENT);
    EXPECT_EQ(clq_asset_add_dofs(context_, nullptr, head_.data(), 2), CLQ_ARGUMENT);
    EXPECT_EQ(clq_asset_add_dofs(context_, asset_, nullptr, 0), CLQ_OK);
    EXPECT_EQ(built_dofs(), 0u);
}

TEST_F(AssetDofs, MakeAnotherPreparedTemplate)
{
    const std::string folder = testing::TempDir() + "claque_asset_dofs";
    std::filesystem::remove_all(folder);
    clq_prepare_def def = clq_prepare_def_init();
    def.builtin = "owl", def.folder = folder.c_str();
    std::vector<clq_asset_dof> dofs = {turning("neck", "roll", 2, 0.5f)};
    const auto from_disk = [&](uint32_t dof_count) {
        def.dofs = dofs.data(), def.dof_count = dof_count;
        clq_template_destroy(tmpl_);
        tmpl_ = nullptr;
        clq_prepare_report report = clq_prepare_report_init();
        EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl_, &report), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_template_find_dof(tmpl_, "roll") != CLQ_NONE, dof_count == 1);
        return report.from_disk;
    };
    EXPECT_FALSE(from_disk(0));
    EXPECT_FALSE(from_disk(1));
    EXPECT_TRUE(from_disk(1));
    dofs[0].dof.max = 0.4f;
    EXPECT_FALSE(from_disk(1)) << "another range";
    dofs[0].node_name = "head";
    EXPECT_FALSE(from_disk(1)) << "another node";
    def.struct_bytes = offsetof(clq_prepare_def, dofs);  // of a host that knows no such members
    EXPECT_TRUE(from_disk(0));
    std::filesystem::remove_all(folder);
}

}  // namespace
