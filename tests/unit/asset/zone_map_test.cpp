// Zones for images that come without: painted maps, and maps that are proposed.
#include "lib/asset/zone_map.h"

#include <set>

#include <gtest/gtest.h>

#include "assets.h"
#include "lib/asset/zone_clusters.h"

namespace claque::testing
{
namespace
{

using asset::unknown_zone;
using asset::ZoneMap;
using asset::ZoneMapZone;

// Two triangles over the whole of an 8 x 8 image: blue cloth above in eight shades, red leather below.
model::Model cloth_and_leather()
{
    model::Model model;
    model.name = "sheet";
    model.rig.parents.push_back(model::none);
    model.rig.rest.emplace_back();
    model.rig.node_names.emplace_back("root");
    model.rig.palette.emplace_back();
    model::Image image;
    image.name = "paint";
    image.width = image.height = 8;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const uint8_t light = static_cast<uint8_t>(12 * (x + 1));
            if (y < 4) image.rgba.insert(image.rgba.end(), {uint8_t(light / 4), uint8_t(light / 2), light, 255});
            else image.rgba.insert(image.rgba.end(), {200, 40, 20, 255});
        }
    model.images.push_back(image);
    model.zones.resize(1);
    model.zones[0].name = "all of it";
    model.materials.emplace_back();
    model.materials[0].name = "dress", model.materials[0].image = 0, model.materials[0].zone = 0;
    model::Part part;
    part.node = 0, part.material = 0;
    part.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    part.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    part.indices = {0, 1, 2, 0, 2, 3};
    part.joints.assign(4, 0), part.weights.assign(4, 1);
    model.parts.push_back(part);
    return model;
}

const std::vector<uint16_t> halves = {0, 1};  // 1 x 2
const ZoneMap upper_and_lower = {1, 2, halves.data()};

std::vector<ZoneMapZone> zones_of(std::initializer_list<const char *> names, bool reduced)
{
    std::vector<ZoneMapZone> zones;
    for (const char *name : names) {
        zones.emplace_back();
        zones.back().name = name, zones.back().reduced = reduced;
    }
    return zones;
}

const uint8_t *texel(const model::Model &model, int x, int y, uint32_t image = 0)
{
    return &model.images[image].rgba[4 * size_t(8 * y + x)];
}

std::string refusal(model::Model &model, uint32_t image, const ZoneMap &map, const std::vector<ZoneMapZone> &zones)
{
    try {
        asset::set_zone_map(model, image, map, zones);
    } catch (const base::Error &error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(ZoneMap, BecomesKeysInTheImagesAlphaAndZonesOfTheModel)
{
    model::Model model = cloth_and_leather();
    asset::set_zone_map(model, 0, upper_and_lower, zones_of({"cloth", "leather"}, false));
    EXPECT_EQ(model.images[0].alpha, model::AlphaMeaning::zone_keys);
    EXPECT_EQ(model.materials[0].zone, model::none);
    ASSERT_EQ(model.zones.size(), 2u) << "the zone that nothing shows any longer is gone";
    EXPECT_EQ(model.zones[0].name, "cloth");
    EXPECT_NE(model.zones[0].key, model.zones[1].key);
    for (int y = 0; y < 8; ++y) EXPECT_EQ(texel(model, 3, y)[3], model.zones[y < 4 ? 0 : 1].key) << y;
    model::check(model);
}

TEST(ZoneMap, LeavesTheRangesThatAHostGives)
{
    const model::HsbRange green = {100, 140, 0.5f, 1, 0.5f, 1};
    std::vector<ZoneMapZone> zones = zones_of({"cloth", "leather"}, true);
    zones[0].range = &green;
    model::Model model = cloth_and_leather();
    asset::set_zone_map(model, 0, upper_and_lower, zones);
    EXPECT_EQ(model.zones[0].range.hue_min_deg, 100);
    EXPECT_EQ(model.zones[0].range.brightness_max, 1);
    EXPECT_NE(model.zones[1].range.hue_min_deg, 100);
}

TEST(ZoneMap, LeavesTheColoursOfZonesThatAreNotReducedAsTheyAre)
{
    model::Model model = cloth_and_leather();
    const model::Model before = cloth_and_leather();
    asset::set_zone_map(model, 0, upper_and_lower, zones_of({"cloth", "leather"}, false));
    for (size_t i = 0; i < model.images[0].rgba.size(); ++i)
        if (i % 4 != 3) {
            ASSERT_EQ(model.images[0].rgba[i], before.images[0].rgba[i]) << i;
        }
    EXPECT_EQ(model.zones[0].colour, (std::array<float, 3>{1, 1, 1}));
}

TEST(ZoneMap, ReducesAZoneToLightAndDarkAndGivesItTheColourThatItHad)
{
    model::Model model = cloth_and_leather();
    const model::Model before = cloth_and_leather();
    asset::set_zone_map(model, 0, upper_and_lower, zones_of({"cloth", "leather"}, true));
    int brightest = 0;
    for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 8; ++y) {
            const uint8_t *now = texel(model, x, y), *then = texel(before, x, y);
            EXPECT_EQ(now[0], now[1]);
            EXPECT_EQ(now[0], now[2]);
            brightest = std::max<int>(brightest, now[0]);
            // An individual without colours shows what was there before: within what rounding the grey takes away.
            const auto &colour = model.zones[y < 4 ? 0 : 1].colour;
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(float(now[k]) * colour[size_t(k)], float(then[k]), 1.5f) << x << y;
        }
    EXPECT_EQ(brightest, 255) << "so that any colour, a light one too, can be given to it";
}

TEST(ZoneMap, UnpaintedTexelsTakeTheNearestZone)
{
    model::Model model = cloth_and_leather();
    std::vector<uint16_t> map(64, unknown_zone);
    map[8 * 1 + 1] = 0, map[8 * 6 + 6] = 1;
    asset::set_zone_map(model, 0, {8, 8, map.data()}, zones_of({"cloth", "leather"}, false));
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const int to_first = std::abs(x - 1) + std::abs(y - 1), to_second = std::abs(x - 6) + std::abs(y - 6);
            if (to_first == to_second) continue;
            EXPECT_EQ(texel(model, x, y)[3], model.zones[to_first < to_second ? 0 : 1].key) << x << " " << y;
        }
}

// As in an atlas, where a zone spreads over swatches that nothing shows.
TEST(ZoneMap, TakesAZonesColourFromTexelsThatTheMapKnows)
{
    model::Model model = cloth_and_leather();
    std::vector<uint16_t> map(64, unknown_zone);
    for (size_t i = 0; i < 8; ++i) map[i] = 0, map[56 + i] = 1;
    for (size_t i = 4 * 8; i < 7 * 8; ++i) model.images[0].rgba[4 * i + 1] = 255;  // green, beside the leather
    asset::set_zone_map(model, 0, {8, 8, map.data()}, zones_of({"cloth", "leather"}, true));
    EXPECT_NEAR(model.zones[1].colour[1] / model.zones[1].colour[0], 0.2f, 0.01f) << "40 to 200";
}

TEST(ZoneMap, TakesAMaterialsBaseColourIntoTheTexels)
{
    model::Model model = cloth_and_leather();
    model.materials[0].base_colour = {0.5f, 1, 1, 1};
    asset::set_zone_map(model, 0, upper_and_lower, zones_of({"cloth", "leather"}, true));
    EXPECT_EQ(model.materials[0].base_colour, (std::array<float, 4>{1, 1, 1, 1}));
    EXPECT_EQ(texel(model, 0, 7)[0], texel(model, 0, 7)[1]);
    EXPECT_NEAR(model.zones[1].colour[0] / model.zones[1].colour[1], 2.5f, 0.1f) << "100 to 40";
}

TEST(ZoneMap, ImagesShareZonesByName)
{
    model::Model model = cloth_and_leather();
    model.images.push_back(model.images[0]);
    model.images[1].name = "other paint";
    model.texture_sets.push_back({"other", {1}});
    asset::set_zone_map(model, 0, upper_and_lower, zones_of({"cloth", "leather"}, false));
    asset::set_zone_map(model, 1, upper_and_lower, zones_of({"leather", "metal"}, false));
    ASSERT_EQ(model.zones.size(), 3u);
    EXPECT_EQ(texel(model, 0, 0, 1)[3], texel(model, 0, 7, 0)[3]) << "leather";
    EXPECT_EQ(model.zones[2].name, "metal");
    model::check(model);
}

TEST(ZoneMap, ThatBreaksARuleIsRefusedAndChangesNothing)
{
    model::Model model = cloth_and_leather();
    const auto zones = zones_of({"cloth", "leather"}, true);
    EXPECT_NE(refusal(model, 3, upper_and_lower, zones).find("image 3 does not exist: 'sheet' has 1"),
              std::string::npos);
    const std::vector<uint16_t> wrong = {0, 2}, nothing = {unknown_zone};
    EXPECT_NE(refusal(model, 0, {1, 2, wrong.data()}, zones)
                  .find("texel (0, 1) of the zone map names zone 2, which does not exist: there are 2"),
              std::string::npos);
    EXPECT_NE(refusal(model, 0, {1, 1, nothing.data()}, zones).find("names no zone anywhere"), std::string::npos);
    model.materials[0].alpha_mode = model::AlphaMode::mask;
    EXPECT_NE(refusal(model, 0, upper_and_lower, zones).find("material 'dress' is cut out by the alpha"),
              std::string::npos);
    model.materials[0].alpha_mode = model::AlphaMode::opaque;
    model.materials[0].image = model::none;
    EXPECT_NE(refusal(model, 0, upper_and_lower, zones).find("no material shows image 0 'paint'"), std::string::npos);
    model.materials[0].image = 0;
    EXPECT_EQ(model.images[0].rgba, cloth_and_leather().images[0].rgba);
    EXPECT_EQ(model.zones.size(), 1u);
}

TEST(ZoneProposal, FindsMaterialsByColourWhateverTheirShading)
{
    const model::Model model = cloth_and_leather();
    const asset::ZoneProposal proposal = asset::propose_zones(model, 0, 2);
    ASSERT_EQ(proposal.means.size(), 2u);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) EXPECT_EQ(proposal.zones[size_t(8 * y + x)], proposal.zones[y < 4 ? 0u : 63u]);
    EXPECT_NE(proposal.zones[0], proposal.zones[63]);
}

