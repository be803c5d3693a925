// Clips that are taken from another file keep their root motion where the joint that makes it is bound and the clip is
// not taken in place; a warning says where it is lost.
#include <claque/assets.h>
#include <claque/play.h>

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/gltf_maker.h"

namespace
{

using claque::testing::Json;
using claque::testing::Maker;

// Hips that go two units ahead in each clip of a second; `over` them is a node of that name, if any, and a tail below.
Maker walker(const std::vector<const char *> &clips, const char *over, bool with_tail)
{
    Maker maker;
    maker.triangle();
    Json &nodes = maker.json["nodes"];
    nodes[0]["name"] = "hips";
    if (with_tail) {
        maker.add("nodes", {{"name", "tail"}});
        nodes[0]["children"] = {1};
    }
    if (over) {
        const int top = maker.add("nodes", {{"name", over}, {"children", {0}}});
        maker.json["scenes"] = Json::array({{{"nodes", {top}}}});
    }
    for (const char *clip : clips) {
        const int times = maker.floats("SCALAR", 2, {0, 1}), places = maker.floats("VEC3", 2, {0, 0, 0, 0, 0, 2});
        maker.add("animations",
                  {{"name", clip},
                   {"samplers", Json::array({{{"input", times}, {"output", places}}})},
                   {"channels", Json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}})}});
    }
    return maker;
}

class ClipRootMotion : public testing::Test
{
protected:
    ClipRootMotion() { EXPECT_EQ(clq_context_create(nullptr, &context_), CLQ_OK); }
    ~ClipRootMotion() override
    {
        clq_template_destroy(tmpl_);
        clq_asset_destroy(target_), clq_asset_destroy(source_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
    }
    clq_asset *load(const Maker &maker)
    {
        const claque::testing::Bytes bytes = maker.glb();
        clq_asset *out = nullptr;
        EXPECT_EQ(clq_asset_load(context_, bytes.data(), bytes.size(), nullptr, &out), CLQ_OK) << clq_last_error();
        return out;
    }
    // Takes the clips of a source of three, of which "walk" moves by its hips and "swing" by its tail, into a target
    // with a clip of its own and, over its hips, a node that the source lacks; in this order.
    void take(const std::vector<const char *> &clips, clq_retarget_mode mode, clq_root_travel travel)
    {
        Maker maker = walker({"rest", "walk", "swing"}, nullptr, true);
        maker.json["animations"][1]["extras"]["claque"]["root_motion"] = "hips";
        maker.json["animations"][2]["extras"]["claque"]["root_motion"] = "tail";
        source_ = load(maker), target_ = load(walker({"own"}, "armature", false));
        clq_clips_def def = clq_clips_def_init();
        def.clips = clips.data(), def.clip_count = static_cast<uint32_t>(clips.size());
        def.mode = mode, def.travel = travel;
        clq_clips_report report = clq_clips_report_init();
        ASSERT_EQ(clq_asset_add_clips(context_, target_, source_, &def, &report), CLQ_OK) << clq_last_error();
        EXPECT_EQ(report.mode, mode);
        ASSERT_EQ(clq_asset_build(context_, target_, 0, &tmpl_), CLQ_OK) << clq_last_error();
    }
    // How far a clip of the target carries the body in half a second.
    double ahead(const char *clip) const
    {
        double step[3] = {-9, -9, -9};
        const uint32_t number = clq_template_find_clip(tmpl_, clip);
        EXPECT_EQ(clq_template_get_root_motion(tmpl_, number, 0.25, 0.75, step), CLQ_OK) << clq_last_error();
        EXPECT_EQ(step[0], 0);
        return step[1];
    }
    bool warns(const std::string &sentence) const
    {
        for (uint32_t i = 0; *clq_asset_get_warning(target_, i); ++i)
            if (std::string(clq_asset_get_warning(target_, i)).find(sentence) != std::string::npos) return true;
        return false;
    }

    clq_context *context_ = nullptr;
    clq_asset *source_ = nullptr, *target_ = nullptr;
    clq_template *tmpl_ = nullptr;
};

TEST_F(ClipRootMotion, IsKeptOfJointsThatAreBound)
{
    take({"swing", "rest", "walk"}, CLQ_RETARGET_CHANNELS, CLQ_ROOT_TRAVEL_IN_PLACE);
    EXPECT_NEAR(ahead("walk"), 1, 1e-3);
    for (const char *other : {"own", "rest", "swing"}) EXPECT_EQ(ahead(other), 0) << other;
    EXPECT_TRUE(warns("clip 'swing' has no root motion: 'tail' is not bound"));
    EXPECT_FALSE(warns("clip 'walk'"));
    EXPECT_FALSE(warns("clip 'rest'"));
}

TEST_F(ClipRootMotion, IsKeptByMotionThatTravels)
{
    take({"walk"}, CLQ_RETARGET_MOTION, CLQ_ROOT_TRAVEL_KEEP);
    EXPECT_NEAR(ahead("walk"), 1, 1e-3);
    EXPECT_EQ(ahead("own"), 0);
    EXPECT_FALSE(warns("root motion"));
}

TEST_F(ClipRootMotion, IsNoneOfMotionInPlace)
{
    take({"walk"}, CLQ_RETARGET_MOTION, CLQ_ROOT_TRAVEL_IN_PLACE);
    EXPECT_EQ(ahead("walk"), 0);
    EXPECT_TRUE(warns("clip 'walk' has no root motion: it is taken in place"));
}

}  // namespace
