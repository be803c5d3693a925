// Root paths from a key-framing table (S0 4.1).
#include <algorithm>
#include <cmath>

#include "lib/behave/path.h"
#include "lib/math/slerp.h"
#include "lib/math/trig.h"

namespace claque::behave
{

namespace
{

// The key from which a time goes on to the next one.
size_t key_before(const crowd::RootPath &path, double round_s)
{
    const auto after = std::upper_bound(path.times_s.begin(), path.times_s.end(), round_s,
                                        [](double t, float key) { return t < static_cast<double>(key); });
    const size_t i = static_cast<size_t>(after - path.times_s.begin());
    return std::min(std::max<size_t>(i, 1), path.times_s.size() - 1) - 1;
}

}  // namespace

crowd::Transform table_transform(const crowd::RootPath &path, double round_s) noexcept
{
    const size_t i = key_before(path, round_s);
    const double begin = static_cast<double>(path.times_s[i]), end = static_cast<double>(path.times_s[i + 1]);
    const double share = std::min(std::max((round_s - begin) / (end - begin), 0.0), 1.0);
    const glm::dvec3 a(path.positions[i]), b(path.positions[i + 1]);
    const glm::quat &p = path.rotations[i], &q = path.rotations[i + 1];
    const float from[4] = {p.x, p.y, p.z, p.w}, to[4] = {q.x, q.y, q.z, q.w};
    crowd::Transform transform;
    transform.position = a + (b - a) * share;
    transform.orientation = math::slerp(from, to, share);
    return transform;
}

RootSpeed table_speed(const crowd::RootPath &path, double round_s) noexcept
{
    const size_t i = key_before(path, round_s);
    const double length_s = static_cast<double>(path.times_s[i + 1]) - static_cast<double>(path.times_s[i]);
    const glm::dvec3 way = glm::dvec3(path.positions[i + 1]) - glm::dvec3(path.positions[i]);
    const glm::quat &p = path.rotations[i], &q = path.rotations[i + 1];
    // Of the two rotations that a quaternion and its negative write, the shorter arc is shown.
    const double sum = std::fabs(double(p.x) * double(q.x) + double(p.y) * double(q.y) + double(p.z) * double(q.z) +
                                 double(p.w) * double(q.w));
    const double angle = 2 * math::acos(sum);
    return {std::sqrt(way.x * way.x + way.y * way.y + way.z * way.z) / length_s, angle / length_s};
}

}  // namespace claque::behave
