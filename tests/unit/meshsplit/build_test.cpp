// The whole split: textures, refusals, determinism.
#include <set>

#include <gtest/gtest.h>

#include "articulated.h"
#include "lib/model/template_check.h"
#include "lib/model/template_file.h"

namespace claque::test
{

namespace
{

std::string refusal(const model::Model &m, uint32_t max_px = 1024)
{
    try {
        built(m, max_px);
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), CLQ_ARGUMENT);
        return error.what();
    }
    return "";
}

}  // namespace

TEST(Build, KeepsTheZoneOfEveryTexelAndRenumbersItsKey)
{
    const auto key = [](uint32_t x, uint32_t y) { return uint8_t(x < 20 ? 17 : y < 31 ? 0 : 255); };
    const auto tmpl = built(keyed_sheet(3, 3, key_image(64, 64, key), {255, 17, 0}));
    const model::Texture &texture = tmpl->textures[0];
    ASSERT_EQ(texture.width, 64u);
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            const uint8_t *texel = &texture.rgba[4 * (y * 64 + x)];
            for (const model::ZoneKey &zone : texture.keys)
                if (zone.key == texel[3]) {
                    EXPECT_EQ(std::string_view(tmpl->zone_names[zone.zone]), "zone " + std::to_string(key(x, y)));
                }
            EXPECT_EQ(texel[0], 40 + key(x, y) % 100);
            EXPECT_EQ(texel[1], uint8_t(x * 7));
        }
    EXPECT_EQ(texture.keys.front().key, 94);
    EXPECT_EQ(texture.keys.back().key, 255);
    EXPECT_FALSE(texture.has_holes);
    model::check(*tmpl);
}

TEST(Build, AnUndeclaredKeyIsRefusedWithItsNumberAndCount)
{
    const auto image = key_image(16, 16, [](uint32_t x, uint32_t) { return uint8_t(x < 3 ? 77 : 5); });
    const std::string text = refusal(keyed_sheet(2, 2, image, {5}));
    EXPECT_NE(text.find("key 77"), std::string::npos) << text;
    EXPECT_NE(text.find("48 texels"), std::string::npos) << text;
}

TEST(Build, AKeyOfTwoZonesIsRefused)
{
    const auto image = key_image(16, 16, [](uint32_t, uint32_t) { return uint8_t(5); });
    EXPECT_NE(refusal(keyed_sheet(2, 2, image, {5, 5})).find("several zones"), std::string::npos);
}

TEST(Build, AModelWithoutVisibleTrianglesIsRefused)
{
    model::Model m = keyed_sheet(2, 2, key_image(4, 4, [](uint32_t, uint32_t) { return uint8_t(5); }), {5});
    m.parts[0].hidden = true;
    EXPECT_NE(refusal(m).find("no triangle"), std::string::npos);
}

TEST(Build, ABrokenModelIsRefusedBeforeAnythingIsMade)
{
    model::Model m = torture(4, 1, 1);
    m.parts[0].indices[7] = 1000;
    EXPECT_NE(refusal(m), "");
}

TEST(Build, TwoBuildsGiveTheSameBytes)
{
    const model::Model m = torture(10, 0, 25);
    std::pmr::vector<uint8_t> first, second;
    model::save(*built(m), first);
    model::save(*built(m), second);
    EXPECT_EQ(first, second);
}

TEST(Build, LargeAndOddImagesBecomePowersOfTwoWithinTheLimitWithoutMixingZones)
{
    const auto key = [](uint32_t x, uint32_t y) { return uint8_t((x / 37 + y / 29) % 3 * 100); };
    const auto tmpl = built(keyed_sheet(2, 2, key_image(300, 130, key), {0, 100, 200}), 128);
    const model::Texture &texture = tmpl->textures[0];
    EXPECT_EQ(texture.width, 128u);
    EXPECT_EQ(texture.height, 128u);
    std::set<uint8_t> keys;
    for (size_t i = 3; i < texture.rgba.size(); i += 4) keys.insert(texture.rgba[i]);
    EXPECT_EQ(keys.size(), 3u);
    // Red is the zone that a texel came from: 40 + key % 100, or 40 for all; green is the column, blue the row.
    model::check(*tmpl);
}

TEST(Build, UncoveredTexelsTakeTheNearestZone)
{
    // Zone 5 is the chart; zone 9 is the background, which must not bleed in when the image shrinks.
    const auto image = key_image(64, 64, [](uint32_t x, uint32_t y) { return uint8_t(x < 33 && y < 33 ? 5 : 9); });
    model::Model m = keyed_sheet(1, 1, image, {5, 9});
    m.parts[0] = sheet_part(3, 3, {0.1f, 0.1f}, {0.5f, 0.5f});
    for (const uint32_t max_px : {64u, 32u, 8u, 2u}) {
        const auto tmpl = built(m, max_px);
        EXPECT_EQ(tmpl->report.dirty, 0u) << max_px;
        EXPECT_EQ(tmpl->textures[0].keys.size(), 1u);
    }
}

