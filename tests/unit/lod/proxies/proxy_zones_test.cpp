// The zone of each triangle of a proxy, compared with the best of all assignments.
#include "lib/lod/proxies/proxy_zones.h"

#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/lod/proxies/zone_cost.h"
#include "lib/lod/proxies/zone_points.h"

using namespace claque;

namespace
{

constexpr uint32_t zones = 3, triangles = 8;

double random_unit(uint64_t seed, uint64_t i) { return double(base::unit(base::mix(seed * 1000 + i))); }

// Eight triangles round a centre with six corners at random distances; a zone for each of three materials.
model::Model octahedron(uint64_t seed)
{
    model::Model model;
    model.rig.parents.push_back(model::none);
    model.rig.rest.emplace_back();
    model.rig.node_names.emplace_back("root");
    model.rig.palette.emplace_back();
    for (uint32_t zone = 0; zone < zones; ++zone) {
        model.zones.emplace_back();
        model.materials.emplace_back();
        model.materials.back().zone = zone;
    }
    model::Part part;
    part.node = 0, part.material = 0;
    for (uint32_t i = 0; i < 6; ++i) {
        glm::vec3 p(0);
        p[static_cast<int>(i / 2)] = static_cast<float>((i % 2 ? -1 : 1) * (0.6 + random_unit(seed, i)));
        part.positions.push_back(p);
    }
    for (uint32_t i = 0; i < triangles; ++i) {
        const uint32_t x = i & 1, y = 2 + (i >> 1 & 1), z = 4 + (i >> 2 & 1);
        const bool turned = (x + y + z) % 2 != 0;
        for (const uint32_t v : {x, turned ? z : y, turned ? y : z}) part.indices.push_back(v);
    }
    part.joints.assign(6, 0), part.weights.assign(6, 1);
    model.parts.push_back(part);
    return model;
}

struct Case {
    model::Model model;
    lod::PosedParts level;
    std::vector<double> areas;  // as fractions
    std::vector<lod::ZoneAreas> zone_areas;
    std::vector<double> wanted;

    explicit Case(uint64_t seed) : model(octahedron(seed)), level(lod::posed_at_rest(model.rig, {&model.parts[0]}))
    {
        double all = 0;
        for (uint32_t t = 0; t < triangles; ++t) areas.push_back(lod::area_of(level, t)), all += areas.back();
        for (double &area : areas) area /= all;
        wanted.assign(zones + 1, 0);
        for (uint32_t t = 0; t < triangles; ++t) {
            zone_areas.emplace_back();
            double sum = 0;
            for (uint32_t zone = 0; zone < zones; ++zone)
                sum += zone_areas[t][zone] = 0.05 + random_unit(seed, 100 + 8 * zone + t);
            for (auto &[zone, area] : zone_areas[t]) area *= areas[t] / sum, wanted[zone] += area;
        }
    }
    double wrong(const std::vector<uint32_t> &shown) const
    {
        double sum = 0;
        for (uint32_t t = 0; t < triangles; ++t) sum += areas[t] - zone_areas[t].at(shown[t]);
        return sum;
    }
    double most_off(const std::vector<uint32_t> &shown) const
    {
        std::vector<double> area_fractions(zones, 0);
        for (uint32_t t = 0; t < triangles; ++t) area_fractions[shown[t]] += areas[t];
        double most = 0;
        for (uint32_t zone = 0; zone < zones; ++zone)
            most = std::max(most, std::abs(area_fractions[zone] - wanted[zone]));
        return most;
    }
};

}  // namespace

TEST(ProxyZones, CostAboutAsLittleAsTheBestOfAllAssignments)
{
    int kept = 0;
    for (uint64_t seed = 1; seed <= 60; ++seed) {
        const Case one(seed);
        double least = 2;
        std::vector<uint32_t> way(triangles, 0);
        for (uint32_t i = 0; i < 6561; ++i) {
            for (uint32_t t = 0, rest = i; t < triangles; ++t, rest /= zones) way[t] = rest % zones;
            if (one.most_off(way) <= 0.0195) least = std::min(least, one.wrong(way));
        }
        const std::vector<uint32_t> chosen =
            lod::assign_zones(one.model, one.level, one.level, one.zone_areas, {one.wanted});
        if (least == 2) continue;  // no assignment keeps the fractions
        ++kept;
        EXPECT_LE(one.most_off(chosen), 0.02) << seed;
        EXPECT_LE(one.wrong(chosen), least + 0.03) << seed;
    }
    EXPECT_GT(kept, 30);
}

TEST(ProxyZones, ShowTheLargestZonesWhereAreaFractionsAllowIt)
{
    Case one(7);
    for (uint32_t t = 0; t < triangles; ++t) one.zone_areas[t] = {{t < 4 ? 0u : 2u, one.areas[t]}};
    one.wanted.assign(zones + 1, 0);
    for (uint32_t t = 0; t < triangles; ++t) one.wanted[t < 4 ? 0 : 2] += one.areas[t];
    const std::vector<uint32_t> chosen =
        lod::assign_zones(one.model, one.level, one.level, one.zone_areas, {one.wanted});
    for (uint32_t t = 0; t < triangles; ++t) EXPECT_EQ(chosen[t], t < 4 ? 0u : 2u);
}

// Of three zones the source shows two. Triangles that stand for nothing cost nothing in any, and a fifth of the areas
// is missing, so that other zones would come nearer to them.
TEST(ProxyZones, ShowNoZoneThatTheSourceLacks)
{
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        Case one(seed);
        for (uint32_t t = 0; t < triangles; ++t) one.zone_areas[t] = {{t % 2, one.areas[t]}};
        one.wanted = {0.4, 0.4, 0, 0};
        const std::vector<double> weights(triangles, 0);
        lod::ZoneGoals goals{one.wanted};
        goals.views.source = {{1, 0, 0, 0}, {0, 0, 0, 0}};
        goals.views.triangles = {one.areas, one.areas};
        for (const uint32_t zone : lod::assign_zones(one.model, one.level, one.level, one.zone_areas, goals, weights))
            EXPECT_LT(zone, 2u) << seed;
    }
}

// Zone 1 is on a second body alone, whose surface is cut out; nothing shows zone 2.
TEST(ZoneCost, OfAZoneThatIsCutOutIsThatOfAnAbsentOne)
{
    Case one(5);
    model::Model &model = one.model;
    model.images.emplace_back();
    model.images[0].width = model.images[0].height = 1;
    model.images[0].rgba = {255, 255, 255, 0};
    model.materials[1].image = 0, model.materials[1].alpha_mode = model::AlphaMode::mask;
    model::Part body = model.parts[0];
    body.material = 1, body.uvs.assign(body.positions.size(), {0.5f, 0.5f});
    for (glm::vec3 &p : body.positions) p.x += 0.3f;
    for (const bool cut : {true, false}) {
        model.images[0].rgba[3] = cut ? 0 : 255;
        const lod::PosedParts fine = lod::posed_at_rest(model.rig, {&model.parts[0], &body});
        const lod::ZoneCost cost(model, fine, one.level, std::vector<lod::ZoneAreas>(triangles, {{0, 1}}), one.areas,
                                 {});
        for (size_t t = 0; t < triangles; ++t) EXPECT_EQ(cost.of(t, 1) == cost.of(t, 2), cut) << t;
        const std::vector<lod::ZonePoints> points = lod::zone_points_of(model, fine, nullptr);
        EXPECT_FALSE(points[0].points.empty());
        EXPECT_EQ(points[1].points.empty(), cut);
        EXPECT_EQ(points[1].nearest.has_value(), !cut);
    }
}
