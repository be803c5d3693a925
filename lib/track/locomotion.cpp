#include "lib/track/locomotion.h"

#include <cmath>

namespace claque::track
{

namespace
{

double part_of_cycle(double phase)
{
    const double part = phase - std::floor(phase);
    return part < 1 ? part : 0;  // also for what is not a number
}

double clip_time(const model::Rig &rig, uint32_t clip, double phase)
{
    if (clip == model::none) return 0;
    const model::Clip &of = rig.clips[clip];
    return double(of.start_s) + part_of_cycle(phase) * double(of.duration_s);
}

double mix(double a, double b, double part) { return a + (b - a) * part; }

// The measured steps on both sides of a gait.
uint32_t step_below(double gait, double &part)
{
    uint32_t step = 0;
    while (step + 2 < gait_step_count && gait >= double(gait_steps[step + 1])) ++step;
    const double from = double(gait_steps[step]), to = double(gait_steps[step + 1]);
    part = (gait - from) / (to - from);
    part = part > 0 ? part < 1 ? part : 1 : 0;
    return step;
}

GaitCell mix(const GaitCell &a, const GaitCell &b, double part)
{
    const auto both = [part](float x, float y) { return static_cast<float>(mix(double(x), double(y), part)); };
    GaitCell out;
    out.advance = both(a.advance, b.advance);
    for (int f = 0; f < 2; ++f) {
        out.x[f] = both(a.x[f], b.x[f]), out.z[f] = both(a.z[f], b.z[f]);
        out.yaw[f] = both(a.yaw[f], b.yaw[f]);
        out.supports[f] = both(a.supports[f], b.supports[f]);
        out.reach[f] = both(a.reach[f], b.reach[f]);
        out.hip_x[f] = both(a.hip_x[f], b.hip_x[f]), out.hip_z[f] = both(a.hip_z[f], b.hip_z[f]);
        out.node_x[f] = both(a.node_x[f], b.node_x[f]), out.node_z[f] = both(a.node_z[f], b.node_z[f]);
    }
    return out;
}

}  // namespace

uint32_t layers_of(const Locomotion &locomotion, float gait, float turn, double phase, uint32_t idle, double idle_s,
                   pose::Layer out[3]) noexcept
{
    const model::Rig &rig = locomotion.tmpl->rig;
    const LocomotionClips &clips = locomotion.clips;
    const bool slows = clips.slow != model::none;
    uint32_t count = 0;
    const auto push = [&](uint32_t clip, double time_s, float weight) {
        out[count] = pose::Layer();
        out[count].clip = clip, out[count].time_s = time_s, out[count].weight = weight;
        ++count;
    };
    if (gait < (slows ? slow_gait : 1.0f)) {
        const uint32_t clip = clips.idle_count > 0 ? clips.idles[idle < clips.idle_count ? idle : 0] : model::none;
        const double length = clip == model::none ? 0 : double(rig.clips[clip].duration_s);
        push(clip, clip_time(rig, clip, length > 0 ? idle_s / length : 0), 1);
    }
    if (slows && gait > 0 && gait < 1)
        push(clips.slow, clip_time(rig, clips.slow, phase + double(locomotion.slow_phase)),
             gait < slow_gait ? gait / slow_gait : 1);
    const float walks = !slows ? gait : gait > slow_gait ? (gait - slow_gait) / (1 - slow_gait) : 0;
    if (walks > 0) push(clips.walk, clip_time(rig, clips.walk, phase), walks < 1 ? walks : 1);
    if (gait > 1 && clips.run != model::none)
        push(clips.run, clip_time(rig, clips.run, phase + double(locomotion.run_phase)), gait - 1);
    if (turn > 0 && clips.turn != model::none)
        push(clips.turn, clip_time(rig, clips.turn, phase + double(locomotion.turn_phase)), turn);
    return count;
}

GaitCell cell_at(const Locomotion &locomotion, double gait, double turn, double phase) noexcept
{
    double by_gait = 0;
    const uint32_t step = step_below(gait, by_gait);
    const double at = part_of_cycle(phase) * phase_count;
    uint32_t first = static_cast<uint32_t>(at);
    if (first >= phase_count) first = phase_count - 1;
    const uint32_t next = first + 1 < phase_count ? first + 1 : 0;
    const double part = at - first;
    const GaitCell on_axis = mix(mix(locomotion.cell(step, first), locomotion.cell(step, next), part),
                                 mix(locomotion.cell(step + 1, first), locomotion.cell(step + 1, next), part), by_gait);
    if (!(turn > 0) || locomotion.turn_cells.empty()) return on_axis;
    return mix(on_axis, mix(locomotion.turn_cells[first], locomotion.turn_cells[next], part), turn < 1 ? turn : 1);
}

double cycle_s_at(const Locomotion &locomotion, double gait) noexcept
{
    double part = 0;
    const uint32_t step = step_below(gait, part);
    return mix(double(locomotion.cycle_s[step]), double(locomotion.cycle_s[step + 1]), part);
}

}  // namespace claque::track
