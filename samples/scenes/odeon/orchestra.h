// The orchestra's floor: a disc of coloured marbles, darker at its rim where the podium stands.
#pragma once

#include "samples/scenes/geometry.h"
#include "samples/scenes/odeon/theatre.h"
#include "samples/scenes/texture.h"

#include <optional>

namespace scenes
{

class Orchestra
{
public:
    Orchestra(const Theatre &theatre, uint64_t seed);

    void prepare(const Gl &gl);
    // On the ground at y = 0, right after the ground and before all that stands on it: it lies in the ground's plane and
    // covers it whatever the depth buffer resolves, for it neither tests nor writes depth.
    void draw(const Gl &gl) const;

    const Geometry &floor() const { return floor_; }

private:
    uint64_t seed_;
    int panels_;
    Geometry floor_;
    std::optional<Texture> image_;
};

}  // namespace scenes
