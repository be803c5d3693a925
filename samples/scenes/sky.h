// What is far away: a sky that pales towards the horizon, and hills.
#pragma once

#include "samples/scenes/eye.h"
#include "samples/scenes/geometry.h"

namespace scenes
{

class Sky
{
public:
    enum class Land { hills, plain };
    Sky(uint64_t seed, Land land);

    // First of all in a frame: covers the whole picture, writes no depth.
    void draw(const Gl &gl, const Eye &eye) const;

private:
    Geometry dome_;
};

}  // namespace scenes
