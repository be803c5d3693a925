// Sun and awning: the sun is where Rome has it, the awning shades what lies behind it, and the outer wall does too.
#include <cmath>

#include <gtest/gtest.h>

#include "samples/scenes/amphitheatre/exposure.h"

namespace
{

using namespace scenes;
using namespace scenes::amphitheatre;

struct Day {
    explicit Day(double hour) : light(daylight_at(hour)), velarium(plan, light), exposure(plan, velarium, light) {}
    Plan plan;
    Daylight light;
    Velarium velarium;
    Exposure exposure;
};

Vec3 above_row(const Plan &plan, double turn, double out, double y)
{
    const Spot spot = plan.oval().at(turn, out);
    return {static_cast<float>(spot.x), static_cast<float>(y), static_cast<float>(spot.z)};
}

TEST(AmphitheatreLight, TheSunStandsHighestAtNoonInTheSouth)
{
    const Daylight noon = daylight_at(12), morning = daylight_at(8), evening = daylight_at(17);
    EXPECT_NEAR(std::asin(static_cast<double>(noon.to_sun.y)) * 180 / 3.141592653589793, 90 - 41.89 + 22, 0.01);
    EXPECT_GT(noon.to_sun.y, morning.to_sun.y);
    EXPECT_GT(morning.to_sun.y, evening.to_sun.y);
    EXPECT_GT(morning.to_sun.x, 0.5f);  // the long axis points east
    EXPECT_LT(evening.to_sun.x, -0.5f);
    EXPECT_GT(noon.to_sun.z, 0.2f);
    for (const Daylight &light : {noon, morning, evening})
        EXPECT_NEAR(std::hypot(static_cast<double>(light.to_sun.x), static_cast<double>(light.to_sun.y),
                               static_cast<double>(light.to_sun.z)),
                    1, 1e-6);
}

TEST(AmphitheatreLight, StripsReachFarOnTheSideOfTheSunOnly)
{
    const Day morning(8);
    EXPECT_GT(morning.velarium.reach_of(0), 25);
    EXPECT_LT(morning.velarium.reach_of(bay_count / 2), 6);
}

TEST(AmphitheatreLight, LinenTakesMostOfTheSunFromWhatLiesBehindIt)
{
    const Day noon(12);
    const double south = 1.5707963267948966;
    EXPECT_NEAR(noon.velarium.passes(above_row(noon.plan, south, 40, 35)), Velarium::through_linen, 1e-9);
    EXPECT_EQ(noon.velarium.passes({0, 1, 0}), 1);
    EXPECT_EQ(noon.velarium.passes(above_row(noon.plan, -south, 40, 35)), 1);
}

TEST(AmphitheatreLight, TheOuterWallHidesALowSun)
{
    const Day early(6);
    EXPECT_EQ(early.exposure.sun_at({0, 0.5f, 0}), 0);
    EXPECT_GT(early.exposure.sun_at(above_row(early.plan, 3.141592653589793, 46, 44)), 0.9);
    EXPECT_EQ(early.exposure.sun_at(above_row(early.plan, 0, building_m + 5, 2)), 1);
}

TEST(AmphitheatreLight, PeopleInTheShadeAreDarkerButSeen)
{
    const Day noon(12);
    EXPECT_NEAR(noon.exposure.of_person({0, 1, 0}), 1, 1e-9);
    const double shaded = noon.exposure.of_person(above_row(noon.plan, 1.5707963267948966, 40, 35));
    EXPECT_LT(shaded, 0.9);
    EXPECT_GT(shaded, 0.5);
}

}  // namespace
