#include "lib/track/piece.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"

namespace claque::track
{

namespace
{

using base::fail;

constexpr uint32_t min_fade = 15, max_fade = 50;  // samples in which an offset fades
constexpr uint32_t gait_fade = 18;
constexpr double grid_part = 1e-6;  // of a step: what rounding may take from a window

// The piece before at its end, in the terms of a fine path.
struct Border {
    glm::dvec3 place, slope;  // metres from the origin, and what they change by in a second
    double heading, turn;
    bool stands;
};

Border border_of(const Track &previous)
{
    const double end_s = end_of(previous), before_s = end_s - std::min(0.04, previous.length_s);
    const State at = state_at(previous, end_s), before = state_at(previous, before_s);
    Border border{};
    border.place = at.position * previous.metres_per_unit - previous.origin_m;
    border.heading = at.heading_rad;
    border.stands = previous.samples.back().flags & stands_flag;
    if (border.stands || !(end_s > before_s)) return border;
    border.slope = (at.position - before.position) * previous.metres_per_unit / (end_s - before_s);
    border.turn = nearest_turn(at.heading_rad - before.heading_rad, 0) / (end_s - before_s);
    return border;
}

// The samples in which an offset fades: not before the person moves, and done when it stands again.
struct Fade {
    uint32_t first, length;
};

Fade fade_of(const FinePath &path, bool stood)
{
    const uint32_t count = path.count();
    uint32_t first = path.first;
    if (stood)
        while (first + 1 < count && path.stands[first + 1]) ++first;
    uint32_t next = first + 1;
    while (next < count && !path.stands[next]) ++next;
    return {first, std::clamp(next - first, min_fade, max_fade)};
}

double slope_of(const Array<double> &values, const FinePath &path)
{
    const uint32_t steps = static_cast<uint32_t>(0.04 * path.hz + 0.5);
    const uint32_t from = path.first >= steps ? path.first - steps : 0;
    const uint32_t to = std::max(path.first, from + 1);
    return (values[to] - values[from]) * path.hz / (to - from);
}

void add_offset(Array<double> &values, const FinePath &path, const Fade &fade, double at_border, double slope_s)
{
    const double offset = at_border - values[path.first];
    for (uint32_t i = 0; i < path.count() && i < fade.first + fade.length; ++i) {
        const double part = i > fade.first ? double(i - fade.first) / fade.length : 0;
        values[i] += left_of(offset, slope_s * fade.length / path.hz, part);
    }
    values[path.first] = at_border;
}

}  // namespace

double left_of(double offset, double slope, double part)
{
    const double rest = 1 - part;
    return rest * rest * (offset * (1 + 2 * part) + slope * part);
}

void check_piece(const Locomotion &locomotion, base::Span<const Point> points, const BuildSettings &settings)
{
    const Track *previous = settings.previous;
    const double last_s = points[points.count - 1].time_s;
    const double start_s = previous ? end_of(*previous) : points[0].time_s;
    const double end_s = std::min(settings.end_s, last_s);
    constexpr double rounding_s = 1e-6;
    if (!(end_s >= start_s + min_piece_s - rounding_s))
        fail(CLQ_ARGUMENT, "a piece of a track goes from %.9g s to %.9g s: it must be %g s long at least", start_s,
             end_s, min_piece_s);
    if (!previous) return;
    if (previous->locomotion != &locomotion)
        fail(CLQ_ARGUMENT, "a piece of a track has another locomotion than the piece before");
    if (previous->metres_per_unit != settings.metres_per_unit ||
        previous->scale != settings.scale * settings.metres_per_unit)
        fail(CLQ_ARGUMENT, "a piece of a track has a scale of %g m, the piece before one of %g m",
             settings.scale * settings.metres_per_unit, previous->scale);
    if (points[0].time_s > start_s)
        fail(CLQ_ARGUMENT, "the first point of a piece is at %.9g s, but the piece before ends at %.9g s",
             points[0].time_s, start_s);
}

void make_piece_grid(base::Span<const Point> points, const BuildSettings &settings, FinePath &path)
{
    const double first_s = points[0].time_s, last_s = points[points.count - 1].time_s;
    const double start_s = settings.previous ? end_of(*settings.previous) : first_s;
    const double length_s = std::min(settings.end_s, last_s) - start_s;
    // Steps by fives, so that one sample in five can be enough.
    const uint32_t steps = 5 * std::max(1u, static_cast<uint32_t>(length_s * fine_hz / 5 + 0.5));
    path.hz = steps / length_s;
    const auto steps_in = [&](double seconds) {
        return static_cast<uint32_t>(std::clamp(seconds, 0.0, sight_s) * path.hz + grid_part);
    };
    const uint32_t before = steps_in(start_s - first_s), after = steps_in(last_s - start_s - length_s);
    path.start_s = start_s - before / path.hz;
    path.first = before, path.last = before + steps;
    path.x.resize(size_t(path.last) + after + 1);
    path.previous = settings.previous;
}

base::Span<const Point> in_sight(base::Span<const Point> points, const FinePath &path)
{
    const double begin_s = path.start_s, end_s = path.start_s + (path.count() - 1) / path.hz;
    const auto before = [](const Point &p, double time_s) { return p.time_s < time_s; };
    const Point *all = points.data, *all_end = points.data + points.count;
    const Point *first = std::lower_bound(all, all_end, begin_s, before);
    const Point *last = std::lower_bound(first, all_end, end_s, before);
    // Two more at either side: the curve between two points takes its slopes from their neighbours.
    first -= std::min<ptrdiff_t>(2, first - all);
    last += std::min<ptrdiff_t>(3, all_end - last);
    return {first, static_cast<uint32_t>(last - first)};
}

void join_path(FinePath &path)
{
    const Border border = border_of(*path.previous);
    const Fade fade = fade_of(path, border.stands);
    double most = 0;
    for (int axis = 0; axis < 3; ++axis) {
        Array<double> &values = axis == 0 ? path.x : axis == 1 ? path.y : path.z;
        const double slope = border.stands ? 0 : border.slope[axis] - slope_of(values, path);
        most = std::max({most, std::fabs(border.place[axis] - values[path.first]), std::fabs(slope)});
        add_offset(values, path, fade, border.place[axis], slope);
    }
    path.stands[path.first] = border.stands;
    if (most > 1e-9)
        for (uint32_t i = fade.first + 1; i < path.count() && i < fade.first + fade.length; ++i) path.stands[i] = 0;
    measure_speed(path);
}

void join_heading(double max_turn_rad_s, FinePath &path)
{
    const Border border = border_of(*path.previous);
    const Fade fade = fade_of(path, border.stands);
    const double at = nearest_turn(border.heading, path.heading[path.first]);
    const double slope = border.stands ? 0 : border.turn - slope_of(path.heading, path);
    add_offset(path.heading, path, fade, at, slope);
    const double step = max_turn_rad_s / path.hz;
    for (uint32_t i = path.first + 1; i < path.count(); ++i)
        path.heading[i] = std::clamp(path.heading[i], path.heading[i - 1] - step, path.heading[i - 1] + step);
    const uint8_t stands = path.stands[path.first];
    measure_turn(path);
    path.stands[path.first] = stands;
}

void join_gait(double max_gait, FinePath &path)
{
    const double offset = double(path.previous->samples.back().gait) / gait_unit - path.gait[path.first];
    const double turning = double(turn_of(path.previous->samples.back().flags)) / turn_unit - path.turning[path.first];
    for (uint32_t i = path.first; i < path.count() && i < path.first + gait_fade; ++i) {
        if (i > path.first && path.stands[i]) continue;
        const double part = double(i - path.first) / gait_fade;
        path.gait[i] = std::clamp(path.gait[i] + left_of(offset, 0, part), 0.0, max_gait);
        path.turning[i] = std::clamp(path.turning[i] + left_of(turning, 0, part), 0.0, 1.0);
    }
}

void join_idle(FinePath &path)
{
    uint8_t shown = static_cast<uint8_t>(idle_of(path.previous->samples.back().flags));
    for (uint32_t i = path.first; i < path.count(); ++i) {
        if (i > path.first && path.gait[i - 1] >= 1) shown = path.idle[i];  // no one sees it change
        path.idle[i] = shown;
    }
}

}  // namespace claque::track
