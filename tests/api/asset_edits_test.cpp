// Clips, texture sets, zone maps and levels that break a rule are refused by name and number, and the asset stays.
#include <claque/levels.h>
#include <claque/zones.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace
{

class AssetEdits : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        ASSERT_EQ(clq_asset_builtin(context_, "citizen", &asset_), CLQ_OK);
        ASSERT_EQ(clq_asset_get_info(asset_, &before_), CLQ_OK);
    }
    void TearDown() override
    {
        clq_asset_destroy(asset_), clq_asset_destroy(source_);
        clq_context_destroy(context_);
    }
    void told(clq_status status, const std::string &sentence, clq_status wanted = CLQ_ARGUMENT) const
    {
        EXPECT_EQ(status, wanted) << sentence;
        EXPECT_NE(std::string(clq_last_error()).find(sentence), std::string::npos)
            << clq_last_error() << "\nand not: " << sentence;
        clq_asset_info now = clq_asset_info_init();
        ASSERT_EQ(clq_asset_get_info(asset_, &now), CLQ_OK);
        EXPECT_EQ(now.clip_count, before_.clip_count) << sentence;
        EXPECT_EQ(now.image_count, before_.image_count) << sentence;
        EXPECT_EQ(now.zone_count, before_.zone_count) << sentence;
        EXPECT_EQ(now.warning_count, before_.warning_count) << sentence;
    }

    const clq_asset *source()
    {
        if (!source_) EXPECT_EQ(clq_asset_builtin(context_, "patrician", &source_), CLQ_OK);
        return source_;
    }

    clq_context *context_ = nullptr;
    clq_asset *asset_ = nullptr;
    clq_asset_info before_ = clq_asset_info_init();

private:
    clq_asset *source_ = nullptr;
};

TEST_F(AssetEdits, ClipsThatCannotBeTakenAreRefused)
{
    const auto wrong = [&](const char *sentence, const std::function<void(clq_clips_def &)> &breaks) {
        clq_clips_def def = clq_clips_def_init();
        breaks(def);
        told(clq_asset_add_clips(context_, asset_, source(), &def, nullptr), sentence);
    };
    clq_joint_pair pair = {"hips", "hips", CLQ_REST_KEEP};
    const char *clip = "walk";
    clq_follower follower = {"head", "neck", 0.5f};
    const auto with_pair = [&](clq_clips_def &def) { def.joints = &pair, def.joint_count = 1; };
    const auto with_follower = [&](clq_clips_def &def) { def.followers = &follower, def.follower_count = 1; };
    wrong("joints is NULL with a count of 2", [](clq_clips_def &def) { def.joint_count = 2; });
    wrong("clips is NULL with a count of 3", [](clq_clips_def &def) { def.clip_count = 3; });
    wrong("followers is NULL with a count of 4", [](clq_clips_def &def) { def.follower_count = 4; });
    pair.source = nullptr;
    wrong("a joint's source or target is NULL", with_pair);
    pair = {"hips", nullptr, CLQ_REST_KEEP};
    wrong("a joint's source or target is NULL", with_pair);
    pair = {"hips", "hips", static_cast<clq_rest_alignment>(2)};
    wrong("rest is 2: 0 to 1 are known", with_pair);
    clip = nullptr;
    wrong("a clip's name is NULL", [&](clq_clips_def &def) { def.clips = &clip, def.clip_count = 1; });
    clip = "fly";
    wrong("there is no clip 'fly' among the 23 clips",
          [&](clq_clips_def &def) { def.clips = &clip, def.clip_count = 1; });
    follower.joint = nullptr;
    wrong("a follower's joint or leader is NULL", with_follower);
    follower = {"head", nullptr, 0.5f};
    wrong("a follower's joint or leader is NULL", with_follower);
    wrong("mode is 3: 0 to 2 are known", [](clq_clips_def &def) { def.mode = static_cast<clq_retarget_mode>(3); });
    wrong("travel is 2: 0 to 1 are known", [](clq_clips_def &def) { def.travel = static_cast<clq_root_travel>(2); });
    wrong("rest is 5: 0 to 4 are known", [](clq_clips_def &def) { def.rest = static_cast<clq_source_rest>(5); });
    wrong("the skeleton is to rest as in frame 999, and clip 'stand' has the frames 0 to",
          [](clq_clips_def &def) { def.rest = CLQ_SOURCE_REST_FRAME, def.rest_frame = 999; });
    const auto in_motion = [](auto change) {
        return [change](clq_clips_def &def) {
            def.mode = CLQ_RETARGET_MOTION;
            change(def);
        };
    };
    wrong("the rate is 0.5 keys per second: it must be from 1 to 1000",
          in_motion([](clq_clips_def &def) { def.rate_hz = 0.5f; }));
    wrong("the rate is 1001 keys", in_motion([](clq_clips_def &def) { def.rate_hz = 1001; }));
    wrong("the range of the clips is -1 s to", in_motion([](clq_clips_def &def) { def.start_s = -1; }));
    wrong("the range of the clips is 2 s to 1 s",
          in_motion([](clq_clips_def &def) { def.start_s = 2, def.end_s = 1; }));
    wrong("the time to close clips is -1 s", in_motion([](clq_clips_def &def) { def.close_s = -1; }));
    told(clq_asset_add_clips(context_, asset_, asset_, nullptr, nullptr), "the source of clips is the asset itself");
    clq_clips_report report = clq_clips_report_init();
    report.struct_bytes = 1;
    told(clq_asset_add_clips(context_, asset_, source(), nullptr, &report), "clq_clips_report_init gives",
         CLQ_STRUCT_SIZE);
    clq_clips_def def = clq_clips_def_init();
    def.struct_bytes = 1;
    told(clq_asset_add_clips(context_, asset_, source(), &def, nullptr), "clq_clips_def_init gives", CLQ_STRUCT_SIZE);
}

