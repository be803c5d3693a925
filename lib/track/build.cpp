#include "lib/track/build.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"
#include "lib/track/piece.h"

namespace claque::track
{

namespace
{

using base::fail;

constexpr double max_length_s = 1e6;   // 278 hours
constexpr double max_reach_m = 2.5e5;  // from the first point: samples hold 2^31 steps

void check(base::Span<const Point> points, const BuildSettings &settings)
{
    if (points.count == 0) fail(CLQ_ARGUMENT, "a track of no points");
    const auto require_positive = [](const char *name, double value) {
        if (!(value > 0) || !std::isfinite(value))
            fail(CLQ_ARGUMENT, "%s of a track is %g: more than 0 is wanted", name, value);
    };
    require_positive("metres_per_unit", settings.metres_per_unit);
    require_positive("scale", settings.scale);
    if (std::isnan(settings.end_s)) fail(CLQ_ARGUMENT, "end_s of a track is not a number");
    require_positive("max_turn_rad_s", settings.max_turn_rad_s);
    if (!(settings.smooth_s >= 0) || settings.smooth_s > 60)
        fail(CLQ_ARGUMENT, "smooth_s of a track is %g: 0 to 60 is wanted", settings.smooth_s);
    const glm::dvec3 first_m =
        settings.previous ? settings.previous->origin_m : points[0].position * settings.metres_per_unit;
    for (uint32_t i = 0; i < points.count; ++i) {
        const Point &p = points[i];
        if (!std::isfinite(p.time_s)) fail(CLQ_ARGUMENT, "the time of point %u of a track is not finite", i);
        if (i > 0 && !(p.time_s > points[i - 1].time_s))
            fail(CLQ_ARGUMENT, "point %u of a track is at %.9g s, that before it at %.9g s: ascending times are wanted",
                 i, p.time_s, points[i - 1].time_s);
        for (int k = 0; k < 3; ++k)
            if (!std::isfinite(p.position[k]))
                fail(CLQ_ARGUMENT, "the position of point %u of a track is not finite", i);
        const glm::dvec3 d = p.position * settings.metres_per_unit - first_m;
        if (!(std::fabs(d.x) < max_reach_m && std::fabs(d.y) < max_reach_m && std::fabs(d.z) < max_reach_m))
            fail(CLQ_LIMIT, "point %u of a track is %.6g, %.6g, %.6g m from its first point: %g m at most are possible",
                 i, d.x, d.y, d.z, max_reach_m);
    }
    for (uint32_t i = 0; i < settings.passings.count; ++i) {
        const Passing &p = settings.passings[i];
        if (!std::isfinite(p.time_s) || !std::isfinite(p.position.x) || !std::isfinite(p.position.z))
            fail(CLQ_ARGUMENT, "passing %u of a track is not finite", i);
        if (i > 0 && p.time_s < settings.passings[i - 1].time_s)
            fail(CLQ_ARGUMENT,
                 "passing %u of a track is at %.9g s, that before it at %.9g s: ascending times are wanted", i,
                 p.time_s, settings.passings[i - 1].time_s);
    }
    const double length = points[points.count - 1].time_s - points[0].time_s;
    if (!(length <= max_length_s))
        fail(CLQ_LIMIT, "a track of %.6g s: at most %g s are possible", length, max_length_s);
}

void report(base::Span<const Point> points, double end_s, const FinePath &path, Track &out)
{
    double sum = 0;
    uint32_t shown = 0;
    for (uint32_t i = 0; i < points.count; ++i) {
        if (points[i].time_s < out.start_s || points[i].time_s > end_s) continue;
        ++shown;
        const glm::dvec3 d = (position_at(out, points[i].time_s) - points[i].position) * out.metres_per_unit;
        const double shift = std::sqrt(d.x * d.x + d.z * d.z);
        sum += shift;
        out.max_shift_m = std::fmax(out.max_shift_m, shift);
    }
    out.mean_shift_m = sum / std::max(1u, shown);
    for (uint32_t i = path.first + 1; i <= path.last; ++i) {
        const double x = path.x[i] - path.x[i - 1], z = path.z[i] - path.z[i - 1];
        out.distance_m += std::sqrt(x * x + z * z);
        out.standing_s += path.stands[i] ? 1 / path.hz : 0;
    }
}

}  // namespace

void build(const Locomotion &locomotion, base::Span<const Point> points, const BuildSettings &settings, Track &out)
{
    check(points, settings);
    std::pmr::memory_resource *memory = out.samples.get_allocator().resource();
    out.locomotion = &locomotion;
    out.metres_per_unit = settings.metres_per_unit;
    out.scale = settings.scale * settings.metres_per_unit;
    const Track *previous = settings.previous;
    const double last_s = points[points.count - 1].time_s, end_s = std::min(settings.end_s, last_s);
    out.start_s = previous ? end_of(*previous) : points[0].time_s;
    out.length_s = end_s - out.start_s;
    out.previous_hash = previous ? previous->hash : 0;
    // Whole metres, so that sums with the origin round as little as can be.
    for (int k = 0; k < 3; ++k)
        out.origin_m[k] =
            previous ? previous->origin_m[k] : std::floor(points[0].position[k] * settings.metres_per_unit);

    FinePath path(memory);
    if (previous || end_s < last_s) {
        check_piece(locomotion, points, settings);
        make_piece_grid(points, settings, path);
        points = in_sight(points, path);
    } else {
        make_grid(points, path);
    }
    make_path(points, settings, out.origin_m, path);
    find_stands(settings, path);
    if (previous) join_path(path);
    make_heading(points, settings, path);
    if (previous) join_heading(settings.max_turn_rad_s, path);
    out.stand_count = make_gait(locomotion, settings, path);
    pack(path, out);
    make_plants(locomotion, settings, path, out);
    make_shoulders(settings, path, out);
    index_plants(out);
    make_sinks(locomotion, path, out);
    make_ahead(path, out);
    if (previous) join_swings(*previous, out), join_upper(*previous, out);
    out.top_speed = top_speed_of(out);
    out.reach = reach_of(out);
    out.hash = hash_of(out);
    report(points, end_s, path, out);
}

}  // namespace claque::track
