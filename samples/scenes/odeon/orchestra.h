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
    // At y = 0, where the ground round it leaves room.
    void draw(const Gl &gl) const;
    // The ground round it, out to a distance from the axis: it begins with the floor's own corners, so that there is
    // neither a crack nor a tie in depth.
    void surround(Geometry &ground, double reach_m, Rgb colour) const;

    const Geometry &floor() const { return floor_; }

private:
    uint64_t seed_;
    double reach_m_;
    int panels_;
    Geometry floor_;
    std::optional<Texture> image_;
};

}  // namespace scenes
