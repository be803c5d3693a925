#include "lib/behave/path.h"

#include <cmath>

namespace claque::behave
{

crowd::Place place_on(const crowd::RootPath &path, double round_s) noexcept
{
    return path.flight ? flown(path, round_s) : looked_up(path, round_s);
}

crowd::Place root_at(const crowd::Crowd &crowd, uint32_t row, double time_s) noexcept
{
    const crowd::Behaviours &behaviours = crowd.behaviours();
    if (!behaviours.has_root_motion(row)) return crowd::Place();
    const crowd::RootMotion &motion = behaviours.root_motion(row);
    const crowd::RootPath &path = behaviours.path(motion.path);
    const double duration = static_cast<double>(path.duration_s);
    const double clock =
        static_cast<double>(motion.phase_s) + static_cast<double>(motion.speed) * (time_s - motion.start_s);
    double round = std::fmod(clock, duration);
    if (round < 0) round += duration;
    if (!(round >= 0 && round < duration)) round = 0;  // also of a clock that is beyond numbers
    return place_on(path, round);
}

float reach_of(const crowd::RootPath &path)
{
    double reach = 0;
    if (path.flight) {
        reach = flight_reach(path);
    } else {
        // In between it is straight, and a ball is convex.
        for (const glm::vec3 &p : path.positions) {
            const glm::dvec3 d(p);
            reach = std::fmax(reach, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
        }
    }
    return static_cast<float>(reach * (1 + 1e-6));
}

}  // namespace claque::behave