TEST_F(AssetEdits, ClipsOfEqualSkeletonsAreCopiedAndCounted)
{
    clq_clips_report report = clq_clips_report_init();
    ASSERT_EQ(clq_asset_add_clips(context_, asset_, source(), nullptr, &report), CLQ_OK) << clq_last_error();
    EXPECT_EQ(report.mode, CLQ_RETARGET_CHANNELS);
    EXPECT_EQ(report.clip_count, 23u);
    clq_clips_def def = clq_clips_def_init();
    def.end_s = 0.5f, def.prefix = "short ";
    const char *walk = "walk";
    def.clips = &walk, def.clip_count = 1;
    ASSERT_EQ(clq_asset_add_clips(context_, asset_, source(), &def, &report), CLQ_OK) << clq_last_error();
    EXPECT_EQ(report.mode, CLQ_RETARGET_MOTION) << "a part of a clip is taken by motion";
    EXPECT_EQ(report.clip_count, 1u);
    clq_clip_info clip = clq_clip_info_init();
    ASSERT_EQ(clq_asset_get_clip(asset_, 46, &clip), CLQ_OK);
    EXPECT_STREQ(clip.name, "short walk");
    EXPECT_FLOAT_EQ(clip.duration_s, 0.5f);
}

TEST_F(AssetEdits, TextureSetsThatDoNotFitAreRefused)
{
    const std::vector<uint8_t> rgba(4 * 4 * 4, 255);
    std::vector<clq_image_def> images(before_.material_count, clq_image_def_init());
    const auto wrong = [&](const std::string &sentence, const std::function<void(clq_image_def &)> &breaks) {
        images.back() = clq_image_def_init();
        images.back().width_px = images.back().height_px = 4, images.back().rgba = rgba.data();
        images.back().alpha = CLQ_ALPHA_ZONE_KEYS;
        breaks(images.back());
        told(clq_asset_add_texture_set(context_, asset_, "winter", images.data(), before_.material_count), sentence);
    };
    const std::string last = "the image for material " + std::to_string(before_.material_count - 1);
    told(clq_asset_add_texture_set(context_, asset_, "winter", nullptr, 1), "images is NULL with a count of 1");
    told(clq_asset_add_texture_set(context_, asset_, "winter", images.data(), before_.material_count + 1),
         std::to_string(before_.material_count + 1) + " images for 'citizen', which has " +
             std::to_string(before_.material_count) + " materials");
    wrong(last + " is 0 x 4 pixels: 1 to", [](clq_image_def &image) { image.width_px = 0; });
    wrong(last + " is 4 x 100000 pixels: 1 to", [](clq_image_def &image) { image.height_px = 100000; });
    wrong(last + " has an unknown meaning of alpha",
          [](clq_image_def &image) { image.alpha = static_cast<clq_alpha_meaning>(2); });
    wrong("winter", [](clq_image_def &image) { image.alpha = CLQ_ALPHA_OPACITY; });
}

