// The route of the town's omnibuses: a closed circuit along its streets, on the right-hand side, round its corners.
#pragma once

#include <array>

#include "samples/scenes/town/terrain.h"

namespace scenes::town
{

// A vehicle on the ground: its position and its own axes. Its own space has y up and drives along +z.
struct VehiclePose {
    double position[3];
    std::array<double, 3> right_hand_x, up, forward;  // of unit length and orthogonal
    double steer_sin, steer_cos;                      // of its front wheels, about `up`, from forward towards +x
    double rolled_m;                                  // distance driven

    std::array<float, 4> orientation_xyzw() const;
    std::array<float, 16> matrix() const;  // column-major
};

class VehiclePath
{
public:
    VehiclePath(const Plan &plan, const Terrain &terrain, double wheelbase_m, double half_track_m);

    double length_m() const { return length_; }
    // The pose at `metres` along it, any number: all four wheels are on the ground as closely as four can be.
    VehiclePose at(double metres) const;
    VehiclePose place_at(double time_s, double metres_a_second, double start_m) const
    {
        return at(start_m + time_s * metres_a_second);
    }
    Point point(double metres) const;
    // The distance along it of the point nearest to p.
    double nearest(Point p) const;

    static constexpr double lane_m = 1.45;  // from the centre of the street

private:
    const Terrain &terrain_;
    double wheelbase_, half_track_, length_ = 0;
    std::vector<Point> points_;  // in equal steps, closed
};

}  // namespace scenes::town
