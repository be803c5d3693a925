#include "samples/scenes/circuit.h"

#include <cmath>

namespace scenes
{
namespace
{

constexpr double quarter_turn = 1.5707963267948966;

}

Circuit::Circuit(double half_x, double half_z, double corner)
    : half_x_(half_x),
      half_z_(half_z),
      corner_(corner),
      length_(4 * (half_x - corner) + 4 * (half_z - corner) + 4 * quarter_turn * corner)
{
}

Step Circuit::at(double metres) const
{
    double left = std::fmod(metres, length_);
    if (left < 0) left += length_;
    const double bend = quarter_turn * corner_;

    // Side k runs along its own direction from the centre of one straight to the centre of the next, round one corner.
    // distance of the straight from the centre, and half its length between corners
    double out = half_z_, along = half_x_;
    double nx = 0, nz = 1, tx = 1, tz = 0;  // outwards, and along
    for (;;) {
        const double straight = along - corner_, next = out - corner_;
        if (left <= straight) return {nx * out + tx * left, nz * out + tz * left, tx, tz};
        left -= straight;
        if (left <= bend) {
            const double turn = left / corner_, s = std::sin(turn), c = std::cos(turn);
            const double cx = nx * next + tx * straight, cz = nz * next + tz * straight;
            return {cx + corner_ * (nx * c + tx * s), cz + corner_ * (nz * c + tz * s), tx * c - nx * s,
                    tz * c - nz * s};
        }
        left -= bend;
        const double old_nx = nx, old_nz = nz;  // turn left: the old direction is now outwards
        nx = tx, nz = tz;
        tx = -old_nx, tz = -old_nz;
        if (left <= next) return {nx * along + tx * (left - next), nz * along + tz * (left - next), tx, tz};
        left -= next;
        const double old_out = out;
        out = along, along = old_out;
    }
}

}  // namespace scenes
