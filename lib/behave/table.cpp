// Root paths from a key-framing table (S0 4.1).
#include <algorithm>

#include "lib/behave/path.h"
#include "lib/math/slerp.h"

namespace claque::behave
{

crowd::Transform table_transform(const crowd::RootPath &path, double round_s) noexcept
{
    const auto after = std::upper_bound(path.times_s.begin(), path.times_s.end(), round_s,
                                        [](double t, float key) { return t < static_cast<double>(key); });
    size_t i = static_cast<size_t>(after - path.times_s.begin());
    i = std::min(std::max<size_t>(i, 1), path.times_s.size() - 1) - 1;
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

}  // namespace claque::behave