TEST(Build, MirroredWrappingIsBakedWhereItIsUsed)
{
    const auto image = key_image(16, 8, [](uint32_t x, uint32_t) { return uint8_t(x < 8 ? 1 : 2); });
    model::Model m = keyed_sheet(1, 1, image, {1, 2});
    m.materials[0].wrap_s = m.materials[0].wrap_t = model::Wrap::mirror;
    m.parts[0] = sheet_part(8, 2, {-1, 0}, {2, 1});
    const auto tmpl = built(m);
    const model::Texture &texture = tmpl->textures[0];
    EXPECT_EQ(texture.width, 32u);
    EXPECT_EQ(texture.height, 8u) << "inside [0, 1] clamping shows the same";
    EXPECT_EQ(texture.wrap_s, model::Wrap::repeat);
    EXPECT_EQ(texture.wrap_t, model::Wrap::clamp);
    // u = 1.25 mirrors to 0.75.
    const uint32_t x = uint32_t(1.25f / 2 * 32);
    EXPECT_EQ(texture.rgba[4 * x + 3], texture.keys[1].key);
    EXPECT_EQ(texture.rgba[4 * x + 1], uint8_t(uint32_t(0.75f * 16 - 1) * 7));
}

TEST(Build, SaysWhetherNormalsMayFollowThePaletteItself)
{
    model::Model m = torture(2, 1, 1);
    EXPECT_TRUE(built(m)->similar_only);
    m.rig.rest[0].scale = glm::vec3(-2, 2, 2);
    EXPECT_TRUE(built(m)->similar_only) << "mirrored is a similarity";
    m.rig.rest[0].scale = glm::vec3(1, 2, 1);
    EXPECT_FALSE(built(m)->similar_only);
    m.rig.rest[0].scale = glm::vec3(1);
    m.rig.palette[0].inverse_bind.c[0] = 1.5f;
    EXPECT_FALSE(built(m)->similar_only);
    m.rig.palette[0].inverse_bind.c[0] = 1;
    m.rig.clips.push_back({0, 1, 0, 1});
    m.rig.clip_names.emplace_back("swell");
    m.rig.channels.push_back({0, model::ChannelTarget::scale, model::Interpolation::linear, 3, 0, 2, 0});
    m.rig.times = {0, 1};
    m.rig.values = {1, 1, 1, 2, 2, 2};
    EXPECT_TRUE(built(m)->similar_only);
    m.rig.values[4] = 3;
    EXPECT_FALSE(built(m)->similar_only);
}

// Such a template could be saved but not loaded again.
TEST(Build, RefusesPosesThatNoSphereHolds)
{
    model::Model m = torture(2, 1, 1);
    for (math::Trs &trs : m.rig.rest) trs.scale = glm::vec3(3e38f);
    try {
        built(m);
        FAIL() << "built";
    } catch (const base::Error &error) {
        EXPECT_EQ(error.status(), CLQ_ARGUMENT);
        EXPECT_NE(std::string(error.what()).find("has to be finite"), std::string::npos) << error.what();
    }
}

// Limits of the joints and influences of a vertex, by part.
TEST(Build, HasLimitsOfJointsAndOfInfluences)
{
    const auto joints = [](size_t count) {
        Puppet m;
        m.skin({m.root, m.arm}, "body");
        while (m.rig.palette.size() < count) add_entry(m, m.root);
        return m;
    };
    EXPECT_EQ(refused(joints(65536)), "");
    EXPECT_EQ(refused(joints(65537), CLQ_LIMIT), "model 'puppet' has 65537 joints: a template can have 65536");
    // A level moves vertices to a node above, by a joint of their own.
    Puppet stops = joints(65536);
    stops.stop(stops.arm, 20);
    EXPECT_EQ(refused(stops, CLQ_LIMIT), "model 'puppet' has 65537 joints: a template can have 65536");

    const auto influences = [](uint32_t count, bool hidden) {
        Puppet m;
        m.hang(m.root, "body");
        model::Part &part = m.hang(m.spine, "scarf");
        part.influence_count = count, part.hidden = hidden;
        part.joints.assign(part.positions.size() * count, 0);
        part.weights.assign(part.positions.size() * count, 0);
        for (size_t i = 0; i < part.weights.size(); i += count) part.weights[i] = 1;
        return refused(m);
    };
    EXPECT_EQ(influences(64, false), "");
    EXPECT_EQ(influences(65, false), "part 1 'scarf' has 65 influences a vertex: at most 64");
    EXPECT_EQ(influences(65, true), "");
}

}  // namespace claque::test
