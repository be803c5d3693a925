// Wrong arguments of libclaque-assets give a status and a sentence, and change neither the asset nor what is returned.
#include <claque/levels.h>
#include <claque/prepare.h>
#include <claque/zones.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/expect_refused.h"

namespace
{

class AssetArguments : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        ASSERT_EQ(clq_asset_builtin(context_, "citizen", &asset_), CLQ_OK);
    }
    void TearDown() override
    {
        EXPECT_EQ(made_, nullptr) << "out parameters are written on success alone";
        EXPECT_EQ(built_, nullptr);
        clq_asset_destroy(asset_), clq_asset_destroy(source_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
    }
    clq_asset_info info() const
    {
        clq_asset_info found = clq_asset_info_init();
        EXPECT_EQ(clq_asset_get_info(asset_, &found), CLQ_OK);
        return found;
    }

    const clq_asset *source()
    {
        if (!source_) EXPECT_EQ(clq_asset_builtin(context_, "patrician", &source_), CLQ_OK);
        return source_;
    }

    clq_context *context_ = nullptr;
    clq_asset *asset_ = nullptr;
    clq_asset *made_ = nullptr;
    clq_template *built_ = nullptr;

private:
    clq_asset *source_ = nullptr;
};

TEST_F(AssetArguments, ChoicesThatDoNotExistAreRefused)
{
    clq_asset_options options = clq_asset_options_init();
    options.blend = static_cast<clq_blend>(CLQ_BLEND_MASK + 1);
    expect_refused(clq_asset_load(context_, "a", 1, &options, &made_), "blend is none of CLQ_BLEND_...");
    options = clq_asset_options_init();
    options.colours = static_cast<clq_colours>(CLQ_COLOURS_OWN + 1);
    expect_refused(clq_asset_load(context_, "a", 1, &options, &made_), "colours is none of CLQ_COLOURS_...");
}

TEST_F(AssetArguments, NullPointersAreRefusedByEveryCallThatMakesSomething)
{
    const std::string load = "clq_asset_load: context, bytes or out is NULL";
    expect_refused(clq_asset_load(nullptr, "a", 1, nullptr, &made_), load);
    expect_refused(clq_asset_load(context_, nullptr, 1, nullptr, &made_), load);
    expect_refused(clq_asset_load(context_, "a", 1, nullptr, nullptr), load);
    const std::string file = "clq_asset_load_file: context, path or out is NULL";
    expect_refused(clq_asset_load_file(nullptr, "a", nullptr, &made_), file);
    expect_refused(clq_asset_load_file(context_, nullptr, nullptr, &made_), file);
    expect_refused(clq_asset_load_file(context_, "a", nullptr, nullptr), file);
    const std::string builtin = "clq_asset_builtin: context, name or out is NULL";
    expect_refused(clq_asset_builtin(nullptr, "owl", &made_), builtin);
    expect_refused(clq_asset_builtin(context_, nullptr, &made_), builtin);
    expect_refused(clq_asset_builtin(context_, "owl", nullptr), builtin);
    const std::string varied = "clq_asset_builtin_varied: context, name or out is NULL";
    expect_refused(clq_asset_builtin_varied(nullptr, "citizen", 30, &made_), varied);
    expect_refused(clq_asset_builtin_varied(context_, nullptr, 30, &made_), varied);
    expect_refused(clq_asset_builtin_varied(context_, "citizen", 30, nullptr), varied);
    const std::string build = "clq_asset_build: context, asset or out is NULL";
    expect_refused(clq_asset_build(nullptr, asset_, 0, &built_), build);
    expect_refused(clq_asset_build(context_, nullptr, 0, &built_), build);
    expect_refused(clq_asset_build(context_, asset_, 0, nullptr), build);
    const std::string gltf = "clq_template_load_gltf: context, bytes or out is NULL";
    expect_refused(clq_template_load_gltf(nullptr, "a", 1, nullptr, &built_), gltf);
    expect_refused(clq_template_load_gltf(context_, nullptr, 1, nullptr, &built_), gltf);
    expect_refused(clq_template_load_gltf(context_, "a", 1, nullptr, nullptr), gltf);
    const std::string ready = "clq_template_builtin: context, name or out is NULL";
    expect_refused(clq_template_builtin(nullptr, "owl", &built_), ready);
    expect_refused(clq_template_builtin(context_, nullptr, &built_), ready);
    expect_refused(clq_template_builtin(context_, "owl", nullptr), ready);
    const std::string prepare = "clq_template_prepare: context, def or out is NULL";
    const clq_prepare_def def = clq_prepare_def_init();
    expect_refused(clq_template_prepare(nullptr, &def, &built_, nullptr), prepare);
    expect_refused(clq_template_prepare(context_, nullptr, &built_, nullptr), prepare);
    expect_refused(clq_template_prepare(context_, &def, nullptr, nullptr), prepare);
    clq_asset_destroy(nullptr);
}

