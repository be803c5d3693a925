// Levels show unlit and emitting surface as the character does.
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/figures/figure.h"
#include "lib/lod/chain.h"

namespace claque
{
namespace
{

constexpr float neck_m = 1.5f;

// The citizen whose head is a part of its own, in a zone and a material of its own.
model::Model with_bright_head(const model::Lighting &lighting)
{
    model::Model made = figures::citizen();
    model::Zone lamp;
    lamp.name = "lamp", lamp.key = 1;
    made.zones.push_back(lamp);
    model::Material material;
    material.lighting = lighting;
    material.zone = static_cast<uint32_t>(made.zones.size() - 1);
    made.materials.push_back(material);
    model::Part head = made.parts[0];
    head.material = static_cast<uint32_t>(made.materials.size() - 1);
    head.indices.clear();
    std::vector<uint32_t> rest;
    for (const auto &t : model::triangles_of(made.parts[0])) {
        const bool is_head = made.parts[0].positions[t[0]].y > neck_m;
        std::vector<uint32_t> &to = is_head ? head.indices : rest;
        to.insert(to.end(), t.begin(), t.end());
    }
    made.parts[0].indices = rest;
    made.parts.push_back(head);
    return made;
}

// The share of surface with this lighting that is drawn at a distance.
double share_of(const model::Model &model, const model::Lighting &lighting, float distance_m)
{
    double own = 0, all = 0;
    for (const model::Part &part : model.parts) {
        if (distance_m < part.lod_min_m || distance_m >= part.lod_max_m) continue;
        for (const auto &t : model::triangles_of(part)) {
            const glm::vec3 &a = part.positions[t[0]], &b = part.positions[t[1]], &c = part.positions[t[2]];
            const double area = double(glm::length(glm::cross(b - a, c - a)));
            all += area;
            if (model.materials[part.material].lighting == lighting) own += area;
        }
    }
    return own / all;
}

TEST(ProxyLighting, KeepsItsShareOfTheSurfaceInEveryLevel)
{
    model::Lighting unlit, emitting;
    unlit.unlit = true;
    emitting.emission = {0.2f, 0.4f, 0};
    for (const model::Lighting &lighting : {unlit, emitting}) {
        model::Model model = with_bright_head(lighting);
        const double wanted = share_of(model, lighting, 0);
        const size_t materials = model.materials.size();
        const std::vector<lod::LevelReport> chain = lod::make_chain(model, {});
        ASSERT_GT(chain.size(), 5u);
        ASSERT_GT(model.materials.size(), materials + 1) << "proxies";
        for (const lod::LevelReport &level : chain) {
            const float at = static_cast<float>(level.distance_m) * 1.0001f;
            EXPECT_NEAR(share_of(model, lighting, at), wanted, level.triangles < 100 ? 0.06 : 0.03) << level.triangles;
        }
        EXPECT_NO_THROW(model::check(model));
    }
}

TEST(ProxyLighting, OfAllSurfaceLeavesOnePartAndOneMaterialALevel)
{
    model::Model model = figures::citizen();
    for (model::Material &material : model.materials) material.lighting.unlit = true;
    const std::vector<lod::LevelReport> chain = lod::make_chain(model, {});
    EXPECT_EQ(model.parts.size(), chain.size());
    for (const model::Part &part : model.parts)
        EXPECT_TRUE(model.materials[part.material].lighting.unlit) << part.material << " " << part.indices.size() / 3;
}

}  // namespace
}  // namespace claque
