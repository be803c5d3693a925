// The times in which a person stands. Position freezes, so that the feet can rest; the path beside a stand is bent so
// that it leads there.
#include <algorithm>
#include <cmath>

#include "lib/track/build.h"

namespace claque::track
{

namespace
{

constexpr double stop_m_s = 0.10, start_m_s = 0.25;  // with hysteresis, or people would start at every sway
// Farther than this a person takes a step. Points that are smoothed less sway less, and people of a dense crowd are to
// stay where they are.
constexpr double max_drift_m = 0.2, min_drift_m = 0.05, drift_m_s = 0.33;
constexpr uint32_t step_samples = 50;  // for which there is a second
constexpr uint32_t bend_samples = 75;  // 1.5 s in which the path returns to its own place
constexpr uint32_t speed_half = 12;    // half a second
constexpr uint32_t settle = 7;         // at either end of a stand

double speed_of(const FinePath &path, uint32_t i, uint32_t half)
{
    const uint32_t reach = std::min({half, i, path.count() - 1 - i});
    if (reach == 0) return i == 0 && path.count() > 1 ? speed_of(path, 1, 1) : i > 0 ? speed_of(path, i - 1, 1) : 0;
    const double x = path.x[i + reach] - path.x[i - reach], z = path.z[i + reach] - path.z[i - reach];
    return std::sqrt(x * x + z * z) * path.hz / (2 * reach);
}

// A run of slow samples as stands that drift by little; between them lies a step.
void add_stands(const FinePath &path, double drift_m, uint32_t first, uint32_t last, Array<FinePath::Piece> &stands)
{
    uint32_t begin = first;
    for (uint32_t i = first; i <= last; ++i) {
        const double x = path.x[i] - path.x[begin], z = path.z[i] - path.z[begin];
        if (x * x + z * z <= drift_m * drift_m) continue;
        const uint32_t end = i > step_samples / 2 ? i - step_samples / 2 : 0;
        if (end >= begin + min_stand + 2 * settle) stands.push_back({begin, end});
        begin = i + step_samples / 2;
        i = begin;
    }
    if (last >= begin + min_stand + 2 * settle) stands.push_back({begin, last});
}

bool stood(const FinePath &path) { return path.previous && path.previous->samples.back().flags & stands_flag; }

Array<FinePath::Piece> slow_runs(const FinePath &path, double drift_m)
{
    Array<FinePath::Piece> stands(path.x.get_allocator().resource());
    bool slow = false;
    uint32_t begin = 0;
    for (uint32_t i = 0; i < path.count(); ++i) {
        const double speed = speed_of(path, i, speed_half);
        // A person that stood at the border stands on until it is fast enough to start, and long enough to be seen.
        if (!slow && i == path.first && stood(path) && speed <= start_m_s)
            slow = true, begin = i > min_stand + 2 * settle ? i - min_stand - 2 * settle : 0;
        if (!slow && speed < stop_m_s) slow = true, begin = i;
        if (slow && speed > start_m_s) {
            slow = false;
            add_stands(path, drift_m, begin, i - 1, stands);
        }
    }
    if (slow) add_stands(path, drift_m, begin, path.count() - 1, stands);
    return stands;
}

// Adds to a moving piece what its ends were moved by; both offsets fade towards the middle.
void bend(Array<double> &values, const FinePath::Piece &piece, double at_first, double at_last)
{
    const uint32_t length = piece.last - piece.first;
    if (length == 0) return;
    for (uint32_t i = piece.first + 1; i < piece.last; ++i) {
        const uint32_t from = i - piece.first, to = piece.last - i;
        if (length <= 2 * bend_samples) {
            const double t = eased(double(from) / length);
            values[i] += at_first * (1 - t) + at_last * t;
        } else {
            values[i] +=
                at_first * (1 - eased(double(from) / bend_samples)) + at_last * (1 - eased(double(to) / bend_samples));
        }
    }
}

void freeze(Array<double> &values, const Array<FinePath::Piece> &stands, const Array<FinePath::Piece> &pieces)
{
    const uint32_t count = static_cast<uint32_t>(values.size());
    Array<double> before(values, values.get_allocator().resource());
    for (const FinePath::Piece &stand : stands) {
        double sum = 0;
        for (uint32_t i = stand.first; i <= stand.last; ++i) sum += before[i] - before[stand.first];
        const double mean = before[stand.first] + sum / (stand.last - stand.first + 1);
        std::fill(values.begin() + stand.first, values.begin() + stand.last + 1, mean);
    }
    for (const FinePath::Piece &piece : pieces) {
        // The ends of the track itself are not moved.
        bend(values, piece, values[piece.first] - before[piece.first], values[piece.last] - before[piece.last]);
        // Into the stands, so that a person gathers speed and loses it; the ends of the track stay.
        const uint32_t first = piece.first > 0 ? piece.first - settle : 0,
                       last = std::min(piece.last + settle, count - 1);
        if (!stands.empty()) smooth(values, first, last, settle, Beyond::still);
    }
}

}  // namespace

void find_stands(const BuildSettings &settings, FinePath &path)
{
    const Array<FinePath::Piece> stands =
        slow_runs(path, std::clamp(drift_m_s * settings.smooth_s, min_drift_m, max_drift_m));
    const uint32_t count = path.count();
    path.stands.assign(count, 0);
    path.pieces.clear();
    uint32_t from = 0;
    for (const FinePath::Piece &stand : stands) {
        const uint32_t begin = stand.first + settle, end = stand.last - settle;
        std::fill(path.stands.begin() + begin, path.stands.begin() + end + 1, uint8_t(1));
        if (stand.first > from) path.pieces.push_back({from, stand.first});
        from = stand.last;
    }
    if (from + 1 < count) path.pieces.push_back({from, count - 1});
    for (Array<double> *column : {&path.x, &path.y, &path.z}) freeze(*column, stands, path.pieces);
    measure_speed(path);
}

void measure_speed(FinePath &path)
{
    path.speed.assign(path.count(), 0.0);
    for (uint32_t i = 0; i < path.count(); ++i) path.speed[i] = path.stands[i] ? 0 : speed_of(path, i, 3);
}

}  // namespace claque::track
