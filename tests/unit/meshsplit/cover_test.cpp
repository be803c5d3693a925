// Zone coverage, compared with samplers and with a slow independent answer.
#include "meshsplit/cover.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "lib/base/hash.h"

namespace claque::test
{

using meshsplit::TexelGrid;
using meshsplit::UvTriangle;
using model::Wrap;

namespace
{

using Texels = std::set<std::pair<uint32_t, uint32_t>>;  // column, row

Texels covered(const TexelGrid &grid, const UvTriangle &triangle)
{
    std::vector<meshsplit::TexelSpan> spans;
    meshsplit::cover(grid, triangle, spans);
    Texels out;
    for (const auto &span : spans)
        for (uint32_t i = 0; i < span.count; ++i) {
            EXPECT_LT(span.first + i, grid.width);
            EXPECT_LT(span.row, grid.height);
            out.insert({span.first + i, span.row});
        }
    return out;
}

// GL 1.1's NEAREST, for one coordinate.
uint32_t sampled(double coordinate, uint32_t size, Wrap wrap)
{
    if (wrap == Wrap::clamp) return uint32_t(std::min(std::floor(std::clamp(coordinate, 0.0, 1.0) * size), size - 1.0));
    const double f = coordinate - std::floor(coordinate);
    return uint32_t(std::min(std::floor(f * size), size - 1.0));
}

struct Random {
    uint64_t state;
    double operator()(double low, double high)
    {
        state = base::mix(state + 0x9e3779b97f4a7c15ULL);
        return low + (high - low) * double(base::unit(state));
    }
};

UvTriangle random_triangle(Random &random, double low, double high)
{
    UvTriangle t;
    for (auto &corner : t.corners) corner = {float(random(low, high)), float(random(low, high))};
    const double kind = random(0, 10);
    if (kind < 1) t.corners[2] = t.corners[0] + 0.37f * (t.corners[1] - t.corners[0]);  // a line
    else if (kind < 2) t.corners[1] = t.corners[2] = t.corners[0];                      // a point
    else if (kind < 4)                                                                  // on texel corners
        for (auto &corner : t.corners)
            corner = glm::vec2(std::floor(corner.x * 32) / 32, std::floor(corner.y * 16) / 16);
    return t;
}

struct P {
    long double x, y;
};

// The part of a polygon where keep(p) >= 0; keep is linear.
template <class Keep>
std::vector<P> clipped(const std::vector<P> &polygon, const Keep &keep)
{
    std::vector<P> out;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const P a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const long double ka = keep(a), kb = keep(b);
        if (ka >= 0) out.push_back(a);
        if ((ka > 0 && kb < 0) || (ka < 0 && kb > 0)) {
            const long double f = ka / (ka - kb);
            out.push_back({a.x + (b.x - a.x) * f, a.y + (b.y - a.y) * f});
        }
    }
    return out;
}

// Whether the triangle, in texels, meets the closed box of texel (i, j) grown by `slack`.
bool meets(const UvTriangle &t, const TexelGrid &grid, double i, double j, long double slack)
{
    std::vector<P> polygon;
    for (const auto &corner : t.corners)
        polygon.push_back({(long double)(corner.x) * grid.width, (long double)(corner.y) * grid.height});
    polygon = clipped(polygon, [&](P p) { return p.x - ((long double)(i)-slack); });
    polygon = clipped(polygon, [&](P p) { return ((long double)(i) + 1 + slack) - p.x; });
    polygon = clipped(polygon, [&](P p) { return p.y - ((long double)(j)-slack); });
    polygon = clipped(polygon, [&](P p) { return ((long double)(j) + 1 + slack) - p.y; });
    return !polygon.empty();
}

}  // namespace

