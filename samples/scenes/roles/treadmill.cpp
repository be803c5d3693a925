#include "samples/scenes/roles/treadmill.h"

#include <algorithm>
#include <cmath>

namespace scenes::roles
{
namespace
{

constexpr double first_s = 4;      // of a lap, on the track's own clock: it walks steadily then
constexpr double longest_s = 60;   // of a lap
constexpr double key_s = 0.1;      // between keys of the root path
constexpr double back_s = 0.004;   // in which the root path closes, never shown
constexpr double measured_s = 10;  // of the track, for the drift

double turns(double phase) { return phase - std::floor(phase); }

clq_track_state state_of(const clq_track *track, double time_s)
{
    clq_track_state state = {};
    check(clq_track_evaluate(track, time_s, &state));
    return state;
}

}  // namespace

Treadmill::Treadmill(Library &library, clq_crowd *crowd, clq_template *tmpl, const clq_locomotion *walk,
                     double speed_m_s, const Home &home)
    : library_(library), crowd_(crowd), tmpl_(tmpl), walk_(walk), speed_m_s_(speed_m_s), home_(home)
{
    std::vector<clq_track_point> points;
    const double s = std::sin(home.heading_rad), c = std::cos(home.heading_rad);
    for (double t = 0; t <= first_s + longest_s + 4; t += 0.5) {
        const double way = speed_m_s * (t - first_s);
        points.push_back({t,
                          {home.position[0] + s * way, home.position[1], home.position[2] + c * way},
                          static_cast<float>(home.heading_rad)});
    }
    clq_track_def def = clq_track_def_init();
    def.points = points.data(), def.point_count = static_cast<uint32_t>(points.size());
    def.scale = std::fabs(home.scale);
    clq_track *made = nullptr;
    check(clq_track_create(walk, &def, &made), "the treadmill");
    track_.reset(made);
    find_lap();
    add_root_path();
}

// As long as fits whole strides, so that the end of a lap is its beginning.
void Treadmill::find_lap()
{
    const double phase = state_of(track_.get(), first_s).phase;
    for (double t = first_s + longest_s; t > first_s + longest_s / 2; t -= 0.02) {
        const double later = turns(state_of(track_.get(), t).phase - phase),
                     sooner = turns(state_of(track_.get(), t - 0.02).phase - phase);
        if (!(sooner > 0.5 && later < 0.5)) continue;
        lap_s_ = t - 0.02 * later / (later + 1 - sooner) - first_s;
        break;
    }
    lap_m_ = ground_m(lap_s_ * (1 - 1e-12));
}

void Treadmill::add_root_path()
{
    std::vector<float> positions, rotations, times;
    const auto key = [&](double lap_time_s, double at_s) {
        const clq_track_state state = state_of(track_.get(), first_s + at_s);
        // A track rounds headings, and the root path turns with them.
        const double s = std::sin(state.heading_rad), c = std::cos(state.heading_rad);
        const double x = home_.position[0] - state.position[0], z = home_.position[2] - state.position[2];
        const double scale = static_cast<double>(std::fabs(home_.scale));
        positions.insert(positions.end(),
                         {static_cast<float>((x * c - z * s) / scale), 0, static_cast<float>((x * s + z * c) / scale)});
        rotations.insert(rotations.end(), {0, 0, 0, 1});
        times.push_back(static_cast<float>(lap_time_s));
    };
    for (double t = 0; t < lap_s_ - key_s; t += key_s) key(t, t);
    key(lap_s_, lap_s_);
    clq_root_path_def def = clq_root_path_def_init();
    def.count = static_cast<uint32_t>(times.size());
    def.positions = positions.data(), def.rotations_xyzw = rotations.data(), def.times_s = times.data();
    def.duration_s = static_cast<float>(lap_s_ + back_s);
    check(clq_crowd_add_root_path(crowd_, &def, &path_), "the treadmill");
}

int64_t Treadmill::lap_at(double time_s) const { return static_cast<int64_t>(std::floor(time_s / lap_s_)); }

double Treadmill::track_time(double time_s) const
{
    return first_s + time_s - static_cast<double>(lap_at(time_s)) * lap_s_;
}

void Treadmill::carry(clq_actor actor, int64_t lap) const
{
    const double begin_s = static_cast<double>(lap) * lap_s_;
    check(clq_actor_follow_track(crowd_, actor, track_.get(), begin_s - first_s));
    clq_root_path_play play = clq_root_path_play_init();
    play.path = path_;
    play.start_s = begin_s;
    check(clq_actor_play_root_path(crowd_, actor, &play));
}

clq_track_state Treadmill::state(double time_s) const { return state_of(track_.get(), track_time(time_s)); }

double Treadmill::ground_m(double time_s) const
{
    const clq_track_state now = state(time_s);
    return static_cast<double>(lap_at(time_s)) * lap_m_ +
           (now.position[0] - home_.position[0]) * std::sin(home_.heading_rad) +
           (now.position[2] - home_.position[2]) * std::cos(home_.heading_rad);
}

const FootDrift &Treadmill::drift()
{
    if (!drift_)
        drift_ = drift_of(library_, tmpl_, walk_, track_.get(), std::fabs(home_.scale), first_s, first_s + measured_s);
    return *drift_;
}

}  // namespace scenes::roles