TEST(ZoneProposal, GivesFewerZonesThanAskedForWhereColoursDoNotDiffer)
{
    model::Model model = cloth_and_leather();
    for (size_t i = 0; i < model.images[0].rgba.size(); i += 4) model.images[0].rgba[i] = 180;
    for (size_t i = 1; i < model.images[0].rgba.size(); i += 4)
        model.images[0].rgba[i] = model.images[0].rgba[i + 1] = 60;
    EXPECT_EQ(asset::propose_zones(model, 0, 12).means.size(), 1u);
}

TEST(ZoneProposal, LeavesOutTexelsThatNoTriangleShowsAndCalmsLoneOnes)
{
    model::Model model = cloth_and_leather();
    for (glm::vec2 &uv : model.parts[0].uvs) uv.x *= 0.5f;
    uint8_t *lone = &model.images[0].rgba[4 * (8 * 6 + 1)];
    lone[0] = 20, lone[1] = 60, lone[2] = 120;
    const asset::ZoneProposal proposal = asset::propose_zones(model, 0, 2);
    EXPECT_EQ(proposal.zones[8 * 2 + 6], unknown_zone);
    EXPECT_NE(proposal.zones[8 * 2 + 1], unknown_zone);
    EXPECT_EQ(proposal.zones[8 * 6 + 1], proposal.zones[8 * 6 + 2]) << "one blue texel in the leather";
}

