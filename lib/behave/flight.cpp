// Flights: the transform on a closed Catmull-Rom curve, banked into turns (S0 7.1).
#include <cmath>

#include "lib/behave/path.h"
#include "lib/math/trig.h"

namespace claque::behave
{

namespace
{

// One segment as a Bezier curve.
struct BezierSegment {
    glm::dvec3 c[4];
};

BezierSegment bezier_segment_of(const crowd::RootPath &path, uint32_t segment)
{
    const uint32_t n = static_cast<uint32_t>(path.positions.size());
    const uint32_t next = segment + 1 < n ? segment + 1 : 0;
    const glm::dvec3 a(path.positions[segment]), b(path.positions[next]);
    const glm::dvec3 before(path.positions[segment > 0 ? segment - 1 : n - 1]);
    const glm::dvec3 after(path.positions[next + 1 < n ? next + 1 : 0]);
    return {{a, a + (b - before) * (1.0 / 6), b - (after - a) * (1.0 / 6), b}};
}

glm::dvec3 point(const BezierSegment &p, double u)
{
    const double v = 1 - u;
    return p.c[0] * (v * v * v) + p.c[1] * (3 * v * v * u) + p.c[2] * (3 * v * u * u) + p.c[3] * (u * u * u);
}

glm::dvec3 velocity(const BezierSegment &p, double u)
{
    const double v = 1 - u;
    return (p.c[1] - p.c[0]) * (v * v) + (p.c[2] - p.c[1]) * (2 * v * u) + (p.c[3] - p.c[2]) * (u * u);
}

// The direction in which a curve continues, also where its derivative is 0.
glm::dvec3 onward(const BezierSegment &p, double u)
{
    return (p.c[2] - p.c[1] * 2.0 + p.c[0]) * (1 - u) + (p.c[3] - p.c[2] * 2.0 + p.c[1]) * u;
}

struct Where {
    uint32_t segment;
    double u;
};

// `at` in segments, at most one loop before the start or after the end.
Where where(double at, uint32_t count)
{
    if (at < 0) at += count;
    if (at >= count) at -= count;
    const uint32_t segment = static_cast<uint32_t>(at) < count ? static_cast<uint32_t>(at) : count - 1;
    return {segment, at - segment};
}

glm::dvec3 velocity_at(const crowd::RootPath &path, double at)
{
    const Where w = where(at, static_cast<uint32_t>(path.positions.size()));
    return velocity(bezier_segment_of(path, w.segment), w.u);
}

// [radians] The turn to the left from one direction to another, seen from above: the first terms of the series of the
// angle over its sine, accurate to a hundredth up to 60 degrees. It tends to 0 at 180 degrees, where the side is
// undefined.
double turned(const glm::dvec3 &from, const glm::dvec3 &to)
{
    const double square = (from.x * from.x + from.z * from.z) * (to.x * to.x + to.z * to.z);
    if (!(square > 0)) return 0;
    const double scale = 1 / std::sqrt(square);
    const double sine = (from.z * to.x - from.x * to.z) * scale;
    const double less = 1 - (from.x * to.x + from.z * to.z) * scale;
    return sine * (1 + less * (1.0 / 3 + less * (2.0 / 15)));
}

// sin and cos of half an angle in (-pi, pi], from those of the angle.
struct Half {
    double sin = 0, cos = 1;
};
Half half(double sine, double cosine)
{
    const double c = std::sqrt(std::fmax(0.0, (1 + cosine) / 2));
    if (c > 0.1) return {sine / (2 * c), c};
    const double s = std::sqrt(std::fmax(0.0, (1 - cosine) / 2));
    return {sine < 0 ? -s : s, c};
}

// Yaw about y, then pitch about x, then roll about z; roll is positive to the left.
glm::quat heading(const glm::dvec3 &along, double roll)
{
    const double level = std::sqrt(along.x * along.x + along.z * along.z);
    const double length = std::sqrt(level * level + along.y * along.y);
    if (!(length > 0)) return glm::quat(1, 0, 0, 0);
    const Half yaw = level > 0 ? half(along.x / level, along.z / level) : Half();
    const Half pitch = half(along.y / length, level / length);
    const double rs = -math::sin(roll / 2), rc = math::cos(roll / 2), ps = -pitch.sin, pc = pitch.cos;
    const double ys = yaw.sin, yc = yaw.cos;
    return glm::quat(static_cast<float>(yc * pc * rc + ys * ps * rs), static_cast<float>(yc * ps * rc + ys * pc * rs),
                     static_cast<float>(ys * pc * rc - yc * ps * rs), static_cast<float>(yc * pc * rs - ys * ps * rc));
}

double length_of(const glm::dvec3 &v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

// After repeated halving the control points are close to the curve.
double corners(const BezierSegment &p, int halvings)
{
    if (halvings == 0)
        return std::fmax(std::fmax(length_of(p.c[0]), length_of(p.c[1])),
                         std::fmax(length_of(p.c[2]), length_of(p.c[3])));
    const glm::dvec3 ab = (p.c[0] + p.c[1]) * 0.5, bc = (p.c[1] + p.c[2]) * 0.5, cd = (p.c[2] + p.c[3]) * 0.5;
    const glm::dvec3 abc = (ab + bc) * 0.5, bcd = (bc + cd) * 0.5, middle = (abc + bcd) * 0.5;
    return std::fmax(corners({{p.c[0], ab, abc, middle}}, halvings - 1),
                     corners({{middle, bcd, cd, p.c[3]}}, halvings - 1));
}

}  // namespace

crowd::Transform flight_transform(const crowd::RootPath &path, double round_s) noexcept
{
    const uint32_t count = static_cast<uint32_t>(path.positions.size());
    const double each_s = static_cast<double>(path.duration_s) / count, at = round_s / each_s;
    const Where w = where(at, count);
    const BezierSegment piece = bezier_segment_of(path, w.segment);
    glm::dvec3 along = velocity(piece, w.u);
    if (length_of(along) < 1e-9 * length_of(onward(piece, w.u))) along = onward(piece, w.u);
    // The turn over the length of a segment, because the curvature jumps where segments meet.
    double roll = 0;
    if (path.bank != 0) {
        const double rate = turned(velocity_at(path, at - 0.5), velocity_at(path, at + 0.5)) / each_s;
        const double maximum = static_cast<double>(path.max_bank);
        roll = std::fmin(std::fmax(static_cast<double>(path.bank) * rate, -maximum), maximum);
    }
    crowd::Transform transform;
    transform.position = point(piece, w.u);
    transform.orientation = heading(along, roll);
    return transform;
}

RootSpeed flight_speed(const crowd::RootPath &path, double round_s) noexcept
{
    const uint32_t count = static_cast<uint32_t>(path.positions.size());
    const double each_s = static_cast<double>(path.duration_s) / count, at = round_s / each_s;
    const double turn = turned(velocity_at(path, at - 0.5), velocity_at(path, at + 0.5));
    // Bezier's velocity lacks the factor 3 of a cubic curve.
    return {3 * length_of(velocity_at(path, at)) / each_s, std::fabs(turn) / each_s};
}

double flight_reach(const crowd::RootPath &path)
{
    double reach = 0;
    for (uint32_t i = 0; i < path.positions.size(); ++i)
        reach = std::fmax(reach, corners(bezier_segment_of(path, i), 4));
    return reach;
}

}  // namespace claque::behave