TEST_F(AssetEdits, ZoneMapsThatNameNothingAreRefused)
{
    const std::vector<uint16_t> texels = {0, 1, 1, CLQ_NO_ZONE};
    clq_zone_map_zone zones[2] = {{"skin", true, nullptr}, {"cloth", false, nullptr}};
    const auto wrong = [&](const char *sentence, const std::function<void(clq_zone_map_def &)> &breaks,
                           clq_status status = CLQ_ARGUMENT) {
        clq_zone_map_def def = clq_zone_map_def_init();
        def.width_px = def.height_px = 2, def.texels = texels.data(), def.zones = zones, def.zone_count = 2;
        breaks(def);
        told(clq_asset_set_zone_map(context_, asset_, &def), sentence, status);
    };
    wrong("texels is NULL", [](clq_zone_map_def &def) { def.texels = nullptr; });
    wrong("zones is NULL with a count of 2", [](clq_zone_map_def &def) { def.zones = nullptr; });
    wrong("image 99 does not exist: 'citizen' has", [](clq_zone_map_def &def) { def.image = 99; });
    wrong("a zone map of 0 x 2 texels", [](clq_zone_map_def &def) { def.width_px = 0; });
    wrong("a zone map of 2 x 0 texels", [](clq_zone_map_def &def) { def.height_px = 0; });
    wrong("texel (1, 0) of the zone map names zone 1, which does not exist: there are 1",
          [](clq_zone_map_def &def) { def.zone_count = 1; });
    wrong(
        "struct_bytes is 9", [](clq_zone_map_def &def) { def.struct_bytes = 9; }, CLQ_STRUCT_SIZE);
    const std::vector<uint16_t> none(4, CLQ_NO_ZONE);
    wrong("the zone map of 2 x 2 texels names no zone anywhere",
          [&](clq_zone_map_def &def) { def.texels = none.data(); });
    const std::vector<clq_zone_map_zone> many(257, zones[0]);
    wrong(
        "257 zones for one image: 256 are the most",
        [&](clq_zone_map_def &def) { def.zones = many.data(), def.zone_count = 257; }, CLQ_LIMIT);
    zones[1].name = nullptr;
    wrong("zone 1 has no name", [](clq_zone_map_def &) {});
    zones[1].name = "";
    wrong("zone 1 has no name", [](clq_zone_map_def &) {});
}

// Each of the six numbers, on both sides and as no number.
TEST_F(AssetEdits, ZonesWithARangeThatLeavesItsScaleAreRefused)
{
    const uint16_t texel = 0;
    clq_hsb_range range = {0, 360, 0, 1, 0, 1};
    const clq_zone_map_zone zone = {"skin", true, &range};
    clq_zone_map_def def = clq_zone_map_def_init();
    def.width_px = def.height_px = 1, def.texels = &texel, def.zones = &zone, def.zone_count = 1;
    for (float *member : {&range.hue_min_deg, &range.hue_max_deg, &range.saturation_min, &range.saturation_max,
                          &range.brightness_min, &range.brightness_max}) {
        const float kept = *member, last = member < &range.saturation_min ? 360 : 1;
        for (const float value : {-1e-6f, std::nextafter(last, 999.0f), NAN}) {
            *member = value;
            told(clq_asset_set_zone_map(context_, asset_, &def),
                 "zone 'skin' has a range that leaves [0, 360] degrees or [0, 1]");
        }
        *member = kept;
    }
    const clq_hsb_range bounds[] = {range, {360, 360, 1, 1, 1, 1}, {0, 0, 0, 0, 0, 0}};
    for (const clq_hsb_range &taken : bounds) {
        range = taken;
        clq_asset *asset = nullptr;
        ASSERT_EQ(clq_asset_builtin(context_, "citizen", &asset), CLQ_OK);
        EXPECT_EQ(clq_asset_set_zone_map(context_, asset, &def), CLQ_OK) << clq_last_error();
        EXPECT_STREQ(clq_asset_get_zone_name(asset, 0), "skin");
        clq_asset_destroy(asset);
    }
}

