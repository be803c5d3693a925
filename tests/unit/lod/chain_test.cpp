// The error of a level of detail, and the chain of levels that follows from it.
#include "lib/lod/chain.h"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "lib/base/error.h"
#include "lib/figures/figure.h"
#include "lib/lod/surface/visibility.h"

using namespace claque;

namespace
{

// A square of four triangles in the plane y = height with a raised centre.
model::Model pyramid(float raised)
{
    model::Model model;
    model.name = "pyramid";
    model.rig.parents.push_back(model::none);
    model.rig.rest.emplace_back();
    model.rig.node_names.emplace_back("root");
    model.rig.palette.emplace_back();
    model::Part part;
    part.name = "top";
    part.node = 0;
    part.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {0.5f, raised, 0.5f}};
    part.indices = {0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0};
    part.joints.assign(5, 0);
    part.weights.assign(5, 1);
    model.parts.push_back(part);
    return model;
}

// A flat square of 2 * side * side triangles.
model::Model grid(uint32_t side)
{
    model::Model model = pyramid(0);
    model::Part &part = model.parts[0];
    part.positions.clear(), part.indices.clear();
    for (uint32_t i = 0; i < (side + 1) * (side + 1); ++i) {
        const uint32_t x = i % (side + 1), z = i / (side + 1);
        part.positions.emplace_back(float(x) / float(side), 0, float(z) / float(side));
        if (x < side && z < side)
            for (const uint32_t v : {i, i + side + 1, i + 1, i + 1, i + side + 1, i + side + 2})
                part.indices.push_back(v);
    }
    part.joints.assign(part.positions.size(), 0), part.weights.assign(part.positions.size(), 1);
    return model;
}

std::vector<const model::Part *> pointers_of(const model::Model &model)
{
    std::vector<const model::Part *> parts;
    for (const model::Part &part : model.parts) parts.push_back(&part);
    return parts;
}

model::Part flat_of(const model::Model &model)
{
    model::Part part = model.parts[0];
    part.indices = {0, 3, 2, 0, 2, 1};
    return part;
}

}  // namespace

TEST(Deviation, IsZeroBetweenACharacterAndItself)
{
    const model::Model citizen = figures::citizen();
    const lod::Deviation same = lod::deviation(citizen, {&citizen.parts[0]}, {citizen.parts[0]}, {});
    EXPECT_LT(same.rest_max_m, 1e-9);
    EXPECT_LT(same.posed_max_m, 0.03) << "where two layers touch at rest the nearest point may be on the other";
    EXPECT_LT(same.posed_rms_m, 1e-3);
    EXPECT_LT(same.wrong_zone, 0.005);
    EXPECT_EQ(same.open_edges, 0u);
}

TEST(Deviation, OfAFlattenedTopIsItsHeight)
{
    const model::Model model = pyramid(0.25f);
    const lod::Deviation flat = lod::deviation(model, {&model.parts[0]}, {flat_of(model)}, {});
    EXPECT_NEAR(flat.rest_max_m, 0.25, 1e-6);
    EXPECT_NEAR(flat.posed_max_m, 0.25, 1e-6);
    EXPECT_GT(flat.rest_rms_m, 0.05);
    EXPECT_LT(flat.rest_rms_m, 0.25);
    EXPECT_EQ(flat.open_edges, 0u);
    EXPECT_NEAR(lod::deviation(model, {&model.parts[0]}, {flat_of(model)}, {}, 0.01).rest_max_m, 0.0025, 1e-8);
}

// Of more than 2500 triangles only one point inside of each is measured. It weighs as much as the four of a small mesh,
// so that the way there counts as much as the way back: here a roof that only the level has.
TEST(Deviation, WeighsALargeMeshAsASmallOne)
{
    const auto error_of = [](uint32_t side) {
        const model::Model model = grid(side);
        model::Part level = grid(1).parts[0];
        for (const uint32_t v : {0u, 2u, 1u}) level.indices.push_back(4 + v);
        for (size_t v = 0; v < 3; ++v) level.positions.push_back(level.positions[v] + glm::vec3(0, 0.1f, 0));
        level.joints.assign(7, 0), level.weights.assign(7, 1);
        return lod::deviation(model, {&model.parts[0]}, {level}, {}).rest_rms_m;
    };
    const double small = error_of(34), large = error_of(38);  // 2312 and 2888 triangles
    EXPECT_GT(small, 0.03);
    EXPECT_NEAR(large / small, 1, 0.01);
}

// A mesh that replaces all parts, as proxies do, is compared with all of them.
TEST(Deviation, OfSeveralPartsFromAnEqualSinglePartIsZero)
{
    model::Model model = pyramid(0.25f);
    model::Part other = model.parts[0], all = model.parts[0];
    for (glm::vec3 &p : other.positions) p.x += 3;
    all.positions.insert(all.positions.end(), other.positions.begin(), other.positions.end());
    for (const uint32_t i : other.indices) all.indices.push_back(5 + i);
    all.joints.resize(10, 0), all.weights.resize(10, 1);
    const lod::Deviation same = lod::deviation(model, {&model.parts[0], &other}, {all}, {});
    EXPECT_LT(same.rest_max_m, 1e-6);
    EXPECT_LT(same.posed_max_m, 1e-6);
}

TEST(Deviation, CountsOpenedEdges)
{
    const model::Model model = pyramid(0.25f);
    model::Part torn = model.parts[0];
    torn.indices.resize(9);
    EXPECT_EQ(lod::deviation(model, {&model.parts[0]}, {torn}, {}).open_edges, 1u)
        << "two inner edges lie open, and one at the rim is gone";
}