TEST_F(AssetArguments, NullPointersAreRefusedByEveryCallThatChangesAnAsset)
{
    const std::string clips = "clq_asset_add_clips: context, asset or source is NULL";
    expect_refused(clq_asset_add_clips(nullptr, asset_, source(), nullptr, nullptr), clips);
    expect_refused(clq_asset_add_clips(context_, nullptr, source(), nullptr, nullptr), clips);
    expect_refused(clq_asset_add_clips(context_, asset_, nullptr, nullptr, nullptr), clips);
    const std::string set = "clq_asset_add_texture_set: context, asset or name is NULL";
    expect_refused(clq_asset_add_texture_set(nullptr, asset_, "a", nullptr, 0), set);
    expect_refused(clq_asset_add_texture_set(context_, nullptr, "a", nullptr, 0), set);
    expect_refused(clq_asset_add_texture_set(context_, asset_, nullptr, nullptr, 0), set);
    const std::string map = "clq_asset_set_zone_map: context, asset or def is NULL";
    const clq_zone_map_def zones = clq_zone_map_def_init();
    expect_refused(clq_asset_set_zone_map(nullptr, asset_, &zones), map);
    expect_refused(clq_asset_set_zone_map(context_, nullptr, &zones), map);
    expect_refused(clq_asset_set_zone_map(context_, asset_, nullptr), map);
    expect_refused(clq_asset_make_levels(nullptr, asset_, nullptr, nullptr),
                   "clq_asset_make_levels: context or asset is NULL");
    expect_refused(clq_asset_make_levels(context_, nullptr, nullptr, nullptr), "context or asset is NULL");
}

// Each getter of a struct refuses a missing asset, a missing struct, one of another header, and an index too large.
TEST_F(AssetArguments, GettersRefuseWhatTheyCannotFill)
{
    const auto tried = [&](auto get, auto filled, const std::string &name, const char *beyond) {
        expect_refused(get(nullptr, 0, &filled), name + ": asset or out is NULL");
        expect_refused(get(asset_, 0, static_cast<decltype(&filled)>(nullptr)), name + ": asset or out is NULL");
        if (beyond) expect_refused(get(asset_, 9999, &filled), name + ": " + beyond);
        filled.struct_bytes -= 1;
        expect_refused(get(asset_, 0, &filled), name + ": struct_bytes is ", CLQ_STRUCT_SIZE);
    };
    tried([](const clq_asset *asset, uint32_t, clq_asset_info *out) { return clq_asset_get_info(asset, out); },
          clq_asset_info_init(), "clq_asset_get_info", nullptr);
    tried(clq_asset_get_part, clq_asset_part_init(), "clq_asset_get_part", "part 9999 does not exist: 'citizen' has 1");
    tried(clq_asset_get_node, clq_asset_node_init(), "clq_asset_get_node",
          "node 9999 does not exist: 'citizen' has 33");
    tried(clq_asset_get_clip, clq_clip_info_init(), "clq_asset_get_clip", "clip 9999 does not exist: 'citizen' has 23");
    tried(clq_asset_get_image, clq_asset_image_init(), "clq_asset_get_image",
          "image 9999 does not exist: 'citizen' has");
    tried(clq_asset_get_level_report, clq_level_report_init(), "clq_asset_get_level_report",
          "level 9999 does not exist: for 'citizen' 0 were made");
    EXPECT_STREQ(clq_asset_get_warning(nullptr, 0), "");
    EXPECT_STREQ(clq_asset_get_warning(asset_, 0), "") << "a built-in character has no warning";
    EXPECT_STREQ(clq_asset_get_morph_name(nullptr, 0, 0), "");
    EXPECT_STREQ(clq_asset_get_morph_name(asset_, info().part_count, 0), "");
    EXPECT_STREQ(clq_asset_get_zone_name(nullptr, 0), "");
    EXPECT_STRNE(clq_asset_get_zone_name(asset_, info().zone_count - 1), "");
    EXPECT_STREQ(clq_asset_get_zone_name(asset_, info().zone_count), "");
}

TEST_F(AssetArguments, PositionsNeedAClipAndRoom)
{
    std::vector<float> xyz(3 * info().vertex_count, 7.0f);
    const std::string null = "asset or out_xyz is NULL";
    expect_refused(clq_asset_get_positions(nullptr, 0, 0, xyz.data(), xyz.size()), null);
    expect_refused(clq_asset_get_positions(asset_, 0, 0, nullptr, xyz.size()), null);
    expect_refused(clq_asset_get_positions(asset_, 23, 0, xyz.data(), xyz.size()),
                   "clip 23 does not exist: 'citizen' has 23");
    expect_refused(clq_asset_get_positions(asset_, 0, 0, xyz.data(), xyz.size() - 1),
                   std::to_string(xyz.size() - 1) + " floats for " + std::to_string(xyz.size() / 3) + " vertices");
    EXPECT_EQ(xyz, std::vector<float>(xyz.size(), 7.0f));
    EXPECT_EQ(clq_asset_get_positions(asset_, 22, 0, xyz.data(), xyz.size()), CLQ_OK) << clq_last_error();
    EXPECT_NE(xyz.back(), 7.0f);
}

