// The mask that keeps shadows from darkening twice, compared with the plainest test of a pixel against a triangle.
#include "passes/span_mask.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace
{

using claque::passes::PixelBox;
using claque::passes::SpanMask;

constexpr int width = 150, height = 90;

using Triangle = std::array<glm::vec2, 3>;

double side(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

// Distance of a pixel's centre from the outline, pixels; negative outside.
double depth_in(const Triangle &t, double x, double y)
{
    double least = 1e9;
    const double turn = side(t[0], t[1], t[2]) < 0 ? -1 : 1;
    for (size_t k = 0; k < 3; ++k) {
        const glm::dvec2 a = t[k], b = t[(k + 1) % 3];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        least = std::min(least, turn * side(a, b, {x, y}) / length);
    }
    return least;
}

class SpanMasks : public testing::Test
{
protected:
    void SetUp() override
    {
        mask.reserve(width, height);
        mask.begin(width, height);
    }
    // Adds the taken spans to `times`.
    uint32_t take()
    {
        uint32_t boxes = 0;
        mask.take([&](const PixelBox &box) {
            ++boxes;
            for (int y = box.y0; y < box.y1; ++y)
                for (int x = box.x0; x < box.x1; ++x) ++times.at(size_t(y) * width + size_t(x));
        });
        return boxes;
    }
    static Triangle random_triangle(std::mt19937 &random)
    {
        std::uniform_real_distribution<float> x(-60, width + 60), y(-50, height + 50), small(-4, 4);
        Triangle t;
        t[0] = {x(random), y(random)};
        const bool tiny = random() % 2 == 0;
        for (size_t k = 1; k < 3; ++k)
            t[k] = tiny ? t[0] + glm::vec2(small(random), small(random)) : glm::vec2(x(random), y(random));
        return t;
    }

    SpanMask mask{std::pmr::get_default_resource()};
    std::vector<int> times = std::vector<int>(size_t(width) * height, 0);
};

TEST_F(SpanMasks, GivesEveryPixelInsideOnceAndNoneOutside)
{
    std::mt19937 random(7);
    std::vector<Triangle> all;
    for (int round = 0; round < 60; ++round) {
        for (int k = 0; k < 3; ++k) {
            all.push_back(random_triangle(random));
            mask.add(all.back()[0], all.back()[1], all.back()[2]);
        }
        take();
    }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double most = -1e9;
            for (const Triangle &t : all) most = std::max(most, depth_in(t, x + 0.5, y + 0.5));
            const int found = times[size_t(y) * width + size_t(x)];
            ASSERT_LE(found, 1) << x << " " << y;
            if (std::fabs(most) < 1e-3) continue;
            ASSERT_EQ(found, most > 0) << x << " " << y;
        }
}

// Triangles that share an edge leave no seam, wherever the edge runs.
TEST_F(SpanMasks, LeavesNoSeamBetweenNeighbours)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> at(0, 1);
    for (int round = 0; round < 200; ++round) {
        mask.begin(width, height);
        times.assign(times.size(), 0);
        const glm::vec2 middle(20 + 100 * at(random), 10 + 70 * at(random));
        const glm::vec2 corners[4] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
        for (int k = 0; k < 4; ++k) mask.add(middle, corners[(k + 1) % 4], corners[k]);
        take();
        for (const int found : times) ASSERT_EQ(found, 1);
    }
}

TEST_F(SpanMasks, JoinsRowsThatAreAlikeIntoOneBox)
{
    mask.add({10, 10}, {140, 10}, {140, 60});
    mask.add({10, 10}, {140, 60}, {10, 60});
    EXPECT_EQ(take(), 1u);
    EXPECT_EQ(take(), 0u);
    mask.add({0, 20}, {150, 20}, {150, 50});
    mask.add({0, 20}, {150, 50}, {0, 50});
    EXPECT_EQ(take(), 2u);  // left and right of the existing span
}

TEST_F(SpanMasks, BeginsAnewInAnotherSize)
{
    mask.add({0, 0}, {150, 0}, {0, 90});
    take();
    mask.begin(64, 10);
    mask.add({-1, -1}, {300, -1}, {-1, 300});
    uint32_t pixels = 0;
    mask.take([&](const PixelBox &box) { pixels += uint32_t((box.x1 - box.x0) * (box.y1 - box.y0)); });
    EXPECT_EQ(pixels, 640u);
}

}  // namespace
