// Shadows of static objects: their outlines projected on the ground along the sunlight and cut at the ground's
// triangles, so that they lie in these, and no spot is darkened twice.
#pragma once

#include "samples/scenes/town/pieces.h"
#include "samples/scenes/town/terrain.h"

namespace scenes::town
{

class SunShadows
{
public:
    SunShadows(Pieces &pieces, const Terrain &terrain, Vec3 to_sun);

    // The shadow of the hull of these points, as on level ground at this height.
    void cast(const std::vector<Vec3> &points, double ground_y);

private:
    using Outline = std::vector<Point>;  // convex
    struct Shadow {
        Outline outline;
        double x0, z0, x1, z1;
    };
    void lay(const Outline &part);

    Pieces &pieces_;
    const Terrain &terrain_;
    Vec3 to_sun_;
    std::vector<Shadow> cast_;
    std::vector<uint32_t> found_;
};

}  // namespace scenes::town
