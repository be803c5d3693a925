// The sky over the town: blue that pales towards the horizon, and fair-weather clouds.
#pragma once

#include <memory>

#include "samples/scenes/eye.h"
#include "samples/scenes/geometry.h"
#include "samples/scenes/texture.h"

namespace scenes::town
{

class Clouds
{
public:
    static constexpr Rgb haze = {0.74f, 0.82f, 0.88f};  // at the horizon, and the colour into which distance fades

    explicit Clouds(uint64_t seed);
    void prepare(const Gl &gl);
    // For other renderers, round the eye: the sky itself, and a layer over it that shows picture(), blended.
    const Geometry &dome() const { return dome_; }
    const Geometry &layer() const { return layer_; }
    Image picture() const;
    // Draw this after all that is opaque: it fills what is still empty of a cleared picture. Leaves the view set,
    // lighting on and fog off.
    void draw(const Gl &gl, const Eye &eye) const;

private:
    uint64_t seed_;
    Geometry dome_, layer_;
    std::unique_ptr<Texture> picture_;
};

}  // namespace scenes::town
