// The positions on the plaza: talkers in rings, listeners in arcs before the speaker, walkers in lanes. Metres; x to
// the right, z towards the overview camera, the centre of the plaza at the origin.
#pragma once

#include <cstdint>
#include <vector>

#include "samples/scenes/circuit.h"

namespace scenes
{

struct Standing {
    double x, y, z;
    double facing_x, facing_z;
    enum class Role : uint8_t { talker, listener, speaker } role;
};

struct Walking {
    uint32_t lane;
    double start;  // metres along the lane at time 0
};

struct Lane {
    Circuit way;
    double
        // metres a second; negative walks the other way round. All walkers of a lane have one speed, so they never
        // collide
        speed;
};

struct PlazaLayout {
    double half_x, half_z;  // of the paved square
    double fountain[2], fountain_radius;
    double rostra[2], rostra_half[2], rostra_height;  // the speaker's platform: centre, half sizes
    double close_eye[2], close_target[2];             // position and target of the close camera
    std::vector<Lane> lanes;
    std::vector<Standing> standing;
    std::vector<Walking> walking;
};

// The same for equal arguments. walk_speed: metres a second of the walk clip at speed 1.
PlazaLayout lay_out_plaza(uint32_t count, uint64_t seed, double walk_speed);

}  // namespace scenes
