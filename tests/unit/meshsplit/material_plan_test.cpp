// Materials to zones, textures and palette cells: an individual without colours of its own looks like the file.
#include "meshsplit/material_plan.h"

#include <cmath>

#include <gtest/gtest.h>

#include "models.h"

namespace claque::test
{

namespace
{

uint32_t add_material(model::Model &m, const std::array<float, 3> &base, uint32_t zone = model::none,
                      uint32_t image = model::none)
{
    model::Material material;
    material.name = "material " + std::to_string(m.materials.size());
    material.base_colour = {base[0], base[1], base[2], 1};
    material.zone = zone;
    material.image = image;
    m.materials.push_back(material);
    model::Part part = sheet_part(2, 2);
    for (auto &p : part.positions) p.z = float(m.parts.size());
    part.material = uint32_t(m.materials.size() - 1);
    m.parts.push_back(part);
    return part.material;
}

uint32_t add_zone(model::Model &m, const std::array<float, 3> &colour)
{
    model::Zone zone;
    zone.name = "zone " + std::to_string(m.zones.size());
    zone.colour = colour;
    m.zones.push_back(zone);
    return uint32_t(m.zones.size() - 1);
}

// The unlit colour at the centre of part `i`'s first square, in 0..1: texture x zone colour.
std::array<float, 3> seen(const model::Template &tmpl, size_t part)
{
    const model::Level &level = tmpl.levels[0];
    for (const model::Surface &surface : level.surfaces)
        for (const model::Bin &bin : surface.clean)
            for (uint32_t i = bin.range.first; i < bin.range.first + bin.range.count; i += 3) {
                const uint32_t v = level.indices[i];
                if (level.positions[3 * v + 2] != float(part)) continue;
                const model::Texture &texture = tmpl.textures[surface.texture];
                const auto texel = [](float f, uint32_t size) { return std::min(uint32_t(f * float(size)), size - 1); };
                const uint32_t x = texel(level.uvs[2 * v], texture.width),
                               y = texel(level.uvs[2 * v + 1], texture.height);
                const uint8_t *rgba = &texture.rgba[4 * (size_t(y) * texture.width + x)];
                EXPECT_EQ(rgba[3], texture.keys[bin.zone_index].key);
                const auto &colour = tmpl.zone_colours[texture.keys[bin.zone_index].zone];
                return {float(rgba[0]) / 255 * colour[0], float(rgba[1]) / 255 * colour[1],
                        float(rgba[2]) / 255 * colour[2]};
            }
    ADD_FAILURE() << "part " << part << " is not there";
    return {};
}

void expect_near(const std::array<float, 3> &a, const std::array<float, 3> &b)
{
    for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], 0.004f);
}

}  // namespace

TEST(MaterialPlan, MaterialsWithoutImagesShareOnePaletteAndOneSurface)
{
    model::Model m = empty_model();
    const std::vector<std::array<float, 3>> bases = {
        {1, 0, 0}, {0.2f, 0.4f, 0.6f}, {0, 0, 0}, {1, 1, 1}, {0.2f, 0.4f, 0.6f}};
    for (const auto &base : bases) add_material(m, base);
    const auto tmpl = built(m);
    EXPECT_EQ(tmpl->textures.size(), 1u);
    EXPECT_EQ(tmpl->levels[0].surfaces.size(), 1u);
    EXPECT_EQ(tmpl->zone_count(), 4u) << "one zone per base colour";
    EXPECT_EQ(tmpl->report.dirty, 0u) << "a triangle never sees two cells";
    for (size_t i = 0; i < bases.size(); ++i) expect_near(seen(*tmpl, i), bases[i]);
}

TEST(MaterialPlan, SixtyMaterialsFallIntoPalettesOfZonesThatEveryStrategyCanTellApart)
{
    model::Model m = empty_model();
    for (int i = 0; i < 60; ++i) add_material(m, {float(i) / 60, 0.5f, 1 - float(i) / 60});
    const auto tmpl = built(m);
    EXPECT_EQ(tmpl->textures.size(), 2u);
    EXPECT_EQ(tmpl->report.dirty, 0u);
    for (int i = 0; i < 60; ++i) expect_near(seen(*tmpl, size_t(i)), {float(i) / 60, 0.5f, 1 - float(i) / 60});
}

TEST(MaterialPlan, MaterialsOfOneZoneKeepTheirOwnBaseColours)
{
    model::Model m = empty_model();
    const uint32_t zone = add_zone(m, {0.8f, 0.2f, 0.1f});
    add_material(m, {0.8f, 0.2f, 0.1f}, zone);
    add_material(m, {0.4f, 0.4f, 0.05f}, zone);
    const auto tmpl = built(m);
    EXPECT_EQ(tmpl->zone_count(), 1u);
    expect_near(seen(*tmpl, 0), {0.8f, 0.2f, 0.1f});
    expect_near(seen(*tmpl, 1), {0.4f, 0.4f, 0.05f});
}

TEST(MaterialPlan, AnAuthoredZoneColourIsMultipliedIn)
{
    model::Model m = empty_model();
    const uint32_t white = add_zone(m, {1, 1, 1}), red = add_zone(m, {1, 0.1f, 0});
    add_material(m, {0.3f, 0.6f, 0.9f}, white);
    add_material(m, {1, 1, 1}, red);
    const auto tmpl = built(m);
    expect_near(seen(*tmpl, 0), {0.3f, 0.6f, 0.9f});
    expect_near(seen(*tmpl, 1), {1, 0.1f, 0});
}

TEST(MaterialPlan, TexturesAreSharedByMaterialsThatShowTheSameAndTintedWhereBaseColoursDiffer)
{
    model::Model m = empty_model();
    model::Image image = key_image(8, 8, [](uint32_t, uint32_t) { return uint8_t(255); });
    image.alpha = model::AlphaMeaning::opacity;
    std::fill(image.rgba.begin(), image.rgba.end(), uint8_t(204));
    m.images.push_back(image);
    const uint32_t zone = add_zone(m, {1, 1, 1});
    add_material(m, {1, 1, 1}, zone, 0);
    add_material(m, {1, 1, 1}, zone, 0);
    add_material(m, {0.5f, 1, 0.25f}, zone, 0);
    m.materials[1].double_sided = true;
    const auto tmpl = built(m);
    EXPECT_EQ(tmpl->textures.size(), 2u);
    EXPECT_EQ(tmpl->levels[0].surfaces.size(), 3u);
    expect_near(seen(*tmpl, 0), {0.8f, 0.8f, 0.8f});
    expect_near(seen(*tmpl, 1), {0.8f, 0.8f, 0.8f});
    expect_near(seen(*tmpl, 2), {0.4f, 0.8f, 0.2f});
}

TEST(MaterialPlan, AZoneMadeForAMaterialDrawsThatColourAndNoOther)
{
    model::Model m = empty_model();
    add_material(m, {0.5f, 0.25f, 0.25f});
    const auto tmpl = built(m);
    const model::HsbRange &range = tmpl->zone_ranges[0];
    EXPECT_FLOAT_EQ(range.hue_min_deg, 0);
    EXPECT_FLOAT_EQ(range.saturation_min, 0.5f);
    EXPECT_FLOAT_EQ(range.brightness_min, 0.5f);
    EXPECT_EQ(range.saturation_min, range.saturation_max);
}

}  // namespace claque::test