TEST(Chain, GoesDownInTrianglesAndUpInErrorAndDistance)
{
    model::Model citizen = figures::citizen();
    const size_t parts = citizen.parts.size();
    const std::vector<lod::LevelReport> chain = lod::make_chain(citizen, {});
    ASSERT_GE(chain.size(), 5u);
    EXPECT_EQ(chain[0].distance_m, 0);
    for (size_t k = 1; k < chain.size(); ++k) {
        EXPECT_LT(chain[k].triangles, chain[k - 1].triangles);
        EXPECT_GT(chain[k].distance_m, chain[k - 1].distance_m);
        EXPECT_NEAR(chain[k].distance_m, std::max(lod::switch_distance(chain[k].error_m, 1), chain[k].distance_m),
                    1e-9);
        EXPECT_EQ(chain[k].deviation.open_edges, 0u) << chain[k].triangles;
    }
    EXPECT_LE(chain.back().triangles, 30u);
    EXPECT_GT(citizen.parts.size(), parts);
    EXPECT_NO_THROW(model::check(citizen));
}

TEST(Chain, ServesEveryDistanceWithOneLevelOfEachPart)
{
    model::Model citizen = figures::citizen();
    lod::make_chain(citizen, {});
    for (const float at : {0.0f, 3.0f, 17.0f, 80.0f, 1e6f})
        EXPECT_EQ(std::count_if(citizen.parts.begin(), citizen.parts.end(),
                                [at](const model::Part &part) { return part.lod_min_m <= at && at < part.lod_max_m; }),
                  1);
}

// Below 20 triangles half of a pixel may show another zone where the level begins.
// Proxies of as many triangles are 14 mm off, levels that keep their vertices 10 mm. One whose zones shift too far is
// left out, and the coarser ones that keep theirs stay.
TEST(Chain, CollapsesEdgesAsLongAsZonesKeepTheirAreas)
{
    for (const figures::Builtin &builtin : figures::people()) {
        model::Model person = builtin.make();
        const size_t materials = person.materials.size();
        double shown_m2 = 0;  // half of the visible surface faces an eye, at 60 degrees on average
        for (const double area : lod::visible_areas(person, lod::posed_at_rest(person.rig, pointers_of(person))))
            shown_m2 += 0.5 * area;
        for (const lod::LevelReport &level : lod::make_chain(person, {})) {
            const double pixel_m = level.distance_m * 2 * std::tan(glm::radians(30.0)) / 768;
            const double most = level.triangles < 20 ? std::max(0.02, 0.5 * pixel_m * pixel_m / shown_m2) : 0.02;
            EXPECT_LE(level.zone_area_error, most) << person.name << ", " << level.triangles;
            EXPECT_LE(level.zone_view_error, 0.28) << person.name << ", " << level.triangles;
            EXPECT_EQ(level.zone_view_error > 0, level.triangles <= 128) << person.name << ", " << level.triangles;
        }
        size_t fewest = SIZE_MAX;
        for (const model::Part &part : person.parts)
            if (part.material < materials) fewest = std::min(fewest, model::triangles_of(part).size());
        EXPECT_LE(fewest, 340u) << person.name;
    }
}

TEST(Chain, ShowsOneZoneOnEachTriangleOfAProxy)
{
    model::Model citizen = figures::citizen();
    const size_t materials = citizen.materials.size();
    lod::ChainOptions options;
    options.targets = {600, 120};
    const std::vector<lod::LevelReport> chain = lod::make_chain(citizen, options);
    ASSERT_EQ(chain.size(), 3u);
    ASSERT_EQ(citizen.materials.size(), materials + 1);
    const model::Part &proxy = citizen.parts.back();
    ASSERT_EQ(proxy.material, materials);
    const model::Image &image = citizen.images[citizen.materials[materials].image];
    const auto texel = [&](uint32_t v) {
        const size_t x = static_cast<size_t>(proxy.uvs[v].x * float(image.width));
        const size_t y = static_cast<size_t>(proxy.uvs[v].y * float(image.height));
        return image.rgba.data() + 4 * (y * image.width + x);
    };
    std::vector<uint8_t> shown;
    for (const auto &t : model::triangles_of(proxy)) {
        EXPECT_TRUE(std::equal(texel(t[0]), texel(t[0]) + 4, texel(t[1])));
        EXPECT_TRUE(std::equal(texel(t[0]), texel(t[0]) + 4, texel(t[2])));
        const uint8_t key = texel(t[0])[3];
        EXPECT_TRUE(std::any_of(citizen.zones.begin(), citizen.zones.end(),
                                [key](const model::Zone &zone) { return zone.key == key; }));
        if (std::find(shown.begin(), shown.end(), key) == shown.end()) shown.push_back(key);
    }
    EXPECT_GE(shown.size(), 4u) << "skin, hair, tunic and shoes at least";
    EXPECT_LT(chain[2].deviation.wrong_zone, 0.25);
}

TEST(Chain, LeavesAModelAsItWasWhenItRefuses)
{
    model::Model citizen = figures::citizen();
    const size_t parts = citizen.parts.size();
    lod::ChainOptions options;
    options.targets = {100, 200};
    EXPECT_THROW(lod::make_chain(citizen, options), base::Error);
    options.targets = {100};
    options.tolerance_px = 0;
    EXPECT_THROW(lod::make_chain(citizen, options), base::Error);
    EXPECT_EQ(citizen.parts.size(), parts);
}
