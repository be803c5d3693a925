// What is far away: a sky that pales towards the horizon, and hills; or a plain backdrop.
#pragma once

#include "samples/scenes/eye.h"
#include "samples/scenes/geometry.h"

namespace scenes
{

class Sky
{
public:
    enum class Land { hills, studio };
    static constexpr Rgb backdrop = {0.72f, 0.74f, 0.76f};  // of the studio, at the horizon
    Sky(uint64_t seed, Land land);

    // First of all in a frame: covers the whole picture, writes no depth.
    void draw(const Gl &gl, const Eye &eye) const;

private:
    void studio();

    Geometry dome_;
};

}  // namespace scenes
