#include "samples/scenes/town/route.h"

#include <cmath>

namespace scenes::town
{
namespace
{

constexpr double pi = 3.141592653589793;
constexpr double step_m = 0.25;

// Corners of the circuit, in the plan: crossings of streets (of u, of v), traversed with the west on the right.
constexpr size_t crossings[][2] = {{0, 0}, {0, 3}, {1, 3}, {1, 2}, {2, 2}, {2, 1}, {3, 1}, {3, 0}};
constexpr size_t corners = sizeof crossings / sizeof *crossings;

struct Way {
    double u, v;
};
Way operator+(Way a, Way b) { return {a.u + b.u, a.v + b.v}; }
Way operator-(Way a, Way b) { return {a.u - b.u, a.v - b.v}; }
Way operator*(Way a, double k) { return {a.u * k, a.v * k}; }
Way unit_axis(Way a) { return a * (1 / std::sqrt(a.u * a.u + a.v * a.v)); }

// The line of the circuit in the plan: straight lines and quarter turns, in steps of at most `step_m`.
std::vector<Way> drawn(const Plan &plan)
{
    std::vector<Way> corner;
    for (const auto &c : crossings) corner.push_back({plan.streets_u()[c[0]], plan.streets_v()[c[1]]});
    const auto right = [](Way w) { return Way{-w.v, w.u}; };  // of the direction of travel: u is east, v south
    std::vector<Way> line;
    for (size_t i = 0; i < corners; ++i) {
        const Way in = unit_axis(corner[i] - corner[(i + corners - 1) % corners]);
        const Way out = unit_axis(corner[(i + 1) % corners] - corner[i]);
        const Way lane = corner[i] + (right(in) + right(out)) * VehiclePath::lane_m;
        const bool to_right = in.u * out.v - in.v * out.u > 0;
        const double radius = to_right ? 5.2 : 8.0;
        const Way middle = lane + (out - in) * radius;
        const int steps = static_cast<int>(radius * pi / 2 / step_m) + 1;
        for (int k = 0; k <= steps; ++k) {
            const double turn = pi / 2 * k / steps;
            // From the end of the incoming line to the start of the outgoing line, round `middle`.
            const Way from = out * -radius, to = in * radius;
            line.push_back(middle + from * std::cos(turn) + to * std::sin(turn));
        }
        const Way next_in = out;
        const Way after = unit_axis(corner[(i + 2) % corners] - corner[(i + 1) % corners]);
        const Way next = corner[(i + 1) % corners] + (right(next_in) + right(after)) * VehiclePath::lane_m;
        const double next_radius = next_in.u * after.v - next_in.v * after.u > 0 ? 5.2 : 8.0;
        const Way last = line.back(), to = next - next_in * next_radius, way = to - last;
        const double length = std::sqrt(way.u * way.u + way.v * way.v);
        const int parts = static_cast<int>(length / step_m) + 1;
        for (int k = 1; k < parts; ++k) line.push_back(last + way * (static_cast<double>(k) / parts));
    }
    return line;
}

double distance(Point a, Point b) { return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.z - b.z) * (a.z - b.z)); }

using Axis = std::array<double, 3>;
Axis cross(const Axis &a, const Axis &b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Axis unit_axis(Axis a)
{
    const double k = 1 / std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    return {a[0] * k, a[1] * k, a[2] * k};
}

}  // namespace

VehiclePath::VehiclePath(const Plan &plan, const Terrain &terrain, double wheelbase_m, double half_track_m)
    : terrain_(terrain), wheelbase_(wheelbase_m), half_track_(half_track_m)
{
    std::vector<Point> bent;
    for (const Way &w : drawn(plan)) bent.push_back(plan.at(w.u, w.v));
    std::vector<double> ends = {0};  // distance of each along the land
    for (size_t i = 0; i < bent.size(); ++i)
        ends.push_back(ends.back() + distance(bent[i], bent[(i + 1) % bent.size()]));
    length_ = ends.back();
    const size_t steps = static_cast<size_t>(length_ / step_m);
    size_t piece = 0;
    for (size_t i = 0; i < steps; ++i) {
        const double at = length_ * static_cast<double>(i) / static_cast<double>(steps);
        while (ends[piece + 1] <= at) ++piece;
        const double t = (at - ends[piece]) / (ends[piece + 1] - ends[piece]);
        const Point &a = bent[piece], &b = bent[(piece + 1) % bent.size()];
        points_.push_back({a.x + t * (b.x - a.x), a.z + t * (b.z - a.z)});
    }
}

