#include "meshsplit/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "meshsplit/motion_error.h"
#include "meshsplit/motion_plan.h"

namespace claque::meshsplit
{

namespace
{

// The rates that are tried, besides those of a clip's own keys.
constexpr double rates_hz[] = {10, 12.5, 15, 20, 25, 30, 50, 60, 100, 120};
constexpr double highest_key_rate_hz = 250;
// The limit of a template's rows in bytes; further clips keep their channels.
constexpr size_t max_numbers = size_t(1) << 29;

// The lengths of the arrays, to remove a clip again.
struct Lengths {
    size_t clips, blocks, curves, exact, rotations, numbers;

    explicit Lengths(const model::Motion &m)
        : clips(m.clips.size()),
          blocks(m.blocks.size()),
          curves(m.curves.size()),
          exact(m.exact.size()),
          rotations(m.rotations.size()),
          numbers(m.numbers.size())
    {
    }
    void cut(model::Motion &m) const
    {
        m.clips.resize(clips), m.blocks.resize(blocks), m.curves.resize(curves), m.exact.resize(exact);
        m.rotations.resize(rotations), m.numbers.resize(numbers);
    }
};

class ClipFitter
{
public:
    ClipFitter(model::Template &tmpl, MotionMeter &meter, const MotionLimits &limits, uint32_t clip,
               const MotionError &maximum)
        : tmpl_(tmpl),
          meter_(meter),
          limits_(limits),
          index_(clip),
          clip_(tmpl.rig.clips[clip]),
          maximum_(maximum),
          before_(tmpl.motion),
          kept_(clip_.channel_count)
    {
        for (uint32_t i = 0; i < clip_.channel_count; ++i) {
            const model::Channel &channel = tmpl.rig.channels[clip_.first_channel + i];
            kept_[i] = channel.interpolation == model::Interpolation::step && channel.key_count > 1;
        }
        times_ = key_times();
    }

    void run()
    {
        const std::vector<uint32_t> counts = interval_counts();
        // If no rate fits, channels with a large error at the highest rate are kept, then also those with smaller
        // errors.
        MotionError outliers = maximum_;
        for (int attempt = 0; attempt < 4 && !counts.empty(); ++attempt) {
            for (const uint32_t count : counts) {
                if (!can_afford(count)) return keep_all();
                if (fits(count)) return;
            }
            keep_outliers(counts.back(), outliers);
            outliers.metres /= 4, outliers.radians /= 4;
        }
        keep_all();
    }

private:
    // Kept channels are exact, and nodes without channels rest, so a few times show what rounding does.
    void keep_all()
    {
        std::fill(kept_.begin(), kept_.end(), uint8_t(1));
        put(0);
        meter_.begin();
        const bool all = can_evaluate(times_.size());
        const std::vector<double> few = {times_.front(), times_[times_.size() / 2], times_.back()};
        error_of_clip() = meter_.measure(index_, all ? times_ : few, maximum());
        meter_.accept();
        if (!all) meter_.accept_reach_of(index_);
    }

    bool can_evaluate(uint64_t poses) const
    {
        return meter_.evaluated() + poses * meter_.pose_transforms(index_) <= limits_.transforms;
    }

    // Whether this many rows may be made and measured.
    bool can_afford(uint64_t count) const
    {
        const model::Motion &motion = tmpl_.motion;
        const uint64_t held = 3 * (2ull * before_.rotations + 2ull * before_.numbers);
        return held + clip_bytes(tmpl_.rig, static_cast<uint32_t>(count), motion) <= limits_.bytes &&
               can_evaluate(3 * count + times_.size());
    }

    static MotionError maximum()
    {
        return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    }

    // Returns the key times of all channels that rows must follow, and both ends.
    std::vector<double> key_times() const
    {
        std::vector<double> out = {double(clip_.start_s), double(clip_.start_s) + double(clip_.duration_s)};
        for (uint32_t i = 0; i < clip_.channel_count; ++i) {
            const model::Channel &channel = tmpl_.rig.channels[clip_.first_channel + i];
            const float *first = tmpl_.rig.times.data() + channel.first_time;
            if (!kept_[i]) out.insert(out.end(), first, first + channel.key_count);
        }
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        return out;
    }

    struct ErrorOfClip {
        model::MotionClip &clip;
        void operator=(const MotionError &error)
        {
            // Rounded up, so that the stated error is a bound.
            clip.error_m = std::nextafter(float(error.metres), std::numeric_limits<float>::infinity());
            clip.error_rad = std::nextafter(float(error.radians), std::numeric_limits<float>::infinity());
        }
    };
    ErrorOfClip error_of_clip() { return {tmpl_.motion.clips.back()}; }

