#include "samples/scenes/odeon/theatre_building.h"

#include "samples/scenes/odeon/cavea.h"
#include "samples/scenes/odeon/frons.h"
#include "samples/scenes/stone.h"

namespace scenes
{

namespace
{

constexpr Rgb plain_paving = {0.86f, 0.82f, 0.74f};

}  // namespace

TheatreBuilding::TheatreBuilding(const Scenario &scenario, uint64_t seed)
    : seed_(seed),
      theatre_(*scenario.theatre),
      light_(scenario.light.value_or(Daylight())),
      sky_(seed, Sky::Land::hills),
      orchestra_(theatre_, seed),
      ground_(flagstone_metres),
      stone_(plaster_metres)
{
    build_cavea(stone_, theatre_, seed);
    build_stage(stone_, theatre_);
    const float reach = static_cast<float>(theatre_.rows.back().radius_m + theatre_.rows.back().depth_m);
    ground_.disc(0, 0, 0, reach + 8, 96, scenario.paving.value_or(plain_paving));
}

clq_camera TheatreBuilding::overview(double aspect) const
{
    const SeatRow &last = theatre_.rows.back();
    const double back = theatre_.stage.front_z_m + theatre_.stage.depth_m;
    return look({-2.4, last.seat_y_m + 3.4, back - 0.8}, {0.3, last.seat_y_m * 0.465, last.radius_m * -0.41}, 62,
                aspect, 1.5, 900);
}

void TheatreBuilding::prepare(const Gl &gl)
{
    flagstones_.emplace(gl, flagstones(seed_), true);
    plaster_.emplace(gl, plaster(seed_), true);
    orchestra_.prepare(gl);
}

void TheatreBuilding::draw(const Gl &g, const Eye &eye) const
{
    sky_.draw(g, eye);
    set_lights(g, light_, eye);
    g.Enable(gl::cull_face);
    flagstones_->use();
    ground_.draw(g);
    orchestra_.draw(g);
    plaster_->use();
    stone_.draw(g);
}

}  // namespace scenes
