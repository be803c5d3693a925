// Zone area fractions of a surface, and that levels of detail keep them.
#include "lib/lod/surface/area_fractions.h"

#include <gtest/gtest.h>

#include "lib/figures/figure.h"
#include "lib/lod/chain.h"

using namespace claque;

namespace
{

// A square of two triangles under an image of which `columns` of 100 columns belong to the second zone.
model::Model square(uint32_t columns)
{
    model::Model model;
    model.rig.parents.push_back(model::none);
    model.rig.rest.emplace_back();
    model.rig.node_names.emplace_back("root");
    model.rig.palette.emplace_back();
    for (const uint8_t key : {10, 20}) {
        model.zones.emplace_back();
        model.zones.back().key = key;
    }
    model::Image image;
    image.width = 100, image.height = 1;
    image.alpha = model::AlphaMeaning::zone_keys;
    for (uint32_t x = 0; x < 100; ++x)
        image.rgba.insert(image.rgba.end(), {255, 255, 255, uint8_t(x < columns ? 20 : 10)});
    model.images.push_back(image);
    model.materials.emplace_back();
    model.materials[0].image = 0;
    model::Part part;
    part.node = 0, part.material = 0;
    part.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    part.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    part.indices = {0, 1, 2, 0, 2, 3};
    part.joints.assign(4, 0);
    part.weights.assign(4, 1);
    model.parts.push_back(part);
    return model;
}

std::vector<const model::Part *> shown_at(const model::Model &model, float distance_m)
{
    std::vector<const model::Part *> shown;
    for (const model::Part &part : model.parts)
        if (part.lod_min_m <= distance_m && distance_m < part.lod_max_m) shown.push_back(&part);
    return shown;
}

class ZoneAreasOf : public testing::TestWithParam<size_t>
{
};

}  // namespace

TEST(AreaFractions, AreThoseOfTexelsByArea)
{
    for (const uint32_t columns : {0u, 3u, 50u, 100u}) {
        model::Model model = square(columns);
        std::vector<double> area_fractions = lod::zone_area_fractions(model, {&model.parts[0]});
        ASSERT_EQ(area_fractions.size(), 3u);
        EXPECT_NEAR(area_fractions[0], 1 - columns / 100.0, 0.002);
        EXPECT_NEAR(area_fractions[1], columns / 100.0, 0.002);
        EXPECT_EQ(area_fractions[2], 0);
        // A second square without zones, three times as large.
        model::Part bare = model.parts[0];
        bare.material = model::none;
        for (glm::vec3 &p : bare.positions) p.x *= 3;
        area_fractions = lod::zone_area_fractions(model, {&model.parts[0], &bare});
        EXPECT_NEAR(area_fractions[1], columns / 400.0, 0.002);
        EXPECT_NEAR(area_fractions[2], 0.75, 1e-9);
        EXPECT_NEAR(lod::zone_area_error(area_fractions, {0, columns / 400.0, 0.75}), (100 - columns) / 400.0, 0.002);
    }
}

TEST(AreaFractions, LeaveOutHoles)
{
    model::Model model = square(0);
    model.images.emplace_back();
    model.images.back().width = 4, model.images.back().height = 1;
    for (const int alpha : {255, 0, 0, 0})
        for (const int one : {9, 9, 9, alpha}) model.images.back().rgba.push_back(static_cast<uint8_t>(one));
    model.materials.emplace_back();
    model.materials.back().image = static_cast<uint32_t>(model.images.size() - 1);
    model.materials.back().zone = 1, model.materials.back().alpha_mode = model::AlphaMode::mask;
    model::Part sheet = model.parts[0];
    sheet.material = static_cast<uint32_t>(model.materials.size() - 1);
    for (glm::vec3 &p : sheet.positions) p.z += 1;
    const std::vector<double> fractions = lod::zone_area_fractions(model, {&model.parts[0], &sheet});
    EXPECT_NEAR(fractions[1], 0.2, 0.02) << "a quarter of one of two squares is there";
}

// By area, per level, within 2 points of the surface, for every zone; and those of a hundredth do not vanish.
TEST_P(ZoneAreasOf, StayWithinTwoPointsForEveryZoneAtEveryLevel)
{
    model::Model model = figures::people()[GetParam()].make();
    lod::ChainOptions options;
    options.sampling.max_clips = 0;
    const std::vector<double> finest = lod::zone_area_fractions(model, shown_at(model, 0));
    const std::vector<lod::LevelReport> chain = lod::make_chain(model, options);
    ASSERT_GE(chain.size(), 8u);
    EXPECT_LE(chain.back().triangles, 30u);
    for (const lod::LevelReport &level : chain) {
        const std::vector<double> area_fractions =
            lod::zone_area_fractions(model, shown_at(model, static_cast<float>(level.distance_m) * 1.0001f));
        for (size_t zone = 0; zone < model.zones.size(); ++zone)
            EXPECT_NEAR(area_fractions[zone], finest[zone], 0.02)
                << model.zones[zone].name << " with " << level.triangles << " triangles";
        // With fewer, each triangle is several hundredths.
        for (size_t zone = 0; zone < model.zones.size(); ++zone) {
            if (level.triangles < 20 || finest[zone] < 0.01) continue;
            EXPECT_GE(area_fractions[zone], 0.003)
                << model.zones[zone].name << " vanishes with " << level.triangles << " triangles";
        }
        EXPECT_NEAR(level.zone_area_error, lod::zone_area_error(area_fractions, finest), 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(People, ZoneAreasOf, testing::Range(size_t(0), figures::people().size()),
                         [](const auto &person) { return std::string(figures::people()[person.param].name); });
