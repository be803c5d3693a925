// Proxies of rigid parts on several nodes, and the colours that they keep.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/lod/chain.h"

using namespace claque;

namespace
{

// A ball of radius 1 on the first node, and one 1.5 to the side on the second. One image, red for the first and blue
// for the second, with one zone or none. In the one clip the second ball moves away by a unit.
model::Model two_balls()
{
    model::Model model;
    model.name = "balls";
    model.rig.parents.assign({model::none, 0});
    model.rig.rest.resize(2);
    model.rig.rest[1].translation = {1.5f, 0, 0};
    model.rig.palette.resize(2);
    model.rig.palette[1].node = 1;
    model.rig.clips.push_back({0, 1, 0, 1});
    model.rig.clip_names.emplace_back("away");
    model.rig.times.assign({0, 1});
    model.rig.values.assign({1.5f, 0, 0, 2.5f, 0, 0});
    model.rig.channels.push_back({1, model::ChannelTarget::translation, model::Interpolation::linear, 3, 0, 2, 0});
    model::Image image;
    image.width = 2, image.height = 1;
    image.rgba = {220, 20, 20, 255, 20, 20, 220, 255};
    model.images.push_back(image);
    model.materials.emplace_back();
    model.materials[0].image = 0;
    for (uint32_t node = 0; node < 2; ++node) {
        model.rig.node_names.emplace_back("node");
        model::Part part;
        part.name = "ball", part.node = node, part.material = 0;
        constexpr uint32_t rings = 16, sides = 24;
        for (uint32_t ring = 0; ring <= rings; ++ring)
            for (uint32_t side = 0; side <= sides; ++side) {
                const float up = 3.14159265f * float(ring) / rings, round = 6.2831853f * float(side % sides) / sides;
                part.positions.emplace_back(std::sin(up) * std::cos(round), std::cos(up),
                                            -std::sin(up) * std::sin(round));
                part.uvs.emplace_back(node == 0 ? 0.25f : 0.75f, 0.5f);
            }
        for (uint32_t ring = 0; ring < rings; ++ring)
            for (uint32_t side = 0; side < sides; ++side) {
                const uint32_t a = ring * (sides + 1) + side, b = a + sides + 1;
                for (const uint32_t v : {a, b, a + 1, a + 1, b, b + 1}) part.indices.push_back(v);
            }
        part.normals = part.positions;
        part.joints.assign(part.positions.size(), node);
        part.weights.assign(part.positions.size(), 1);
        model.parts.push_back(part);
    }
    return model;
}

// The colour, the zone and the light of sheets that are cut out wholly, over two balls of two zones in rings.
struct Hidden {
    uint8_t grey;
    uint32_t zone;
    float emission;
};

model::Model under_cut_sheets(const Hidden &hidden)
{
    model::Model model = two_balls();
    for (const uint8_t key : {uint8_t(10), uint8_t(20), uint8_t(30)})
        model.zones.push_back({"zone " + std::to_string(key), key, {1, 1, 1}, {}});
    model::Image &rings = model.images[0];
    rings.width = 1, rings.height = 16, rings.alpha = model::AlphaMeaning::zone_keys, rings.rgba.clear();
    for (int row = 0; row < 16; ++row)
        for (const int one : {200 - 9 * row, 80, 9 * row, row % 5 < 2 ? 10 : 20})
            rings.rgba.push_back(static_cast<uint8_t>(one));
    for (model::Part &part : model.parts)
        for (size_t v = 0; v < part.uvs.size(); ++v)
            part.uvs[v] = {0.5f, std::acos(std::clamp(part.normals[v].y, -1.0f, 1.0f)) / 3.1415927f};
    model::Image image;
    image.width = image.height = 1;
    image.rgba = {hidden.grey, hidden.grey, hidden.grey, 0};
    model.images.push_back(image);
    model::Material cut;
    cut.image = 1, cut.alpha_mode = model::AlphaMode::mask, cut.zone = hidden.zone;
    cut.lighting.emission = {hidden.emission, 0, 0};
    model.materials.push_back(cut);
    for (const uint32_t zone : {1u, 2u}) {  // zones that are whole pictures, in each model
        model.materials.push_back(cut);
        model.materials.back().zone = zone;
    }
    for (size_t ball = 0; ball < 2; ++ball) {
        model::Part sheet = model.parts[ball];
        sheet.material = 1;
        for (glm::vec3 &p : sheet.positions) p *= 1.02f;
        model.parts.push_back(sheet);
    }
    return model;
}

// Positions, texture coordinates, images and light of all levels, after the numbers of their reports.
std::vector<double> values_of_levels(model::Model model)
{
    lod::ChainOptions options;
    options.targets = {1500, 400, 200, 120, 60, 30};
    std::vector<double> values;
    for (const lod::LevelReport &level : lod::make_chain(model, options))
        values.insert(values.end(), {double(level.triangles), level.distance_m, level.deviation.wrong_zone,
                                     level.zone_area_error, level.zone_view_error, level.deviation.look.colours[0]});
    for (const model::Part &part : model.parts) {
        for (const glm::vec3 &p : part.positions) values.insert(values.end(), {p.x, p.y, p.z});
        for (const glm::vec2 &uv : part.uvs) values.insert(values.end(), {uv.x, uv.y});
        if (part.material <= 3) continue;
        const model::Material &material = model.materials[part.material];
        values.push_back(material.lighting.emission[0]);
        for (const uint8_t byte : model.images[material.image].rgba) values.push_back(byte);
    }
    return values;
}

}  // namespace