TEST_F(AssetArguments, NamesThatAreNotBuiltInAreToldThoseThatAre)
{
    const std::string all = "citizen, patrician, decurion, plebeian, herald, owl";
    expect_refused(clq_asset_builtin(context_, "senator", &made_),
                   "there is no built-in character 'senator'; there are: " + all);
    expect_refused(clq_asset_builtin(context_, "Citizens", &made_),
                   "there is no built-in character 'Citizens': 'citizen' is near");
    expect_refused(clq_asset_builtin_varied(context_, "owl", 30, &made_),
                   "there is no built-in person 'owl'; there are: citizen, patrician, decurion, plebeian");
    expect_refused(clq_asset_builtin_varied(context_, "citizen", 22, &made_), "22 clips: 23 to 2000 are wanted");
    expect_refused(clq_asset_builtin_varied(context_, "citizen", 2001, &made_), "2001 clips: 23 to 2000 are wanted");
    for (const uint32_t count : {23u, 24u}) {
        clq_asset *varied = nullptr;
        ASSERT_EQ(clq_asset_builtin_varied(context_, "citizen", count, &varied), CLQ_OK) << clq_last_error();
        clq_asset_info found = clq_asset_info_init();
        EXPECT_EQ(clq_asset_get_info(varied, &found), CLQ_OK);
        EXPECT_EQ(found.clip_count, count);
        clq_asset_destroy(varied);
    }
}

TEST_F(AssetArguments, OptionsWithNamesThatAreNullAreRefused)
{
    clq_asset_options options = clq_asset_options_init();
    options.hidden_node_count = 2;
    expect_refused(clq_asset_load(context_, "a", 1, &options, &made_), "hidden_nodes is NULL with a count");
    const char *const names[2] = {"hat", nullptr};
    options.hidden_nodes = names;
    expect_refused(clq_asset_load(context_, "a", 1, &options, &made_), "a hidden node's name is NULL");
    expect_refused(clq_template_load_gltf(context_, "a", 1, &options, &built_), "a hidden node's name is NULL");
    options.struct_bytes = 3;
    expect_refused(clq_asset_load_file(context_, "a", &options, &made_), "clq_asset_options_init gives",
                   CLQ_STRUCT_SIZE);
    expect_refused(clq_template_load_gltf(context_, "a", 1, &options, &built_), "struct_bytes is 3", CLQ_STRUCT_SIZE);
}

TEST_F(AssetArguments, WhatPrepareCannotUseTogetherIsRefused)
{
    const auto wrong = [&](const char *sentence, const std::function<void(clq_prepare_def &)> &breaks,
                           clq_status status = CLQ_ARGUMENT) {
        clq_prepare_def def = clq_prepare_def_init();
        def.builtin = "owl", def.folder = "";
        breaks(def);
        expect_refused(clq_template_prepare(context_, &def, &built_, nullptr), sentence, status);
    };
    const std::string folder = testing::TempDir() + "claque_asset_arguments";
    clq_asset_options options = clq_asset_options_init();
    clq_levels_def levels = clq_levels_def_init();
    levels.target_count = 1;
    wrong("either builtin or path is wanted, not both", [](clq_prepare_def &def) { def.path = "a.glb"; });
    wrong("clip_count needs builtin",
          [](clq_prepare_def &def) { def.builtin = nullptr, def.path = "a", def.clip_count = 30; });
    wrong("options go with path alone", [&](clq_prepare_def &def) { def.options = &options; });
    wrong("degrees of freedom is NULL with a count of 2", [](clq_prepare_def &def) { def.dof_count = 2; });
    wrong("targets is NULL with a count of 1",
          [&](clq_prepare_def &def) { def.levels = &levels, def.folder = folder.c_str(); });
    wrong("22 clips: 23 to 2000 are wanted",
          [](clq_prepare_def &def) { def.builtin = "citizen", def.clip_count = 22; });
    levels.struct_bytes = options.struct_bytes = 5;
    wrong(
        "clq_levels_def_init gives", [&](clq_prepare_def &def) { def.levels = &levels; }, CLQ_STRUCT_SIZE);
    wrong(
        "clq_asset_options_init gives",
        [&](clq_prepare_def &def) { def.builtin = nullptr, def.path = "a", def.options = &options; }, CLQ_STRUCT_SIZE);
    clq_prepare_def def = clq_prepare_def_init();
    def.builtin = "owl";
    clq_prepare_report report = clq_prepare_report_init();
    report.struct_bytes = 2;
    expect_refused(clq_template_prepare(context_, &def, &built_, &report), "clq_prepare_report_init gives",
                   CLQ_STRUCT_SIZE);
}

}  // namespace