TEST(ZoneProposal, KeepsSmallSpotsAndMergesThinEdges)
{
    model::Model model = cloth_and_leather();
    constexpr size_t side = 96;
    model::Image &image = model.images[0];
    image.width = image.height = side;
    image.rgba.assign(4 * side * side, 255);
    const auto paint = [&](size_t x0, size_t y0, size_t w, size_t h, std::array<uint8_t, 3> rgb) {
        for (size_t y = y0; y < y0 + h; ++y)
            for (size_t x = x0; x < x0 + w; ++x) std::copy(rgb.begin(), rgb.end(), &image.rgba[4 * (side * y + x)]);
    };
    paint(0, 0, side, side, {150, 90, 50});
    paint(20, 60, 6, 6, {40, 110, 230});  // an eye: 0.4 % of the picture
    paint(50, 30, 40, 1, {60, 200, 60});  // as many texels in a line
    const asset::ZoneProposal proposal = asset::propose_zones(model, 0, 8);
    EXPECT_EQ(proposal.means.size(), 2u);
    EXPECT_NE(proposal.zones[side * 63 + 23], proposal.zones[side * 10 + 10]);
    EXPECT_EQ(proposal.means[proposal.zones[side * 63 + 23]], (std::array<uint8_t, 3>{40, 110, 230}));
}

TEST(ZoneProposal, IsRefusedForWhatThereIsNot)
{
    model::Model model = cloth_and_leather();
    EXPECT_THROW(asset::propose_zones(model, 1, 2), base::Error);
    EXPECT_THROW(asset::propose_zones(model, 0, 0), base::Error);
    EXPECT_THROW(asset::propose_zones(model, 0, 49), base::Error);
    model.parts[0].hidden = true;
    EXPECT_THROW(asset::propose_zones(model, 0, 2), base::Error);
}

}  // namespace claque::testing
