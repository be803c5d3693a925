#include "lib/crowd/gait.h"

#include <cmath>

#include "lib/base/error.h"

namespace claque::crowd
{

namespace
{

double per_second(const model::Clip &clip)
{
    return clip.duration_s > 0 ? 1 / static_cast<double>(clip.duration_s) : 0;
}

double in_clip(const model::Clip &clip, const Array<double> &sync, double rounds)
{
    double p = rounds - std::floor(rounds);
    if (!(p < 1)) p = 0;  // NaN: starts at the beginning
    const size_t count = sync.size();
    if (count > 0) {
        const double at = p * static_cast<double>(count);
        size_t k = static_cast<size_t>(at);
        if (k >= count) k = count - 1;
        const double next = k + 1 < count ? sync[k + 1] : sync[0] + 1;
        p = sync[k] + (at - static_cast<double>(k)) * (next - sync[k]);
        if (p >= 1) p -= 1;
    }
    return static_cast<double>(clip.start_s) + p * static_cast<double>(clip.duration_s);
}

const model::Clip &clip_of(const Gait &gait, uint32_t clip) { return gait.tmpl->rig.clips[clip]; }

}  // namespace

void check_gait(const Gait &gait)
{
    using base::fail;
    for (const uint32_t clip : {gait.clip_a, gait.clip_b}) {
        if (clip >= gait.tmpl->rig.clips.size())
            fail(CLQ_ARGUMENT, "a gait has clip %u, which does not exist: there are %zu in template '%s'", clip,
                 gait.tmpl->rig.clips.size(), gait.tmpl->name.c_str());
        if (!(clip_of(gait, clip).duration_s > 0)) fail(CLQ_ARGUMENT, "a gait has clip %u, which has no length", clip);
    }
    if (gait.sync_a.size() != gait.sync_b.size())
        fail(CLQ_ARGUMENT, "a gait with %zu and %zu times that belong together", gait.sync_a.size(),
             gait.sync_b.size());
    for (const Array<double> *sync : {&gait.sync_a, &gait.sync_b})
        for (size_t k = 0; k < sync->size(); ++k) {
            const double at = (*sync)[k], before = k > 0 ? (*sync)[k - 1] : -1.0;
            if (!(at >= 0 && at < 1 && at > before))
                fail(CLQ_ARGUMENT,
                     "moment %zu of a gait is at %g of the cycle, that before it at %g: 0 to below 1 is "
                     "wanted, ascending",
                     k, at, before);
        }
}

double smooth_step(double t_s, double length_s) noexcept
{
    if (!(t_s > 0)) return 0;
    if (t_s >= length_s) return 1;
    const double x = t_s / length_s;
    return x * x * (3 - 2 * x);
}

double smooth_sum(double t_s, double length_s) noexcept
{
    if (!(t_s > 0)) return 0;
    if (t_s >= length_s) return 0.5 * length_s + (t_s - length_s);
    const double x = t_s / length_s;
    return length_s * x * x * x * (1 - 0.5 * x);
}

Pace pace_of(const Gait &gait, float speed) noexcept
{
    const double s = static_cast<double>(speed);
    return {s * per_second(clip_of(gait, gait.clip_a)), s * per_second(clip_of(gait, gait.clip_b))};
}

float share_at(const Source &source, double time_s) noexcept
{
    const double x = smooth_step(time_s - source.change_s, static_cast<double>(source.change_length_s));
    const double from = static_cast<double>(source.share_from), to = static_cast<double>(source.share);
    return static_cast<float>(from + (to - from) * x);
}

double rounds_at(const Gait &gait, const Source &source, double time_s) noexcept
{
    const Pace pace = pace_of(gait, source.play.speed);
    const double gone = time_s - source.change_s, before = static_cast<double>(source.share_from);
    const double more = static_cast<double>(source.share) - before;
    const double length = static_cast<double>(source.change_length_s);
    return source.change_rounds + gone * (pace.a + (pace.b - pace.a) * before) +
           (pace.b - pace.a) * more * smooth_sum(gone, length);
}

double time_in_a(const Gait &gait, double rounds) noexcept
{
    return in_clip(clip_of(gait, gait.clip_a), gait.sync_a, rounds);
}

double time_in_b(const Gait &gait, double rounds) noexcept
{
    return in_clip(clip_of(gait, gait.clip_b), gait.sync_b, rounds);
}

double share_of_a(const Gait &gait, double clip_time_s) noexcept
{
    const model::Clip &clip = clip_of(gait, gait.clip_a);
    double p = clip.duration_s > 0
                   ? (clip_time_s - static_cast<double>(clip.start_s)) / static_cast<double>(clip.duration_s)
                   : 0;
    p -= std::floor(p);
    const Array<double> &sync = gait.sync_a;
    if (sync.empty()) return p;
    if (p < sync[0]) p += 1;
    size_t k = 0;
    while (k + 1 < sync.size() && sync[k + 1] <= p) ++k;
    const double next = k + 1 < sync.size() ? sync[k + 1] : sync[0] + 1;
    const double share = (static_cast<double>(k) + (p - sync[k]) / (next - sync[k])) / static_cast<double>(sync.size());
    return share < 1 ? share : 0;
}

}  // namespace claque::crowd
