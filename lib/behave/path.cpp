#include "lib/behave/path.h"

#include <cmath>

namespace claque::behave
{

crowd::Transform transform_on(const crowd::RootPath &path, double round_s) noexcept
{
    return path.flight ? flight_transform(path, round_s) : table_transform(path, round_s);
}

namespace
{

// [0, duration_s)
double round_of(const crowd::RootPathPlay &root_play, const crowd::RootPath &path, double time_s)
{
    const double duration = static_cast<double>(path.duration_s);
    const double clock =
        static_cast<double>(root_play.phase_s) + static_cast<double>(root_play.speed) * (time_s - root_play.start_s);
    double round = std::fmod(clock, duration);
    if (round < 0) round += duration;
    if (!(round >= 0 && round < duration)) round = 0;  // also for a clock beyond the range of numbers
    return round;
}

}  // namespace

crowd::Transform root_transform_at(const crowd::Crowd &crowd, uint32_t row, double time_s) noexcept
{
    const crowd::Behaviours &behaviours = crowd.behaviours();
    if (!behaviours.has_root_path_play(row)) return crowd::Transform();
    const crowd::RootPathPlay &root_play = behaviours.root_path_play(row);
    const crowd::RootPath &path = behaviours.path(root_play.path);
    return transform_on(path, round_of(root_play, path, time_s));
}

RootSpeed root_speed_at(const crowd::Crowd &crowd, uint32_t row, double time_s) noexcept
{
    const crowd::Behaviours &behaviours = crowd.behaviours();
    if (!behaviours.has_root_path_play(row)) return RootSpeed();
    const crowd::RootPathPlay &root_play = behaviours.root_path_play(row);
    const crowd::RootPath &path = behaviours.path(root_play.path);
    const double round = round_of(root_play, path, time_s);
    RootSpeed out = path.flight ? flight_speed(path, round) : table_speed(path, round);
    const double pace = std::fabs(static_cast<double>(root_play.speed));
    out.speed *= pace, out.turn_rad_s *= pace;
    return out;
}

float reach_of(const crowd::RootPath &path)
{
    double reach = 0;
    if (path.flight) {
        reach = flight_reach(path);
    } else {
        // Linear between keys, and a ball is convex.
        for (const glm::vec3 &p : path.positions) {
            const glm::dvec3 d(p);
            reach = std::fmax(reach, std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z));
        }
    }
    return static_cast<float>(reach * (1 + 1e-6));
}

}  // namespace claque::behave
