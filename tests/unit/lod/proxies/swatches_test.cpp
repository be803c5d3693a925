// The shared image of proxies with one zone a triangle, against the colours that went in.
#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/lod/proxies/proxy_image.h"

using namespace claque;

namespace
{

double share(uint64_t i) { return double(base::unit(base::mix(i))); }

constexpr uint32_t pictured_zone = 2;

// One triangle in each of four zones; the third may be a picture.
model::Model four_zones(bool has_picture)
{
    model::Model model;
    model.rig.parents.push_back(model::none);
    model.rig.rest.emplace_back();
    model.rig.node_names.emplace_back("root");
    model.rig.palette.emplace_back();
    for (uint32_t zone = 0; zone < 4; ++zone) {
        model.zones.emplace_back();
        model.materials.emplace_back();
        model.materials.back().zone = zone;
        model::Part part;
        part.node = 0, part.material = zone;
        for (const glm::vec2 &p : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(0, 1)})
            part.positions.emplace_back(p.x, p.y, float(zone));
        part.indices = {0, 1, 2}, part.joints.assign(3, 0), part.weights.assign(3, 1);
        if (has_picture && zone == pictured_zone) {
            model.images.emplace_back();
            model.images[0].width = model.images[0].height = 1, model.images[0].rgba = {90, 60, 30, 255};
            model.materials[zone].image = 0;
            part.uvs.assign(3, glm::vec2(0.5f));
        }
        model.parts.push_back(part);
    }
    return model;
}

// A strip of triangles. Each shows a zone, and stands for a colour of some area; some for none.
struct Strip {
    model::Part part;
    lod::SwatchZones chosen;
    std::vector<lod::ColourSum> shown;  // [triangles]

    explicit Strip(uint32_t triangles)
    {
        for (uint32_t v = 0; v < triangles + 2; ++v) {
            part.positions.emplace_back(float(v), float(v % 2), 0.5f);
            part.normals.emplace_back(0, 0, 1);
            part.joints.push_back(v % 3), part.weights.push_back(1);
        }
        std::map<uint32_t, lod::ColourSum> all;
        for (uint32_t t = 0; t < triangles; ++t) {
            part.indices.insert(part.indices.end(), {t, t + 1, t + 2});
            chosen.zones.push_back(t % 7 == 6 ? 3 : t % 3);
            chosen.colours.emplace_back();
            if (t % 5 == 2) continue;
            // The zone that it shows, and another that it does not; none is of zone 3.
            for (uint32_t zone : {t % 3, (t + 1) % 3}) {
                lod::ColourSum sum;
                sum.area = 0.1 + share(9 * t + zone);
                const double grey = 0.1 + 0.8 * share(31 * t + zone);
                sum.colour = glm::dvec3(grey, zone == 1 ? 0.5 * grey : grey, grey) * sum.area;
                chosen.colours.back()[zone] = {sum};
                all[zone] += sum;
            }
        }
        for (uint32_t t = 0; t < triangles; ++t) {
            const uint32_t zone = chosen.zones[t];
            const auto own = chosen.colours[t].find(zone);
            // Without a sample of its zone it has the zone's mean colour; white, if nothing shows that zone.
            if (own != chosen.colours[t].end()) shown.push_back(own->second[0]);
            else shown.push_back(all.count(zone) ? all[zone] : lod::ColourSum{glm::dvec3(1), 1});
        }
    }
};

}  // namespace

class Swatches : public testing::TestWithParam<bool>  // whether the third zone is a picture
{
};

TEST_P(Swatches, AreTheMeanColoursOfTheTrianglesThatShareThem)
{
    const model::Model model = four_zones(GetParam());
    std::vector<const model::Part *> parts;
    for (const model::Part &part : model.parts) parts.push_back(&part);
    const lod::ProxySource source(model, parts);
    for (const uint32_t count : {5u, 64u, 65u, 400u}) {
        const Strip strip(count);
        std::vector<model::Part> baked = {strip.part};
        const std::vector<model::Image> images = lod::bake_swatches(source, {strip.chosen}, baked);
        ASSERT_EQ(images.size(), 1u);
        const model::Image &image = images[0];
        ASSERT_EQ(image.width, 64u);
        ASSERT_EQ(image.height % 4, 0u);
        std::map<std::pair<uint32_t, uint32_t>, std::vector<uint32_t>> sharing;
        for (uint32_t t = 0; t < count; ++t) {
            glm::vec2 uv(0);
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t v = baked[0].indices[3 * t + k], before = strip.part.indices[3 * t + k];
                EXPECT_EQ(baked[0].positions[v], strip.part.positions[before]);
                EXPECT_EQ(baked[0].joints[v], strip.part.joints[before]);
                if (k == 0) uv = baked[0].uvs[v];
                ASSERT_EQ(baked[0].uvs[v], uv) << "all of a triangle shows one place";
            }
            const double x = double(uv.x) * image.width / 4, y = double(uv.y) * image.height / 4;
            ASSERT_NEAR(x - std::floor(x), 0.5, 1e-4) << "the middle of a swatch";
            ASSERT_NEAR(y - std::floor(y), 0.5, 1e-4);
            sharing[{uint32_t(x), uint32_t(y)}].push_back(t);
        }
        EXPECT_GT(sharing.size(), count > 64 ? 16u : 2u);
        std::set<uint8_t> keys;
        std::map<uint32_t, int> swatches;  // of each zone
        for (const auto &[at, triangles] : sharing) {
            lod::ColourSum sum;
            double darkest = 1, lightest = 0;
            for (const uint32_t t : triangles) {
                EXPECT_EQ(strip.chosen.zones[t], strip.chosen.zones[triangles[0]]);
                sum += strip.shown[t];
                const glm::dvec3 colour = strip.shown[t].mean();
                const double grey = (colour.x + colour.y + colour.z) / 3;
                darkest = std::min(darkest, grey), lightest = std::max(lightest, grey);
            }
            const bool has_shades = count > 64 || (GetParam() && strip.chosen.zones[triangles[0]] == pictured_zone);
            if (has_shades) EXPECT_LE(lightest - darkest, 0.125 + 1e-9) << "an eighth of the way to white";
            ++swatches[strip.chosen.zones[triangles[0]]];
            keys.insert(source.keys[strip.chosen.zones[triangles[0]]]);
            for (uint32_t i = 0; i < 16; ++i) {
                const size_t texel = 4 * ((4 * at.second + i / 4) * size_t(image.width) + 4 * at.first + i % 4);
                for (int k = 0; k < 3; ++k)
                    EXPECT_NEAR(image.rgba[texel + size_t(k)], 255 * sum.mean()[k], 0.501)
                        << at.first << ", " << at.second;
                EXPECT_EQ(image.rgba[texel + 3], source.keys[strip.chosen.zones[triangles[0]]]);
            }
        }
        // Few triangles have one shade a tint, but of a picture. Only the second zone is tinted.
        for (const auto &[zone, own] : swatches)
            if (count <= 64 && zone != 1 && !(GetParam() && zone == pictured_zone)) EXPECT_EQ(own, 1) << zone;
        if (count == 64 && GetParam()) EXPECT_GE(swatches[pictured_zone], 5);
        for (size_t texel = 0; texel < image.rgba.size(); texel += 4)
            ASSERT_TRUE(keys.count(image.rgba[texel + 3])) << "a key of no zone that is shown";
        EXPECT_LT(4 * image.height * 4, 16 * 4 * (2 * sharing.size() + 16)) << "no more than twice the room";
    }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutAPicture, Swatches, testing::Bool());
