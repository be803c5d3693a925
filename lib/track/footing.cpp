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
constexpr double steepest = max_slope;
// Samples in which a path comes by, and those on either side over which its slope is taken.
constexpr uint32_t window = 75, beside = 12, farthest = 200;
constexpr double least_way_m = 0.1;  // without which there is no slope
constexpr double edge_m = 0.05;      // less than this is a slope, on which the foot stays at the height of its ball

struct Fit {
    double ball = NAN, above = 0, below = 0;  // metres; of the ground over and under the height at the ball
    double rise = 0;                          // from the end of the sole to its tip

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
            if (std::isfinite(y)) fit.rise += part > 0.3 ? y : part < -0.7 ? -y : 0;
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
    // On an edge a foot stays level.
    const double slope = best.rise / ((along[0] - along[3]) * sole_m_);
    if (best.above + best.below < edge_m && std::fabs(slope) < steepest) stance.slope = slope;
}

void Footing::follow_path(const FinePath &path, uint32_t near, Stance &stance)
{
    const auto away = [&](uint32_t i) {
        const double x = stance.x - path.x[i], z = stance.z - path.z[i];
        return x * x + z * z;
    };
    uint32_t at = near;
    for (uint32_t i = near > window ? near - window : 0; i < path.count() && i <= near + window; ++i)
        if (away(i) < away(at)) at = i;
    // Over a stand, too, as far as the person walks on either side of it.
    double x = 0, z = 0, rise = 0, way = 0;
    for (uint32_t half = beside; half <= farthest && way < least_way_m; half *= 2) {
        const uint32_t first = at > half ? at - half : 0, last = std::min(at + half, path.count() - 1);
        x = path.x[last] - path.x[first], z = path.z[last] - path.z[first], rise = path.y[last] - path.y[first];
        way = std::sqrt(x * x + z * z);
    }
    const double slope = way > least_way_m ? rise / way : 0;
    if (!(std::fabs(slope) < steepest)) return;
    const double ahead_x = math::sin(stance.heading_rad), ahead_z = math::cos(stance.heading_rad);
    const double beyond = way > 0 ? ((stance.x - path.x[at]) * x + (stance.z - path.z[at]) * z) / way : 0;
    stance.y = path.y[at] + slope * beyond;
    stance.slope = way > 0 ? slope * (ahead_x * x + ahead_z * z) / way : 0;
}

}  // namespace claque::track
