// A picture of the light on level ground, painted once: the shadows of many standing people for the price of one
// texture.
#pragma once

#include "samples/scenes/shadows.h"

namespace scenes
{

// Covers the square from `low` to `high` metres in x and in z.
class LightMap
{
public:
    LightMap(float low, float high);

    // Paints the people's quads, each as if blended over medium grey ground.
    void paint(const Shadows &shadows);

    float coordinate(float metres) const { return (metres - low_) / (high_ - low_); }
    const Image &image() const { return image_; }

private:
    void darken(const SceneryVertex *quad, const Image &picture);

    float low_, high_;
    Image image_;
};

}  // namespace scenes