Point VehiclePath::point(double metres) const
{
    double along = std::fmod(metres, length_) / length_;
    if (along < 0) along += 1;
    const double at = along * static_cast<double>(points_.size());
    const size_t first = static_cast<size_t>(at) % points_.size();
    const double t = at - std::floor(at);
    const Point &a = points_[first], &b = points_[(first + 1) % points_.size()];
    return {a.x + t * (b.x - a.x), a.z + t * (b.z - a.z)};
}

double VehiclePath::nearest(Point p) const
{
    size_t best = 0;
    for (size_t i = 1; i < points_.size(); ++i)
        if (distance(points_[i], p) < distance(points_[best], p)) best = i;
    return length_ * static_cast<double>(best) / static_cast<double>(points_.size());
}

VehiclePose VehiclePath::at(double metres) const
{
    const Point rear = point(metres - wheelbase_ / 2), front = point(metres + wheelbase_ / 2);
    const double dx = front.x - rear.x, dz = front.z - rear.z, apart = std::sqrt(dx * dx + dz * dz);
    const double fx = dx / apart, fz = dz / apart;  // forward; +x of the vehicle is to its left: (fz, -fx)
    const auto under = [&](double ahead, double aside) {
        const double x = (front.x + rear.x) / 2 + fx * ahead + fz * aside;
        const double z = (front.z + rear.z) / 2 + fz * ahead - fx * aside;
        return terrain_.height(x, z);
    };
    const double w = wheelbase_ / 2, h = half_track_;
    const double fl = under(w, h), fr = under(w, -h), rl = under(-w, h), rr = under(-w, -h);
    VehiclePose s = {};
    s.position[0] = (front.x + rear.x) / 2;
    s.position[1] = (fl + fr + rl + rr) / 4;
    s.position[2] = (front.z + rear.z) / 2;
    s.forward = unit_axis({fx * 2 * w, (fl + fr - rl - rr) / 2, fz * 2 * w});
    const Axis left = {fz * 2 * h, (fl + rl - fr - rr) / 2, -fx * 2 * h};
    s.up = unit_axis(cross(s.forward, left));
    s.right_hand_x = cross(s.up, s.forward);
    // Its front wheels are steered along the route.
    const Point before = point(metres + wheelbase_ / 2 - 0.6), after = point(metres + wheelbase_ / 2 + 0.6);
    const double wx = after.x - before.x, wz = after.z - before.z, wide = std::sqrt(wx * wx + wz * wz);
    s.steer_sin = (wx * fz - wz * fx) / wide;
    s.steer_cos = (wx * fx + wz * fz) / wide;
    s.rolled_m = metres;
    return s;
}

std::array<float, 4> VehiclePose::orientation_xyzw() const
{
    const Axis &a = right_hand_x, &b = up, &c = forward;  // columns of the rotation
    double q[4];
    const double trace = a[0] + b[1] + c[2];
    if (trace > 0) {
        const double k = std::sqrt(trace + 1) * 2;
        q[0] = (b[2] - c[1]) / k, q[1] = (c[0] - a[2]) / k, q[2] = (a[1] - b[0]) / k, q[3] = k / 4;
    } else if (b[1] > a[0] && b[1] > c[2]) {
        const double k = std::sqrt(1 + b[1] - a[0] - c[2]) * 2;
        q[0] = (b[0] + a[1]) / k, q[1] = k / 4, q[2] = (c[1] + b[2]) / k, q[3] = (c[0] - a[2]) / k;
    } else if (a[0] > c[2]) {
        const double k = std::sqrt(1 + a[0] - b[1] - c[2]) * 2;
        q[0] = k / 4, q[1] = (b[0] + a[1]) / k, q[2] = (c[0] + a[2]) / k, q[3] = (b[2] - c[1]) / k;
    } else {
        const double k = std::sqrt(1 + c[2] - a[0] - b[1]) * 2;
        q[0] = (c[0] + a[2]) / k, q[1] = (c[1] + b[2]) / k, q[2] = k / 4, q[3] = (a[1] - b[0]) / k;
    }
    return {static_cast<float>(q[0]), static_cast<float>(q[1]), static_cast<float>(q[2]), static_cast<float>(q[3])};
}

std::array<float, 16> VehiclePose::matrix() const
{
    std::array<float, 16> m = {};
    for (size_t i = 0; i < 3; ++i) {
        m[i] = static_cast<float>(right_hand_x[i]);
        m[4 + i] = static_cast<float>(up[i]);
        m[8 + i] = static_cast<float>(forward[i]);
        m[12 + i] = static_cast<float>(position[i]);
    }
    m[15] = 1;
    return m;
}

}  // namespace scenes::town
