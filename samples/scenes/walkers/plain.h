// A plain with paving and low walls on it, under a sky: what people on tracks walk on.
#pragma once

#include <optional>

#include "samples/scenes/light.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/texture.h"
#include "samples/scenes/walkers/ground.h"

namespace scenes::walkers
{

class Plain
{
public:
    Plain(uint64_t seed, const Daylight &light);

    Ground &ground() { return ground_; }  // for lay()
    const Daylight &light() const { return light_; }

    void prepare(const Gl &gl);
    void set_light(const Gl &gl, const Eye &eye) const { set_lights(gl, light_, eye); }
    void draw(const Gl &gl, const Eye &eye) const;  // in the light that is set

private:
    uint64_t seed_;
    Daylight light_;
    Sky sky_;
    Ground ground_;
    std::optional<Texture> flagstones_, plaster_;
};

// How far such a scene reaches from its cameras.
double far_of(const Plan &plan);
// From the south, so high that the people fill the picture.
clq_camera overview_of(const Plan &plan, double aspect);

}  // namespace scenes::walkers
