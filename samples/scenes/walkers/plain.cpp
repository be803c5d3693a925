#include "samples/scenes/walkers/plain.h"

#include <algorithm>

#include "samples/scenes/stone.h"

namespace scenes::walkers
{

Plain::Plain(uint64_t seed, const Daylight &light)
    : seed_(seed), light_(light), sky_(seed, Sky::Land::hills), ground_(flagstone_metres)
{
}

void Plain::prepare(const Gl &gl)
{
    flagstones_.emplace(gl, flagstones(seed_), true);
    plaster_.emplace(gl, plaster(seed_), true);
}

void Plain::draw(const Gl &g, const Eye &eye) const
{
    g.Enable(gl::cull_face);
    plaster_->use();
    ground_.walls.draw(g);
    g.Disable(gl::cull_face);
    flagstones_->use();
    ground_.paving.draw(g);
    g.Disable(gl::texture_2d);
    ground_.around.draw(g);
    sky_.draw(g, eye);
}

double far_of(const Plan &plan) { return 400 + 6 * std::max(plan.half_x, plan.half_z); }

clq_camera overview_of(const Plan &plan, double aspect)
{
    const double reach = std::max(plan.half_x / aspect * 1.25, plan.half_z * 0.9) + 1.5;
    const double x = plan.middle_x, y = plan.ground, z = plan.middle_z;
    return look({x, y + 1.15 * reach, z + (plan.half_z * 0.35 + 1.9 * reach)}, {x, y + 0.4, z + plan.half_z * 0.12}, 40,
                aspect, 0.5, far_of(plan));
}

}  // namespace scenes::walkers
