#include "samples/scenes/odeon/theatre_building.h"

#include "samples/scenes/odeon/cavea.h"
#include "samples/scenes/odeon/frons.h"
#include "samples/scenes/stone.h"

namespace scenes
{

namespace
{

constexpr float far_m = 24;  // where a seat's chamfers and the grain of its stone are one pixel
constexpr Rgb plain_paving = {0.86f, 0.82f, 0.74f};

}  // namespace

TheatreBuilding::TheatreBuilding(const Scenario &scenario, uint64_t seed)
    : seed_(seed),
      theatre_(*scenario.theatre),
      light_(scenario.light.value_or(Daylight())),
      sky_(seed, Sky::Land::hills),
      orchestra_(theatre_, seed)
{
    Parts stone(plaster_metres);
    build_cavea(stone, theatre_, seed);
    stone_ = Blocks(stone, 4, {far_m, light_, plaster_mean});
    Geometry stage(plaster_metres), ground;
    build_stage(stage, theatre_);
    stage_ = Blocks(stage, 4);
    const double reach = theatre_.rows.back().radius_m + theatre_.rows.back().depth_m;
    orchestra_.surround(ground, reach + 8, scenario.paving.value_or(plain_paving));
    ground_ = Blocks(ground, 10);
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
    flagstones_.emplace(gl, flagstones(seed_), true, Texture::Filter::bilinear);
    plaster_.emplace(gl, plaster(seed_), true, Texture::Filter::bilinear);
    orchestra_.prepare(gl);
}

void TheatreBuilding::draw(const Gl &g, const Eye &eye, const Frustum *cull) const
{
    g.Enable(gl::cull_face);
    plaster_->use();
    stage_.draw(g, eye, cull);
    stone_.draw(g, eye, cull);
    orchestra_.draw(g);
    flagstones_->use();
    ground_.draw(g, eye, cull);
    sky_.draw(g, eye);
}

}  // namespace scenes
