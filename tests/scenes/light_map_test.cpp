// Shadows painted into a picture of the ground: their position and darkness.
#include "samples/scenes/light_map.h"

#include <gtest/gtest.h>

namespace scenes
{
namespace
{

clq_transform at(double x, double z)
{
    clq_transform transform = {};
    transform.position[0] = x, transform.position[2] = z;
    transform.orientation_xyzw[3] = 1, transform.scale = 1;
    return transform;
}

class LightMapTest : public testing::Test
{
protected:
    // The sun is in the east, so shadows fall towards -x, as long as individuals are tall.
    static LightMap of(const std::vector<clq_transform> &places)
    {
        Shadows shadows;
        shadows.cast(places, {0.7f, 0.7f, 0}, 1.75f, 0.95f);
        LightMap map(-10, 10);
        map.paint(shadows);
        return map;
    }
    static int light(const LightMap &map, double x, double z)
    {
        const Image &image = map.image();
        const auto texel = [&](double metres) {
            return static_cast<size_t>(static_cast<double>(map.coordinate(static_cast<float>(metres))) * image.side_px);
        };
        return image.rgba[4 * (texel(z) * static_cast<size_t>(image.side_px) + texel(x))];
    }
};

TEST_F(LightMapTest, IsWhiteWhereNoActorStands)
{
    const LightMap map = of({});
    for (const uint8_t value : map.image().rgba) ASSERT_EQ(value, 255);
    EXPECT_EQ(map.coordinate(-10), 0);
    EXPECT_EQ(map.coordinate(10), 1);
}

TEST_F(LightMapTest, IsDarkAwayFromTheSunAndNowhereElse)
{
    const LightMap map = of({at(3, -4)});
    EXPECT_LT(light(map, 3, -4), 190) << "at the feet";
    EXPECT_LT(light(map, 2.2, -4), 190);
    EXPECT_EQ(light(map, 4, -4), 255) << "towards the sun";
    EXPECT_EQ(light(map, 0.5, -4), 255) << "beyond the head";
    EXPECT_EQ(light(map, 2.2, -5), 255);
    EXPECT_EQ(light(map, -3, 4), 255);
}

TEST_F(LightMapTest, IsDarkerWhereTwoShadowsMeetAndStaysInItsSquare)
{
    const int one = light(of({at(0, 0)}), -0.6, 0), two = light(of({at(0, 0), at(0.1, 0)}), -0.6, 0);
    EXPECT_LT(two, one);
    EXPECT_GT(two, 0);
    const LightMap edge = of({at(-9.9, 9.9), at(30, 0), at(9.9, -9.9)});
    EXPECT_LT(light(edge, 9.5, -9.9), 230);
}

}  // namespace
}  // namespace scenes
