// The building of a theatre and the ground round it, without people.
#pragma once

#include <optional>

#include "samples/scenes/blocks.h"
#include "samples/scenes/light.h"
#include "samples/scenes/odeon/orchestra.h"
#include "samples/scenes/scenario/scenario.h"
#include "samples/scenes/sky.h"

namespace scenes
{

class TheatreBuilding
{
public:
    // `scenario` has a theatre.
    TheatreBuilding(const Scenario &scenario, uint64_t seed);

    const Theatre &theatre() const { return theatre_; }
    const Daylight &light() const { return light_; }

    // From above the stage, before its wall: all of it.
    clq_camera overview(double aspect) const;
    void prepare(const Gl &gl);
    void set_light(const Gl &gl, const Eye &eye) const { set_lights(gl, light_, eye); }
    // What meets `cull` (null: all), and the sky, in the light that is set.
    void draw(const Gl &gl, const Eye &eye, const Frustum *cull) const;

private:
    uint64_t seed_;
    Theatre theatre_;
    Daylight light_;
    Sky sky_;
    Orchestra orchestra_;
    Blocks ground_, stone_, stage_;
    std::optional<Texture> flagstones_, plaster_;
};

}  // namespace scenes