TEST_F(AssetEdits, ProposalsNeedRoomForEachTexel)
{
    clq_asset_image image = clq_asset_image_init();
    ASSERT_EQ(clq_asset_get_image(asset_, 0, &image), CLQ_OK);
    const size_t texels = size_t(image.width_px) * image.height_px;
    std::vector<uint16_t> zones(texels, 7);
    std::vector<uint8_t> rgb(3 * 4, 9);
    clq_zone_proposal wanted = clq_zone_proposal_init();
    const auto propose = [&] { return clq_asset_propose_zones(asset_, 0, &wanted); };
    told(clq_asset_propose_zones(nullptr, 0, &wanted), "asset or out is NULL");
    told(clq_asset_propose_zones(asset_, 0, nullptr), "asset or out is NULL");
    told(propose(), "texels or rgb is NULL");
    wanted.max_zones = 4, wanted.texels = zones.data(), wanted.capacity_texels = texels - 1;
    told(propose(), "texels or rgb is NULL");
    wanted.rgb = rgb.data();
    told(propose(), "room for " + std::to_string(texels - 1) + " texels of an image of " +
                        std::to_string(image.width_px) + " x " + std::to_string(image.height_px));
    wanted.capacity_texels = texels;
    for (const uint32_t count : {0u, 49u}) {
        wanted.max_zones = count;
        told(propose(), std::to_string(count) + " zones to propose: 1 to 48 are wanted");
    }
    wanted.max_zones = 4;
    told(clq_asset_propose_zones(asset_, 99, &wanted), "image 99 does not exist: 'citizen' has");
    EXPECT_EQ(zones, std::vector<uint16_t>(texels, 7));
    EXPECT_EQ(rgb, std::vector<uint8_t>(12, 9));
    ASSERT_EQ(propose(), CLQ_OK) << clq_last_error();
    EXPECT_GE(wanted.zone_count, 1u);
    EXPECT_NE(zones, std::vector<uint16_t>(texels, 7));
}

TEST_F(AssetEdits, LevelsThatCannotBeMadeAreRefused)
{
    const auto wrong = [&](const char *sentence, const std::function<void(clq_levels_def &)> &breaks) {
        clq_levels_def def = clq_levels_def_init();
        breaks(def);
        uint32_t count = 77;
        told(clq_asset_make_levels(context_, asset_, &def, &count), sentence);
        EXPECT_EQ(count, 77u);
    };
    const uint32_t rising[] = {100, 100}, tiny[] = {3};
    wrong("targets is NULL with a count of 2", [](clq_levels_def &def) { def.target_count = 2; });
    wrong("level 2 has a target of 100 triangles: targets must descend",
          [&](clq_levels_def &def) { def.targets = rising, def.target_count = 2; });
    wrong("a target of 3 triangles: targets must descend and be at least 4",
          [&](clq_levels_def &def) { def.targets = tiny, def.target_count = 1; });
    for (const float value : {0.0f, -1.0f, NAN, INFINITY}) {
        wrong("tolerance_px is not above 0", [&](clq_levels_def &def) { def.tolerance_px = value; });
        wrong("metres_per_unit is not above 0", [&](clq_levels_def &def) { def.metres_per_unit = value; });
    }
}

TEST_F(AssetEdits, ZoneAreasAreAsManyAsTheHostHasRoomFor)
{
    std::vector<float> areas(before_.zone_count + 1, -1), first(areas);
    for (const float distance : {-1.0f, NAN, INFINITY})
        told(clq_asset_get_zone_areas(asset_, distance, areas.data(), 1, nullptr), "distance_m is below 0");
    told(clq_asset_get_zone_areas(nullptr, 0, areas.data(), 1, nullptr), "asset is NULL");
    told(clq_asset_get_zone_areas(asset_, 0, nullptr, 3, nullptr), "out is NULL with a count of 3");
    EXPECT_EQ(areas[0], -1);
    uint32_t count = 0;
    ASSERT_EQ(clq_asset_get_zone_areas(asset_, 0, nullptr, 0, &count), CLQ_OK);
    EXPECT_EQ(count, before_.zone_count + 1);
    ASSERT_EQ(clq_asset_get_zone_areas(asset_, 0, areas.data(), count, nullptr), CLQ_OK);
    double sum = 0;
    for (const float area : areas) sum += double(area);
    EXPECT_NEAR(sum, 1, 1e-5);
    ASSERT_EQ(clq_asset_get_zone_areas(asset_, 0, first.data(), 1, &count), CLQ_OK);
    EXPECT_EQ(first[0], areas[0]);
    EXPECT_EQ(first[1], -1) << "beyond the host's capacity";
}

}  // namespace