TEST(Cover, HoldsEveryTexelThatAnyPointOfTheTriangleSamples)
{
    Random random{1};
    for (int round = 0; round < 400; ++round) {
        const TexelGrid grid{32, 16, round % 2 ? Wrap::clamp : Wrap::repeat, round % 3 ? Wrap::repeat : Wrap::clamp};
        const UvTriangle t = random_triangle(random, round % 5 ? -0.3 : -3, round % 5 ? 1.4 : 4);
        const Texels found = covered(grid, t);
        for (int k = 0; k < 600; ++k) {
            double a = random(0, 1), b = random(0, 1);
            if (a + b > 1) a = 1 - a, b = 1 - b;
            if (k < 3) a = k == 1, b = k == 2;       // the corners themselves
            else if (k < 60) b = k % 3 ? 0 : 1 - a;  // the edges
            const double u = t.corners[0].x + a * (double(t.corners[1].x) - t.corners[0].x) +
                             b * (double(t.corners[2].x) - t.corners[0].x);
            const double v = t.corners[0].y + a * (double(t.corners[1].y) - t.corners[0].y) +
                             b * (double(t.corners[2].y) - t.corners[0].y);
            const std::pair<uint32_t, uint32_t> texel{sampled(u, grid.width, grid.wrap_s),
                                                      sampled(v, grid.height, grid.wrap_t)};
            ASSERT_TRUE(found.count(texel)) << "round " << round << ": uv " << u << ' ' << v;
        }
    }
}

TEST(Cover, IsExactlyTheTexelsWhoseGrownBoxTheTriangleMeets)
{
    Random random{2};
    for (int round = 0; round < 300; ++round) {
        const TexelGrid grid{32, 16, Wrap::repeat, Wrap::repeat};
        const UvTriangle t = random_triangle(random, -0.7, 1.6);
        const Texels found = covered(grid, t);
        const long double slack = meshsplit::slack_of(grid, t);
        Texels surely, perhaps;
        for (int j = -16; j < 32; ++j)
            for (int i = -32; i < 64; ++i) {
                const std::pair<uint32_t, uint32_t> texel{uint32_t(i + 32) % 32, uint32_t(j + 16) % 16};
                if (meets(t, grid, i, j, slack - 1e-9L)) surely.insert(texel);
                if (meets(t, grid, i, j, slack + 1e-9L)) perhaps.insert(texel);
            }
        for (const auto &texel : surely) ASSERT_TRUE(found.count(texel)) << round;
        for (const auto &texel : found) ASSERT_TRUE(perhaps.count(texel)) << round << ": too much";
    }
}

TEST(Cover, APointInsideATexelIsThatTexelAlone)
{
    const TexelGrid grid{16, 16, Wrap::repeat, Wrap::clamp};
    const glm::vec2 uv(5.5f / 16, 9.5f / 16);
    EXPECT_EQ(covered(grid, {{uv, uv, uv}}), (Texels{{5, 9}}));
}

TEST(Cover, ACornerBetweenFourTexelsTouchesAllFourAndWrapsAtTheEdge)
{
    const glm::vec2 uv(0.0f, 0.5f);
    EXPECT_EQ(covered({16, 16, Wrap::repeat, Wrap::repeat}, {{uv, uv, uv}}),
              (Texels{{0, 7}, {0, 8}, {15, 7}, {15, 8}}));
    EXPECT_EQ(covered({16, 16, Wrap::clamp, Wrap::repeat}, {{uv, uv, uv}}), (Texels{{0, 7}, {0, 8}}));
}

TEST(Cover, ClampingShowsTheEdgeTexelsOfWhatLiesBeyond)
{
    const TexelGrid grid{8, 8, Wrap::clamp, Wrap::clamp};
    EXPECT_EQ(covered(grid, {{{3, 2}, {4, 2}, {3, 5}}}), (Texels{{7, 7}}));
    Texels left_column;
    for (uint32_t row = 0; row < 8; ++row) left_column.insert({0, row});
    EXPECT_EQ(covered(grid, {{{-3, -9}, {-2, 9}, {-3, 9}}}), left_column);
}

TEST(Cover, ATriangleOverManyWrapsShowsTheWholeTexture)
{
    for (const float size : {3.0f, 40.0f, 1e6f, 1e30f}) {
        const UvTriangle t{{{0, 0}, {size, 0}, {0, size}}};
        EXPECT_EQ(covered({16, 16, Wrap::repeat, Wrap::repeat}, t).size(), 256u) << size;
    }
}

}  // namespace claque::test
