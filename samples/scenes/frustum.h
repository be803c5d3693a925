// The pyramid that a camera sees, to leave out scenery that lies outside it.
#pragma once

#include <array>

#include "samples/scenes/eye.h"
#include "samples/scenes/geometry.h"

namespace scenes
{

struct Sphere {
    Vec3 centre;
    float radius;
};

// Six planes that face inwards.
class Frustum
{
public:
    // The frustum of the eye's picture; scale < 1: of a centred part of it, smaller by this factor each way.
    explicit Frustum(const Eye &eye, float scale = 1);
    // True if any of it may lie inside.
    bool meets(const Sphere &sphere) const;

private:
    std::array<std::array<float, 4>, 6> planes_;  // normal of length 1, and the distance of the origin
};

}  // namespace scenes
