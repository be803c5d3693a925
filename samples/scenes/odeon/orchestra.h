// The orchestra's floor: a disc of coloured marbles, darker at its rim beside the podium.
#pragma once

#include <optional>

#include "samples/scenes/geometry.h"
#include "samples/scenes/odeon/theatre.h"
#include "samples/scenes/texture.h"

namespace scenes
{

class Orchestra
{
public:
    Orchestra(const Theatre &theatre, uint64_t seed);

    void prepare(const Gl &gl);
    // Draw this at y = 0 right after the ground and before everything on it. It lies in the ground's plane and neither
    // tests nor writes depth, so it covers the ground whatever the depth buffer resolves.
    void draw(const Gl &gl) const;

    const Geometry &floor() const { return floor_; }

private:
    uint64_t seed_;
    int panels_;
    Geometry floor_;
    std::optional<Texture> image_;
};

}  // namespace scenes
