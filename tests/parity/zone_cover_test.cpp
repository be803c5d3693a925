// The zones that a triangle is said to show, against the texels under many points of it.
#include "samples/parity/write/zone_cover.h"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "samples/scenes/random.h"

namespace parity
{
namespace
{

constexpr uint32_t side = 8;

// A texture of side x side texels without the call that fills one.
Texels texels(clq_wrap wrap)
{
    Texels out;
    out.width = out.height = side;
    out.wrap_s = out.wrap_t = wrap;
    return out;
}

std::set<uint32_t> zones_of(const std::vector<float> &uvs, const Texels &texture)
{
    const uint32_t indices[] = {0, 1, 2};
    clq_triangles triangles = clq_triangles_init();
    triangles.index_count = 3, triangles.indices = indices;
    std::set<uint32_t> out;
    for (const ZoneTriangles &found : zone_cover(triangles, uvs.data(), texture)) out.insert(found.zone);
    return out;
}

uint32_t zone_at(double u, double v, const Texels &texture)
{
    const auto place = [&](double t) {
        const double texel = std::floor(t * side);
        if (texture.wrap_s == CLQ_WRAP_CLAMP) return static_cast<size_t>(std::fmin(std::fmax(texel, 0), side - 1));
        return static_cast<size_t>(texel - side * std::floor(texel / side));
    };
    return texture.zones[place(v) * side + place(u)];
}

TEST(ZoneCover, HoldsEveryZoneUnderATriangleAndHardlyMore)
{
    size_t listed = 0, seen = 0;
    for (const clq_wrap wrap : {CLQ_WRAP_REPEAT, CLQ_WRAP_CLAMP})
        for (uint32_t round = 0; round < 100; ++round) {
            Texels texture = texels(wrap);
            const auto random = [&](uint32_t i) { return scenes::random_unit(round, i, scenes::Purpose::phase); };
            for (uint32_t i = 0; i < side * side; ++i) texture.zones.push_back(static_cast<uint32_t>(random(i) * 9));
            std::vector<float> uvs;
            for (uint32_t i = 0; i < 6; ++i) uvs.push_back(static_cast<float>(random(100 + i) * 0.6 - 0.2));
            const std::set<uint32_t> found = zones_of(uvs, texture);
            std::set<uint32_t> under;
            constexpr int steps = 300;
            for (int a = 0; a <= steps; ++a)
                for (int b = 0; a + b <= steps; ++b) {
                    const double s = double(a) / steps, t = double(b) / steps, r = 1 - s - t;
                    under.insert(zone_at(r * double(uvs[0]) + s * double(uvs[2]) + t * double(uvs[4]),
                                         r * double(uvs[1]) + s * double(uvs[3]) + t * double(uvs[5]), texture));
                }
            for (const uint32_t zone : under) EXPECT_TRUE(found.count(zone)) << "round " << round << ", zone " << zone;
            listed += found.size(), seen += under.size();
        }
    EXPECT_GT(seen, 600u);
    EXPECT_LE(double(listed), 1.02 * double(seen));
}

TEST(ZoneCover, ListsATriangleForEachOfItsZonesInTheirOrder)
{
    Texels texture = texels(CLQ_WRAP_REPEAT);
    for (uint32_t i = 0; i < side * side; ++i) texture.zones.push_back(i % side < 4 ? 5 : i < 32 ? 2 : CLQ_NONE);
    const std::vector<float> uvs = {0.1f, 0.1f, 0.2f, 0.1f, 0.1f, 0.2f, 0.7f, 0.1f, 0.6f, 0.9f};
    const uint32_t indices[] = {0, 1, 3, 0, 1, 2, 1, 4, 3};  // both zones, the first alone, both zones and holes
    clq_triangles triangles = clq_triangles_init();
    triangles.index_count = 9, triangles.indices = indices;
    const std::vector<ZoneTriangles> found = zone_cover(triangles, uvs.data(), texture);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].zone, 2u);
    EXPECT_EQ(found[0].indices, (std::vector<uint32_t>{0, 1, 3, 1, 4, 3}));
    EXPECT_EQ(found[1].zone, 5u);
    EXPECT_EQ(found[1].indices, (std::vector<uint32_t>{0, 1, 3, 0, 1, 2, 1, 4, 3}));
}

TEST(ZoneCover, TakesEveryZoneWhereATextureRepeatsManyTimes)
{
    Texels texture = texels(CLQ_WRAP_REPEAT);
    for (uint32_t i = 0; i < side * side; ++i) texture.zones.push_back(i % 7);
    EXPECT_EQ(zones_of({0, 0, 40, 0, 0, 40}, texture).size(), 7u);
    EXPECT_EQ(zones_of({0, 0, NAN, 0, 0, 40}, texture).size(), 7u);
}

}  // namespace
}  // namespace parity
