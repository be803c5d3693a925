// A treadmill: a person walks or runs on the spot, and the ground moves below it.
//
// The person follows a straight track, so that its feet are held where they stand, and a root path takes it back by as
// much as the track carries it ahead. Both are repeated in laps of whole strides, so what is shown is a function of the
// time.
#pragma once

#include <array>
#include <optional>

#include "samples/scenes/walkers/cast.h"

namespace scenes::roles
{

struct Home {
    std::array<double, 3> position = {0, 0, 0};
    double heading_rad = 0;
    float scale = 1;
};

// How far the soles slide over the ground while they carry weight, by the definition of the foot law
// (docs/tracks.md).
struct FootDrift {
    double mean_mm = 0, most_mm = 0;
    size_t steps = 0;
};

class Treadmill
{
public:
    // Throws Failure.
    Treadmill(Library &library, clq_crowd *crowd, clq_template *tmpl, const clq_locomotion *walk, double speed_m_s,
              const Home &home);

    int64_t lap_at(double time_s) const;
    // Puts an actor on it, for this lap. Its fades and layers end.
    void carry(clq_actor actor, int64_t lap) const;
    // How far the ground has moved, metres.
    double ground_m(double time_s) const;
    clq_track_state state(double time_s) const;
    // Measured at the first call.
    const FootDrift &drift();

private:
    double track_time(double time_s) const;
    void find_lap();
    void add_root_path();

    Library &library_;
    clq_crowd *crowd_;
    clq_template *tmpl_;
    const clq_locomotion *walk_;
    double speed_m_s_;
    Home home_;
    walkers::OwnTrack track_;
    clq_root_path path_ = {};
    double lap_s_ = 50, lap_m_ = 0;
    std::optional<FootDrift> drift_;
};

// Steps through a part of a track with a crowd of its own: the poses are those of the times, not of ticks.
FootDrift drift_of(Library &library, clq_template *tmpl, const clq_locomotion *walk, clq_track *track, float scale,
                   double from_s, double to_s);

}  // namespace scenes::roles
