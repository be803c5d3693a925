// A picture of how light level ground is, painted once: shadows of many who stand still, for what a texture takes to draw.
#pragma once

#include "samples/scenes/shadows.h"

namespace scenes
{

// Of the square from `low` to `high` metres in x and in z.
class LightMap
{
public:
    LightMap(float low, float high);

    // What the people's quads cover, each as if blended over ground of middling grey.
    void paint(const Shadows &shadows);

    float coordinate(float metres) const { return (metres - low_) / (high_ - low_); }
    const Image &image() const { return image_; }

private:
    void darken(const SceneryVertex *quad, const Image &picture);

    float low_, high_;
    Image image_;
};

}  // namespace scenes
