// An open motor omnibus: rows of benches on a wooden body, spoked wheels that turn. Its own space: metres, y up,
// forward +z, the origin on the ground between the axles.
#pragma once

#include <array>
#include <vector>

#include "samples/scenes/geometry.h"
#include "samples/scenes/town/pieces.h"
#include "samples/scenes/town/route.h"

namespace scenes::town
{

class Omnibus
{
public:
    // Position of a sitter's feet; all face forward. The first seat is the driver's.
    struct Seat {
        float x, y, z;
    };
    static const std::vector<Seat> &seats();

    static constexpr double wheelbase_m = 4.3, half_track_m = 1.06, wheel_radius_m = 0.47;
    static constexpr double floor_m = 0.64, half_width_m = 1.18, front_m = 3.2, rear_m = -3.75;

    explicit Omnibus(Rgb paint);

    const Geometry &body() const { return body_; }
    const Geometry &wheel() const { return wheel_; }  // round its axle, which is x
    // The transform of a wheel in the world, column-major. end: 1 the front axle, -1 the rear one; side: 1 towards +x,
    // -1.
    static std::array<float, 16> wheel_matrix(const VehiclePose &pose, double end, double side);
    // Bounds the body, the wheels and the people in it; in its own space.
    const Sphere &sphere() const { return sphere_; }

    // Draws it at this pose; the model-view matrix is the eye's view before and after.
    void draw(const Gl &gl, const Eye &eye, const VehiclePose &pose) const;
    // Its shadow on the ground and the dark under it, for Shadows::draw.
    static void shade(Geometry &shadows, const VehiclePose &pose, Vec3 to_sun);

private:
    void build_body(Rgb paint);
    void build_wheels();
    static void load(const Gl &gl, const Eye &eye, const std::array<float, 16> &model);

    Geometry body_ = Geometry(4.0f), wheel_ = Geometry(4.0f), far_wheel_ = Geometry(4.0f);
    Sphere sphere_ = {};
};

}  // namespace scenes::town
