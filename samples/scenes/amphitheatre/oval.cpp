#include "samples/scenes/amphitheatre/oval.h"

#include <cmath>

#include "samples/scenes/angles.h"

namespace scenes::amphitheatre
{
namespace
{

constexpr double quarter = two_pi / 4;

// A turn as a number of quarters that are left out, and the rest mirrored into the first quarter.
struct Folded {
    double rest;
    bool left, back;
};

// The angle of a vector in the first quarter, from additions, products and roots alone: the arc tangents of processors
// differ in their last bits.
double angle_of(double along, double across)
{
    const bool steep = across > along;
    double t = steep ? along / across : across / along;
    double scale = 1;
    for (int i = 0; i < 3; ++i, scale *= 2) t = t / (1 + std::sqrt(1 + t * t));
    double sum = 0;
    for (int k = 15; k >= 1; k -= 2) sum = 1.0 / k - t * t * sum;
    const double angle = scale * t * sum;
    return steep ? quarter - angle : angle;
}

Folded fold(double turn)
{
    double t = turn - two_pi * std::floor(turn / two_pi);
    const bool back = t > two_pi / 2;
    if (back) t = two_pi - t;
    const bool left = t > quarter;
    return {left ? two_pi / 2 - t : t, left, back};
}

}  // namespace

Oval::Oval(double half_long, double half_short)
{
    const double unit = (half_long - half_short) / 2;  // of the triangle: 3 + 4 - 5 of them are the difference
    end_centre_ = 3 * unit;
    side_centre_ = 4 * unit;
    end_radius_ = half_long - end_centre_;
    side_radius_ = half_short + side_centre_;
    corner_ = 0.9272952180016123;  // the angle whose tangent is 4/3
}

Spot Oval::at(double turn, double out) const
{
    const Folded folded = fold(turn);
    const bool end = folded.rest <= corner_;
    const double c = std::cos(folded.rest), s = std::sin(folded.rest);
    const double r = (end ? end_radius_ : side_radius_) + out;
    Spot spot = {(end ? end_centre_ : 0) + r * c, (end ? 0 : -side_centre_) + r * s, c, s};
    if (folded.left) spot.x = -spot.x, spot.out_x = -spot.out_x;
    if (folded.back) spot.z = -spot.z, spot.out_z = -spot.out_z;
    return spot;
}

Bearing Oval::bearing(double x, double z) const
{
    const double px = std::abs(x), pz = std::abs(z);
    double along = px - end_centre_, across = pz, r = end_radius_;
    // The line from the side's centre through the end's centre divides the arcs.
    if (across * 3 > along * 4) along = px, across = pz + side_centre_, r = side_radius_;
    double turn = angle_of(along, across);
    if (x < 0) turn = two_pi / 2 - turn;
    if (z < 0) turn = two_pi - turn;
    return {turn, std::sqrt(along * along + across * across) - r};
}

double Oval::radius(double turn, double out) const
{
    return (fold(turn).rest <= corner_ ? end_radius_ : side_radius_) + out;
}

double Oval::perimeter(double out) const
{
    return 4 * (corner_ * (end_radius_ + out) + (quarter - corner_) * (side_radius_ + out));
}

double Oval::length(double turn, double out) const
{
    const double whole = std::floor(turn / two_pi), all = perimeter(out);
    const Folded folded = fold(turn);
    double inner = folded.rest <= corner_
                       ? folded.rest * (end_radius_ + out)
                       : corner_ * (end_radius_ + out) + (folded.rest - corner_) * (side_radius_ + out);
    if (folded.left) inner = all / 2 - inner;
    if (folded.back) inner = all - inner;
    return whole * all + inner;
}

double Oval::turn_at(double length, double out) const
{
    const double all = perimeter(out), whole = std::floor(length / all);
    double rest = length - whole * all;
    const bool back = rest > all / 2;
    if (back) rest = all - rest;
    const bool left = rest > all / 4;
    if (left) rest = all / 2 - rest;
    const double end = corner_ * (end_radius_ + out);
    double turn = rest <= end ? rest / (end_radius_ + out) : corner_ + (rest - end) / (side_radius_ + out);
    if (left) turn = two_pi / 2 - turn;
    if (back) turn = two_pi - turn;
    return whole * two_pi + turn;
}

}  // namespace scenes::amphitheatre