    // Returns the row counts to try, ascending; none if there is nothing to sample.
    std::vector<uint32_t> interval_counts() const
    {
        const double length = double(clip_.duration_s);
        if (!(length > 0)) return {0};
        std::vector<double> counts;
        for (const double rate : rates_hz) counts.push_back(std::ceil(length * rate - 1e-3));
        for (uint32_t i = 0; i < clip_.channel_count; ++i) {
            const uint32_t keys = tmpl_.rig.channels[clip_.first_channel + i].key_count;
            if (keys > 1 && keys - 1 <= length * highest_key_rate_hz) counts.push_back(keys - 1);
        }
        std::vector<uint32_t> out;
        for (const double count : counts)
            if (count <= model::max_motion_intervals) out.push_back(std::max(1u, static_cast<uint32_t>(count)));
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        return out;
    }

    void put(uint32_t intervals)
    {
        before_.cut(tmpl_.motion);
        append_clip(tmpl_.rig, index_, intervals, kept_, tmpl_.motion);
        meter_.count((intervals + 1ull) * meter_.pose_transforms(index_) / 2);
    }

    void keep_outliers(uint32_t intervals, const MotionError &outliers)
    {
        put(intervals);
        const std::vector<uint8_t> found = meter_.outliers(index_, times_, outliers);
        for (size_t i = 0; i < kept_.size(); ++i) kept_[i] |= found[i];
    }

    bool fits(uint32_t intervals)
    {
        put(intervals);
        if (tmpl_.motion.rotations.size() > max_numbers || tmpl_.motion.numbers.size() > max_numbers) return false;
        meter_.begin();
        MotionError worst = meter_.measure(index_, times_, maximum_);
        if (!worst.within(maximum_)) return false;
        worst.merge(meter_.measure(index_, between_rows(intervals), maximum_));
        if (!worst.within(maximum_)) return false;
        error_of_clip() = worst;
        meter_.accept();
        return true;
    }

    // Where straight lines are farthest from curves, and where a chord's timing differs most from the arc's.
    std::vector<double> between_rows(uint32_t intervals) const
    {
        std::vector<double> out;
        for (uint32_t i = 0; i < intervals; ++i)
            for (const double part : {0.21, 0.5})
                out.push_back(double(clip_.start_s) + double(clip_.duration_s) * (i + part) / intervals);
        return out;
    }

    model::Template &tmpl_;
    MotionMeter &meter_;
    const MotionLimits &limits_;
    const uint32_t index_;
    const model::Clip &clip_;
    const MotionError maximum_;
    const Lengths before_;
    std::vector<uint8_t> kept_;
    std::vector<double> times_;
};

// Whether every clip can have its places, and be measured a few times.
bool can_have_motion(const model::Template &tmpl, const MotionLimits &limits)
{
    const uint64_t clips = tmpl.rig.clips.size();
    return place_bytes(tmpl.motion) <= limits.bytes / 4 / clips &&
           8ull * tmpl.rig.node_count() <= limits.transforms / clips;
}

}  // namespace

float make_motion(const MotionTolerance &tolerance, model::Template &out, const MotionLimits &limits)
{
    if (out.rig.clips.empty() || tolerance.metres == 0) return 0;
    plan_joints(out.rig, out.motion);
    if (!can_have_motion(out, limits)) {
        out.motion.nodes.clear(), out.motion.groups.clear();
        return 0;
    }
    model::derive(out.rig, out.motion);
    MotionMeter meter(out);
    const double metres = tolerance.metres > 0 ? double(tolerance.metres) : meter.rest_size() / 2000;
    for (uint32_t c = 0; c < out.rig.clips.size(); ++c)
        ClipFitter(out, meter, limits, c, {metres, double(tolerance.radians)}).run();
    return static_cast<float>(meter.bound() * 1.25);
}

void inflate(float more, model::Template &out)
{
    out.sklsroot.radius += more;
    for (model::NodeReach &reach : out.node_reach) reach.distance += more;
    // An additive layer adds the difference of two poses, so the error counts twice.
    out.blend_radius.base += more, out.blend_radius.per_weight += 2 * more;
    for (model::BlendReach &reach : out.blend_reach) reach.distance.base += more, reach.distance.per_weight += 2 * more;
}

}  // namespace claque::meshsplit
