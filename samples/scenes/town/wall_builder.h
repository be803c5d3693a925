// Walls, boxes and spires in the axes of a site, following the ground.
#pragma once

#include <functional>

#include "samples/scenes/town/pieces.h"
#include "samples/scenes/town/site.h"
#include "samples/scenes/town/sun_shadows.h"
#include "samples/scenes/town/terrain.h"

namespace scenes::town
{

class WallBuilder
{
public:
    WallBuilder(Pieces &pieces, const Terrain &terrain, const Site &site)
        : pieces_(pieces), terrain_(terrain), site_(site)
    {
    }

    static Vec3 point(double along, double y, double out)
    {
        return {static_cast<float>(along), static_cast<float>(y), static_cast<float>(out)};
    }
    double ground(double along, double out) const;

    struct Room {
        double a0, a1, o0, o1;
    };
    // The ground at its highest corner.
    double floor(const Room &room) const;

    // Four walls from the ground up: a plinth, then storeys. The callback (side, storey, bay, of) selects each bay's
    // picture.
    using Choice = std::function<Bay(int side, int storey, int bay, int bays)>;
    void walls(const Room &room, double floor_y, const std::vector<double> &storeys_m, Rgb colour,
               const Choice &choose);
    void box(double a0, double y0, double o0, double a1, double y1, double o1, Rgb colour);
    // A steep roof of four sides over a square tower, bent outwards at the eaves.
    void spire(double along, double out, double half, double low, double high, Rgb colour);

private:
    Pieces &pieces_;
    const Terrain &terrain_;
    Site site_;
};

// The shadow of a room's walls, and of a peak over its centre if that is higher.
void throw_box(SunShadows &shadows, const Site &site, const WallBuilder::Room &room, double low, double high,
               double peak);

}  // namespace scenes::town
