// The direction in which a person looks: that of the file, or along the way. Below walking pace it is held. It turns by
// 178 degrees a second at most. A person that stands turns on the spot.
#include <algorithm>
#include <cmath>

#include "lib/math/trig.h"
#include "lib/track/build.h"

namespace claque::track
{

namespace
{

constexpr double held_below_m_s = 0.25;
constexpr double turn_in_place_rad_s = 1.7;  // nearly a second for a quarter turn
constexpr double min_turn_in_place_rad = 0.35;
constexpr double still_rad_s = 0.05;  // a file that turns by less rests

// The directions that are known, on the fine grid; false: none is.
bool given_headings(base::Span<const Point> points, FinePath &path, Array<uint8_t> &known)
{
    bool any = false;
    uint32_t at = 0;
    for (uint32_t i = 0; i < path.count(); ++i) {
        const double time_s = path.start_s + i / path.hz;
        while (at + 1 < points.count && points[at + 1].time_s <= time_s) ++at;
        const double a = points[at].heading_rad;
        known[i] = std::isfinite(a);
        if (!known[i]) continue;
        path.heading[i] = a;
        any = true;
        if (at + 1 == points.count || !std::isfinite(points[at + 1].heading_rad)) continue;
        const double b = nearest_turn(points[at + 1].heading_rad, a);
        const double part = (time_s - points[at].time_s) / (points[at + 1].time_s - points[at].time_s);
        path.heading[i] = a + (b - a) * std::min(1.0, part);
    }
    return any;
}

bool headings_of_motion(FinePath &path, Array<uint8_t> &known)
{
    bool any = false;
    for (uint32_t i = 0; i < path.count(); ++i) {
        const uint32_t before = i > 6 ? i - 6 : 0, after = std::min(i + 6, path.count() - 1);
        const double x = path.x[after] - path.x[before], z = path.z[after] - path.z[before];
        const double seconds = (after - before) / path.hz;
        known[i] = !path.stands[i] && x * x + z * z > held_below_m_s * held_below_m_s * seconds * seconds;
        if (known[i]) path.heading[i] = math::atan2(x, z), any = true;
    }
    if (any || path.count() == 0) return any;
    // Without any way travelled: the way from one end to the other, if there is any.
    const double x = path.x.back() - path.x.front(), z = path.z.back() - path.z.front();
    known[0] = 1;
    path.heading[0] = x != 0 || z != 0 ? math::atan2(x, z) : 0;
    return true;
}

// Where the piece before looked, as far as it is in sight; it looks on like that until more is known.
void remember(FinePath &path, Array<uint8_t> &known)
{
    for (uint32_t i = 0; i <= path.first; ++i) {
        const double time_s = std::max(path.start_s + i / path.hz, path.previous->start_s);
        path.heading[i] = state_at(*path.previous, time_s).heading_rad;
        known[i] = 1;
    }
}

// Holds the last known direction, and the first one before it was known; no jumps by whole turns.
void hold(Array<double> &heading, const Array<uint8_t> &known)
{
    const size_t first = static_cast<size_t>(std::find(known.begin(), known.end(), 1) - known.begin());
    std::fill(heading.begin(), heading.begin() + static_cast<ptrdiff_t>(first), heading[first]);
    for (size_t i = first + 1; i < heading.size(); ++i)
        heading[i] = known[i] ? nearest_turn(heading[i], heading[i - 1]) : heading[i - 1];
}

constexpr uint32_t leaving_samples = 40;  // in which a person gathers speed

// The direction in which a person leaves a stand that ends at `last`. While it is slow it has no direction of motion
// yet: it already looks where it will go.
double leaving(FinePath &path, uint32_t last, bool along_the_way)
{
    const uint32_t count = path.count();
    if (!along_the_way) return path.heading[std::min(last + 12, count - 1)];
    uint32_t to = last + 1;
    while (to + 1 < count && to < last + leaving_samples && !path.stands[to + 1]) ++to;
    const double next = path.heading[to];
    std::fill(path.heading.begin() + last + 1, path.heading.begin() + to, next);
    return next;
}

// A turn on the spot that ends at sample `end` takes `wanted` samples, and shows its last `steps` of them.
void turn_at(FinePath &path, double from, double turn, uint32_t end, uint32_t steps, uint32_t wanted)
{
    for (uint32_t k = 0; k < steps; ++k) {
        const double t = double(k + 1) / steps;
        path.heading[end - steps + 1 + k] = from + turn * t * t * (3 - 2 * t) * double(steps) / wanted;
    }
}

uint32_t samples_of_turn(const FinePath &path, double turn)
{
    return static_cast<uint32_t>(std::fabs(turn) / turn_in_place_rad_s * path.hz);
}

// A file turns a person that stands from `first` to `last`: the person rests until the file has looked elsewhere for
// half a second, and then turns to where the file rests, or to where it looks after two seconds of its turn. What
// trembles by less turns nobody. Returns the sample from which the person rests.
uint32_t follow_the_file(FinePath &path, uint32_t first, uint32_t last)
{
    const auto lasting = static_cast<uint32_t>(0.5 * path.hz), ahead = static_cast<uint32_t>(2 * path.hz);
    const Array<double> given(path.heading.begin() + first, path.heading.begin() + last + 1,
                              path.heading.get_allocator().resource());
    // A piece goes on with a turn of the piece before.
    const bool turns = first > 0 && std::fabs(path.heading[first] - path.heading[first - 1]) * path.hz > still_rad_s;
    uint32_t rests = first, elsewhere = turns && first == path.first ? lasting : 0;
    double held = given[0];
    for (uint32_t i = first + 1; i <= last; ++i) {
        path.heading[i] = held;
        elsewhere = std::fabs(given[i - first] - held) > min_turn_in_place_rad ? elsewhere + 1 : 0;
        if (elsewhere < lasting) continue;
        uint32_t steps = 1;
        const auto turn = [&](uint32_t more) { return given[i + steps + more - first] - held; };
        const auto goes_on = [&] { return std::fabs(turn(1)) > std::fabs(turn(0)) + still_rad_s / path.hz; };
        while (steps < ahead && i + steps < last && (samples_of_turn(path, turn(0)) > steps || goes_on())) ++steps;
        if (i + steps >= last || std::fabs(turn(0)) < min_turn_in_place_rad) continue;
        turn_at(path, held, turn(0), i + steps, steps, steps);
        held = given[i + steps - first];
        rests = i += steps, elsewhere = 0;
    }
    return rests;
}

// Turns of a person that stands: its feet step on the spot. A turn to the way on takes the end of the stand.
void turn_in_place(FinePath &path, bool along_the_way)
{
    const uint32_t count = path.count();
    for (uint32_t first = 0; first < count; ++first) {
        if (!path.stands[first]) continue;
        uint32_t last = first;
        while (last + 1 < count && path.stands[last + 1]) ++last;
        // What was decided before stays.
        const uint32_t decided = std::clamp(path.first, first, last);
        const uint32_t rests = along_the_way ? decided : follow_the_file(path, decided, last);
        const double held = path.heading[rests];
        std::fill(path.heading.begin() + rests, path.heading.begin() + last + 1, held);
        if (last + 1 < count) {
            const double turn = leaving(path, last, along_the_way) - held;
            const uint32_t wanted = samples_of_turn(path, turn), stood = last - rests;
            const uint32_t steps = std::min(wanted, stood > min_stand ? stood - min_stand : 0);
            if (std::fabs(turn) > min_turn_in_place_rad) turn_at(path, held, turn, last, steps, wanted);
        }
        first = last;
    }
}

// The middle of the lowest upper and the highest lower bound that turn no faster: it leaves alone what turns slowly
// enough, and spreads what does not over both sides.
void limit_rate(Array<double> &heading, double rad_s, double hz)
{
    const double step = rad_s / hz;
    const size_t count = heading.size();
    Array<double> upper(heading, heading.get_allocator().resource()),
        lower(heading, heading.get_allocator().resource());
    for (size_t i = 1; i < count; ++i) {
        upper[i] = std::min(upper[i], upper[i - 1] + step);
        lower[i] = std::max(lower[i], lower[i - 1] - step);
    }
    for (size_t i = count - 1; i-- > 0;) {
        upper[i] = std::min(upper[i], upper[i + 1] + step);
        lower[i] = std::max(lower[i], lower[i + 1] - step);
    }
    for (size_t i = 0; i < count; ++i) heading[i] = 0.5 * (upper[i] + lower[i]);
}

// Rounds the corners that the limit leaves, between the stands.
void smooth_turns(FinePath &path)
{
    for (uint32_t first = 0; first < path.count(); ++first) {
        if (path.stands[first]) continue;
        uint32_t last = first;
        while (last + 1 < path.count() && !path.stands[last + 1]) ++last;
        smooth(path.heading, first, last, 6, Beyond::mirrored);
        first = last;
    }
}

}  // namespace

void make_heading(base::Span<const Point> points, const BuildSettings &settings, FinePath &path)
{
    const uint32_t count = path.count();
    path.heading.assign(count, 0.0);
    Array<uint8_t> known(count, uint8_t(0), path.x.get_allocator().resource());
    const bool along_the_way = !given_headings(points, path, known);
    if (along_the_way) headings_of_motion(path, known);
    if (path.previous) remember(path, known);
    hold(path.heading, known);
    for (const FinePath::Piece &piece : path.pieces)
        smooth(path.heading, piece.first, piece.last, 12, Beyond::mirrored);
    turn_in_place(path, along_the_way);
    limit_rate(path.heading, settings.max_turn_rad_s, path.hz);
    smooth_turns(path);
    measure_turn(path);
}

double nearest_turn(double angle, double to)
{
    const double turn = 2 * math::pi;
    return angle - turn * std::floor((angle - to) / turn + 0.5);
}

void measure_turn(FinePath &path)
{
    path.turn.assign(path.count(), 0.0);
    for (uint32_t i = 1; i < path.count(); ++i) {
        path.turn[i] = std::fabs(path.heading[i] - path.heading[i - 1]) * path.hz;
        if (path.turn[i] > 1e-9) path.stands[i] = path.stands[i - 1] = 0;
    }
}

}  // namespace claque::track
