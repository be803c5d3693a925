#include "lib/track/footing.h"

#include <algorithm>

#include "lib/base/error.h"
#include "lib/base/host_call.h"
#include "lib/math/trig.h"

namespace claque::track
{

namespace
{

constexpr double reach_m = 0.15, step_m = 0.03;
// From the ball, in lengths of the sole: its tip, two points below it, and its end.
constexpr double along[] = {0.42, 0, -0.35, -0.76};
constexpr double ball_to_heel = 0.6;  // of the sole's length (sole.cpp)
// A metre of stone that stands in a foot's way counts as one, so much the air below its sole, and a metre moved.
constexpr double air_cost = 0.3, move_cost = 0.25;
constexpr double edge_m = 0.05;  // less than this is a slope, on which the foot stays at the height of its ball

struct Fit {
    double ball = NAN, above = 0, below = 0;  // metres; of the ground over and under the height at the ball

    double cost() const { return above + air_cost * below; }
};

}  // namespace

Footing::Footing(const BuildSettings &settings, const Locomotion &locomotion, const Track &track, int foot)
    : settings_(settings), origin_m_(track.origin_m), metres_per_unit_(track.metres_per_unit)
{
    const pose::Leg &leg = locomotion.legs[foot];
    const glm::dvec3 d = glm::dvec3(leg.ball) - glm::dvec3(leg.heel);
    sole_m_ = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z) / ball_to_heel * track.scale;
    // A leg reaches no farther than its foot may be moved, give or take what the body climbs meanwhile.
    highest_m_ = 2 * double(leg.max_shift) * track.scale;
}

double Footing::height(double x, double z, double body_y) const
{
    const glm::dvec3 p = (origin_m_ + glm::dvec3(x, body_y, z)) / metres_per_unit_;
    const double point[3] = {p.x, p.y, p.z};
    double y = NAN;
    const base::Status status =
        base::call_host("clq_track_def.ground", [&] { y = settings_.ground(settings_.ground_user, point); });
    if (!status.ok()) base::fail(status.code, "%s", status.text);
    y = y * metres_per_unit_ - origin_m_.y;
    return std::fabs(y - body_y) <= highest_m_ ? y : NAN;
}

void Footing::settle(Stance &stance, double body_y) const
{
    if (!settings_.ground) return;
    const double ahead_x = math::sin(stance.heading_rad), ahead_z = math::cos(stance.heading_rad);
    const auto fit_at = [&](double shift_m) {
        Fit fit;
        fit.ball = height(stance.x + shift_m * ahead_x, stance.z + shift_m * ahead_z, body_y);
        for (const double part : along) {
            const double at = shift_m + part * sole_m_;
            const double y = part == 0 ? fit.ball : height(stance.x + at * ahead_x, stance.z + at * ahead_z, body_y);
            fit.above = std::fmax(fit.above, y - fit.ball), fit.below = std::fmax(fit.below, fit.ball - y);
        }
        return fit;
    };
    Fit best = fit_at(0);
    double best_cost = best.cost(), best_m = 0;
    for (int k = 1; k * step_m <= reach_m + 1e-9 && k * step_m * move_cost < best_cost; ++k)
        for (const double shift_m : {k * step_m, -k * step_m}) {
            const Fit fit = fit_at(shift_m);
            const double cost = fit.cost() + move_cost * k * step_m;
            if (std::isfinite(fit.ball) && cost < best_cost) best = fit, best_cost = cost, best_m = shift_m;
        }
    if (!std::isfinite(best.ball)) return;
    stance.x += best_m * ahead_x, stance.z += best_m * ahead_z;
    stance.y = best.ball + (best.above > edge_m ? best.above : 0);
}

}  // namespace claque::track
