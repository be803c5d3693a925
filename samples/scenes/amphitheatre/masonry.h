// Stone on the curves of the plan, with the light of its sun and sky in its colours. It is kept by sector, so that what
// lies outside the picture is not drawn.
#pragma once

#include <array>
#include <vector>

#include "samples/scenes/amphitheatre/exposure.h"
#include "samples/scenes/frustum.h"

namespace scenes::amphitheatre
{

// A corner of a profile in a plane through the normal. open: the share of the sky that it sees.
struct Corner {
    double out, y, open;
};
using Profile = std::vector<Corner>;

constexpr double stone_metres = 6;  // of one repeat of the texture

class Masonry
{
public:
    Masonry(const Plan &plan, const Exposure &exposure, uint64_t seed);

    // Sweeps a profile, which runs outwards and upwards like a walk to the last row, from one turn to another in steps
    // of at most step_m along its first corner. tone_spread: how much the tones of neighbouring stones differ.
    void sweep(const Profile &profile, double first, double last, double step_m, Rgb colour, double tone_spread = 0.05);
    // The same without the sun, for what lies under a roof.
    void sweep_shaded(const Profile &profile, double first, double last, double step_m, Rgb colour);
    // The face of a radial wall between two distances, from foot to two tops; side -1 faces falling turns.
    void cheek(double turn, double from, double to, double foot, double from_top, double to_top, int side, Rgb colour);
    // A block between two turns and two distances, without a bottom.
    void block(double turn, double half_m, double from, double to, double foot, double top, Rgb colour);
    // A quad with one normal, and the light of each corner. `sun` 0: in the shade whatever is above it.
    void quad(const std::array<Vec3, 4> &corners, Rgb colour, double open = 0.8, double sun = -1);
    // An upright shape of so many sides.
    void column(double turn, double out, double foot, double top, double radius, int sides, Rgb colour);
    // On a wall that faces the arena, a little before it: a panel, and an opening that no sun reaches.
    void panel(double turn, double half_m, double out, double foot, double top, Rgb colour, double sun = -1);
    void recess(double turn, double half_m, double out, double foot, double top, Rgb colour);

    Vec3 at(double turn, double out, double y) const;
    void draw(const Gl &gl, const Eye &eye) const;
    size_t triangles() const;

private:
    static constexpr size_t sector_count = 40;
    struct Sector {
        Geometry geometry;
        Sphere sphere = {{0, 0, 0}, -1};
    };
    void band(const Corner &a, const Corner &b, double first, double last, int steps, Rgb colour, double spread,
              double sun);
    void sweep_all(const Profile &profile, double first, double last, double step_m, Rgb colour, double spread,
                   double sun);
    Geometry &sector_of(double turn);
    static void bound(Sector &sector);

    const Plan &plan_;
    const Exposure &exposure_;
    uint64_t seed_, stones_ = 0;
    mutable std::array<Sector, sector_count> sectors_;
};

}  // namespace scenes::amphitheatre
