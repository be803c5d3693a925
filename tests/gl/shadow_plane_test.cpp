// The plane of a shadow, without GL: which light throws one, and where, by the definition of both.
#include "passes/shadow_plane.h"

#include <cmath>

#include <gtest/gtest.h>

namespace
{

using namespace claque;

struct Shadowed {
    passes::ShadowOptions options;
    draw::DrawList list{std::pmr::get_default_resource()};
    draw::Item item;
    Shadowed()
    {
        list.eye[1] = 2;  // above the ground
        options.ground = passes::ShadowGround::plane, options.lift = 0;
    }
    void light(double x, double y, double z)
    {
        options.light[0] = x, options.light[1] = y, options.light[2] = z, options.light[3] = 0;
    }
    bool find(passes::ShadowPlane &plane)
    {
        passes::ShadowPlaneFinder finder(options, list);
        return finder.find(item, plane);
    }
};

TEST(ShadowPlane, OfADistantLightDependsOnItsDirectionAlone)
{
    Shadowed at;
    for (const double sine : {-0.5, 0.0, 0.015, 0.025, 0.5, 1.0})
        for (const double length : {1e-3, 0.5, 1.0, 1e3}) {
            at.light(0.6 * std::sqrt(1 - sine * sine) * length, sine * length,
                     0.8 * std::sqrt(1 - sine * sine) * length);
            passes::ShadowPlane plane;
            EXPECT_EQ(at.find(plane), sine > 0.02) << "sine " << sine << ", length " << length;
            if (sine <= 0.02) continue;
            // From an inch above the ground to the ground, along the light.
            const glm::dvec3 p(0.3, -2 + 0.0254, -4), q = plane.project(p);
            EXPECT_NEAR(q.y, -2, 1e-12);
            const double cosine = std::sqrt(1 - sine * sine);
            EXPECT_NEAR(q.x, p.x - 0.0254 * 0.6 * cosine / sine, 1e-9);
            EXPECT_NEAR(q.z, p.z - 0.0254 * 0.8 * cosine / sine, 1e-9);
        }
}

TEST(ShadowPlane, IsMissingBelowTheGround)
{
    Shadowed at;
    passes::ShadowPlane plane;
    at.options.plane_height = 1.999;
    EXPECT_TRUE(at.find(plane));
    at.options.plane_height = 2.001;
    EXPECT_FALSE(at.find(plane));
}

}  // namespace
