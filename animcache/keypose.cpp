#include "animcache/keypose.h"

#include <algorithm>
#include <cmath>

#include "lib/pose/pose.h"

namespace claque::animcache
{

namespace
{

// A clip loops without a jump if no number of its first and last matrices differs by more (model units and shares).
constexpr float same_within = 1e-4f;

bool ends_as_it_begins(const model::Template &tmpl, uint32_t clip)
{
    pose::Workspace space(tmpl.rig);
    const model::Clip &of = tmpl.rig.clips[clip];
    const base::Span<const math::Affine> first = space.pose(clip, of.start_s);
    const std::vector<math::Affine> start(first.begin(), first.end());
    const base::Span<const float> weights = space.weights();
    const std::vector<float> start_weights(weights.begin(), weights.end());
    const base::Span<const math::Affine> end = space.pose(clip, double(of.start_s) + double(of.duration_s));
    const auto near = [](const float *a, const float *b, size_t n) {
        for (size_t i = 0; i < n; ++i)
            if (!(std::fabs(a[i] - b[i]) <= same_within)) return false;
        return true;
    };
    constexpr size_t numbers = sizeof(math::Affine) / sizeof(float);
    return near(reinterpret_cast<const float *>(start.data()), reinterpret_cast<const float *>(end.begin()),
                numbers * start.size()) &&
           near(start_weights.data(), space.weights().begin(), start_weights.size());
}

// Key-poses a second of each clip.
double rate_of(const model::Template &tmpl, float rate_hz)
{
    double seconds = 0;
    for (const model::Clip &clip : tmpl.rig.clips) seconds += double(clip.duration_s);
    return seconds * double(rate_hz) > KeyPoseTable::max_intervals ? KeyPoseTable::max_intervals / seconds
                                                                   : double(rate_hz);
}

}  // namespace

KeyPoseMode KeyPoseSettings::mode_at(float distance) const
{
    KeyPoseMode mode = KeyPoseMode::individual;
    for (uint32_t i = 0; i < band_count && bands[i].distance <= distance; ++i) mode = bands[i].mode;
    return mode;
}

bool KeyPoseSettings::any() const
{
    return std::any_of(bands, bands + band_count, [](const KeyPoseBand &b) { return shows_key_poses(b.mode); });
}

bool KeyPoseSettings::interpolates() const
{
    return std::any_of(bands, bands + band_count,
                       [](const KeyPoseBand &b) { return b.mode == KeyPoseMode::interpolated; });
}

KeyPoseTable::KeyPoseTable(std::pmr::memory_resource *memory, const model::Template &tmpl, float rate_hz)
    : rows_(memory), sample_times_(memory)
{
    const double rate = rate_of(tmpl, rate_hz);
    for (uint32_t clip = 0; clip < tmpl.rig.clips.size(); ++clip) {
        const model::Clip &of = tmpl.rig.clips[clip];
        Row row;
        row.first = count();
        row.start_s = of.start_s;
        row.duration_s = of.duration_s;
        if (of.duration_s > 0) {
            row.intervals = static_cast<uint32_t>(std::max(1.0, std::round(double(of.duration_s) * rate)));
            row.closed = row.intervals > 1 && ends_as_it_begins(tmpl, clip);
        }
        const uint32_t poses = row.intervals + (row.closed ? 0 : 1);
        for (uint32_t k = 0; k < poses; ++k)
            sample_times_.push_back({clip, row.start_s + (row.intervals ? row.duration_s * k / row.intervals : 0)});
        rows_.push_back(row);
    }
}

KeyPoseSelection KeyPoseTable::select(KeyPoseMode mode, uint32_t clip, double time_s) const
{
    const Row &row = rows_[clip];
    KeyPoseSelection selection;
    selection.mode = mode;
    selection.first = selection.second = row.first;
    selection.time_s[0] = selection.time_s[1] = row.start_s;
    if (row.intervals == 0) return selection;
    const double at = std::clamp((time_s - row.start_s) / row.duration_s, 0.0, 1.0) * row.intervals;
    const auto choose = [&](int which, uint32_t k) {
        if (row.closed && k == row.intervals) k = 0;
        (which == 0 ? selection.first : selection.second) = row.first + k;
        selection.time_s[which] = sample_times_[row.first + k].time_s;
    };
    if (mode == KeyPoseMode::intermittent) {
        const uint32_t nearest = static_cast<uint32_t>(std::floor(at + 0.5));
        choose(0, nearest);
        choose(1, nearest);
        return selection;
    }
    const uint32_t before = std::min(static_cast<uint32_t>(at), row.intervals - 1);
    choose(0, before);
    choose(1, before + 1);
    selection.blend = static_cast<float>(at - before);
    return selection;
}

}  // namespace claque::animcache