TEST(Proxy, StandsForRigidPartsOnSeveralNodesAndFollowsThem)
{
    model::Model model = two_balls();
    const std::vector<lod::LevelReport> chain = lod::make_chain(model, {});
    const model::Part &last = model.parts.back();
    ASSERT_TRUE(last.skinned);
    EXPECT_LE(chain.back().triangles, 30u);
    EXPECT_LE(model::triangles_of(last).size(), 30u);
    bool follows[2] = {false, false};
    for (size_t i = 0; i < last.joints.size(); ++i)
        if (last.weights[i] > 0.9f) follows[last.joints[i]] = true;
    EXPECT_TRUE(follows[0] && follows[1]);
    for (const lod::LevelReport &level : chain)
        if (level.triangles >= 100) {
            EXPECT_LT(level.deviation.posed_rms_m, 0.25) << level.triangles;
        }
    EXPECT_NO_THROW(model::check(model));
}

TEST(Proxy, KeepsTintsApartInsideOfAZone)
{
    model::Model model = two_balls();
    lod::ChainOptions options;
    options.targets = {120, 60, 30, 14};  // with fewer triangles some are of both balls
    lod::make_chain(model, options);
    const model::Part &last = model.parts.back();
    const model::Image &image = model.images[model.materials[last.material].image];
    for (const auto &t : model::triangles_of(last)) {
        float x = 0;  // of its centre; each vertex follows the node at its ball
        for (const uint32_t v : t)
            for (size_t i = v * last.influence_count; i < (v + 1) * last.influence_count; ++i)
                x += last.weights[i] / 3 * (last.positions[v].x + (last.joints[i] == 1 ? 1.5f : 0));
        const glm::vec2 uv = last.uvs[t[0]];
        const size_t at = 4 * (size_t(uv.y * float(image.height)) * image.width + size_t(uv.x * float(image.width)));
        const int red = image.rgba[at], blue = image.rgba[at + 2];
        if (x < 0.3f) {
            EXPECT_GT(red - blue, 60) << x;
        }
        if (x > 1.2f) {
            EXPECT_GT(blue - red, 60) << x;
        }
    }
}

// A face on a sheet in front of a head: texels that are cut out are black.
TEST(Proxy, ShowsTheSurfaceBehindHoles)
{
    model::Model model = two_balls();
    model::Image image;
    image.width = 16, image.height = 1;
    for (int i = 0; i < 16; ++i)
        for (const int one : {0, i < 4 ? 200 : 0, 0, i < 4 ? 255 : 0}) image.rgba.push_back(static_cast<uint8_t>(one));
    model.images.push_back(image);
    model.materials.emplace_back();
    model.materials[1].image = 1, model.materials[1].alpha_mode = model::AlphaMode::mask;
    for (size_t ball = 0; ball < 2; ++ball) {
        model::Part sheet = model.parts[ball];
        sheet.material = 1;
        for (size_t v = 0; v < sheet.positions.size(); ++v) {
            sheet.uvs[v] = {std::acos(sheet.normals[v].y) / 3.1415927f, 0.5f};
            sheet.positions[v] *= 1.02f;
        }
        model.parts.push_back(sheet);
    }
    lod::ChainOptions options;
    options.targets = {400, 120, 60, 30};
    lod::make_chain(model, options);
    size_t seen = 0, green = 0;
    for (const model::Part &part : model.parts) {
        if (part.material < 2 || part.material == model::none) continue;
        const model::Image &baked = model.images[model.materials[part.material].image];
        for (const auto &t : model::triangles_of(part)) {
            glm::vec3 at(0);
            glm::vec2 uv(0);
            for (const uint32_t v : t) at += part.positions[v] / 3.0f, uv += part.uvs[v] / 3.0f;
            const size_t texel = size_t(uv.y * float(baked.height)) * baked.width + size_t(uv.x * float(baked.width));
            const uint8_t *rgb = &baked.rgba[4 * texel];
            green += rgb[1] > 100;
            if (at.y > 0.2f) continue;
            ++seen;
            EXPECT_GT(rgb[0] + rgb[1] + rgb[2], 150) << part.name << " at " << at.x << ", " << at.y << ", " << at.z;
        }
    }
    EXPECT_GT(seen, 60u);
    EXPECT_GT(green, 10u);
}

TEST(Proxy, IsTheSameWhateverIsCutOut)
{
    const std::vector<double> expected = values_of_levels(under_cut_sheets({0, 2, 0}));
    ASSERT_GT(expected.size(), 5000u);
    for (const Hidden &other : {Hidden{255, 2, 0}, Hidden{0, 1, 0}, Hidden{0, 2, 1}, Hidden{0, 1, 1}}) {
        const std::vector<double> found = values_of_levels(under_cut_sheets(other));
        ASSERT_EQ(found.size(), expected.size()) << int(other.grey) << ' ' << other.zone << ' ' << other.emission;
        size_t differ = 0;
        for (size_t i = 0; i < found.size(); ++i) differ += found[i] != expected[i];
        EXPECT_EQ(differ, 0u) << int(other.grey) << ' ' << other.zone << ' ' << other.emission;
    }
}

TEST(Proxy, IsNotMadeForRigidPartsThatMoveAsOne)
{
    model::Model model = two_balls();
    model.parts[1].node = 0;
    model.parts[1].joints.assign(model.parts[1].joints.size(), 0);
    lod::make_chain(model, {});
    for (const model::Part &part : model.parts) EXPECT_FALSE(part.skinned);
}
