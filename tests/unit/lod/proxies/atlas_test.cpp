// Atlases of proxies: triangles laid flat without overlap, and zones in the same positions as on the source.
#include "lib/lod/proxies/atlas.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/figures/figure.h"
#include "lib/lod/proxies/proxy.h"
#include "lib/lod/proxies/proxy_image.h"
#include "lib/lod/surface/nearest.h"

using namespace claque;

namespace
{

std::vector<const model::Part *> parts_of(const model::Model &model)
{
    std::vector<const model::Part *> parts;
    for (const model::Part &part : model.parts) parts.push_back(&part);
    return parts;
}

lod::ProxyLevels proxies_of(const model::Model &model, size_t triangles)
{
    lod::ProxyMeshOptions options;
    options.targets = {triangles};
    return lod::make_proxies(model, parts_of(model), options);
}

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

bool inside(const std::array<glm::dvec2, 3> &t, glm::dvec2 p)
{
    for (size_t k = 0; k < 3; ++k)
        if (cross(t[(k + 1) % 3] - t[k], p - t[k]) <= 0) return false;
    return true;
}

// The fraction of a level's surface that shows a zone which the source does not have within `metres`.
double part_further_than(double metres, model::Model &shown, const lod::ProxyLevels &proxies)
{
    lod::add_to_model(proxies, shown);
    const lod::ProxySource source(shown, parts_of(shown));
    std::vector<std::vector<lod::NearestPoint::Triangle>> points(shown.zones.size());
    for (const lod::SurfaceSample &sample : lod::sample_surface(source.fine, 20000)) {
        const glm::dvec3 p = lod::position_of(source.fine, sample.point);
        points.at(lod::zone_at(shown, source.fine, sample.point)).push_back({p, p, p});
    }
    std::vector<lod::NearestPoint> zones;
    for (auto &zone : points) zones.emplace_back(std::move(zone));
    const lod::PosedParts level = source.at_rest(proxies.parts[0]);
    double off = 0, all = 0;
    for (const lod::SurfaceSample &sample : lod::sample_surface(level, 5000)) {
        all += sample.area;
        const uint32_t zone = lod::zone_at(shown, level, sample.point);
        if (std::sqrt(zones.at(zone).to(lod::position_of(level, sample.point)).distance_squared) > metres)
            off += sample.area;
    }
    return off / all;
}

}  // namespace

TEST(Atlas, LaysEachTriangleInsideItsChartAndNoneOnAnother)
{
    const model::Model citizen = figures::citizen();
    lod::ProxyMeshOptions options;
    options.targets = {250};
    const lod::ProxySource source(citizen, parts_of(citizen));
    const lod::PosedParts level = source.at_rest(lod::proxy_meshes(citizen, parts_of(citizen), options)[0]);
    const lod::Atlas atlas = lod::build_atlas(level, 32);
    std::vector<int> owners(size_t(atlas.width) * atlas.height, 0);
    size_t triangles = 0;
    for (const lod::Chart &chart : atlas.charts) {
        ASSERT_LE(chart.x + chart.width, atlas.width);
        ASSERT_LE(chart.y + chart.height, atlas.height);
        for (uint32_t y = chart.y; y < chart.y + chart.height; ++y)
            for (uint32_t x = chart.x; x < chart.x + chart.width; ++x)
                EXPECT_EQ(owners[size_t(y) * atlas.width + x]++, 0) << "two charts at " << x << ", " << y;
        const double edge = lod::atlas_gutter - 1e-9;
        for (const uint32_t t : chart.triangles) {
            ++triangles;
            for (const glm::dvec2 p : atlas.texel_coords[t]) {
                EXPECT_GE(p.x, chart.x + edge);
                EXPECT_GE(p.y, chart.y + edge);
                EXPECT_LE(p.x, chart.x + chart.width - edge);
                EXPECT_LE(p.y, chart.y + chart.height - edge);
            }
            for (const lod::SurfaceSample &sample : lod::sample_surface(level, 2000)) {
                if (sample.point.triangle != t) continue;
                const glm::dvec3 w = sample.point.weights;
                const glm::dvec2 p =
                    w.x * atlas.texel_coords[t][0] + w.y * atlas.texel_coords[t][1] + w.z * atlas.texel_coords[t][2];
                for (const uint32_t other : chart.triangles)
                    if (other != t) {
                        EXPECT_FALSE(inside(atlas.texel_coords[other], p)) << t << " lies on " << other;
                    }
            }
        }
    }
    EXPECT_EQ(triangles, level.triangles().size());
    EXPECT_LT(atlas.charts.size(), level.triangles().size() / 4);
}

TEST(Atlas, KeepsTheShapeOfFlatCharts)
{
    model::Part part;
    part.positions = {{0, 0, 0}, {3, 0, 0}, {3, 0, 1}, {0, 0, 1}};
    part.indices = {0, 2, 1, 0, 3, 2};
    part.joints.assign(4, 0), part.weights.assign(4, 1);
    lod::PosedParts level({&part});
    const math::Affine stay;
    level.pose(model::Rig(), base::Span<const math::Affine>(&stay, 1), {});
    const lod::Atlas atlas = lod::build_atlas(level, 64);
    ASSERT_EQ(atlas.charts.size(), 1u);
    for (const lod::PosedParts::Triangle &t : level.triangles())
        for (size_t k = 0; k < 3; ++k) {
            const size_t i = size_t(&t - level.triangles().data()), next = (k + 1) % 3;
            EXPECT_NEAR(glm::length(atlas.texel_coords[i][next] - atlas.texel_coords[i][k]) * atlas.texel_size,
                        glm::length(level.corner(t, next) - level.corner(t, k)), 1e-9);
        }
}

// Beyond one zone per triangle: a proxy of 250 triangles, seen from where a pixel is 5 cm.
TEST(ProxyLevels, ShowZonesWhereTheyAreOnTheSource)
{
    for (const figures::Builtin &person : figures::people()) {
        SCOPED_TRACE(person.name);
        model::Model model = person.make();
        const lod::ProxyLevels proxies = proxies_of(model, 250);
        EXPECT_LT(part_further_than(0.1, model, proxies), 0.01);
    }
}

TEST(ProxyLevels, ShowWhatEachTextureSetShows)
{
    for (const size_t triangles : {250, 120}) {
        model::Model model = figures::citizen();
        ASSERT_FALSE(model.texture_sets.empty());
        const size_t images = model.images.size();
        lod::add_to_model(proxies_of(model, triangles), model);
        ASSERT_EQ(model.texture_sets[0].images.size(), model.materials.size());
        const uint32_t other = model.texture_sets[0].images.back();
        ASSERT_NE(other, model::none) << triangles;
        ASSERT_GT(other, images);
        const model::Image &first = model.images[model.materials.back().image], &second = model.images[other];
        EXPECT_NE(first.rgba, second.rgba);
        EXPECT_EQ(first.rgba.size(), second.rgba.size());
    }
}
