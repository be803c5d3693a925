#include "lib/track/clip_checks.h"

#include <cmath>

#include "lib/base/error.h"
#include "lib/math/trig.h"
#include "lib/pose/facing_in_clips.h"

namespace claque::track
{

using base::fail;
using model::none;

namespace
{

// Clips without an option are found by their names.
constexpr char name_another[] =
    "name another one (--walk of the command, clips of a scenario's class, clq_locomotion_def)";

// Whether options turned the character: a node without a name is then above all others.
bool is_turned(const model::Rig &rig)
{
    return rig.node_count() > 1 && rig.node_names[0].empty() && rig.rest[0].rotation.w < 0.9999f;
}

}  // namespace

const char *clip_name(const model::Rig &rig, uint32_t clip)
{
    return clip < rig.clip_names.size() ? rig.clip_names[clip].c_str() : "";
}

void check_clips(const model::Template &tmpl, const LocomotionClips &clips)
{
    const model::Rig &rig = tmpl.rig;
    const size_t count = rig.clips.size();
    const auto check = [&](const char *what, uint32_t clip, bool must_move) {
        if (clip >= count)
            fail(CLQ_ARGUMENT, "the %s is clip %u of %zu of template '%s'", what, clip, count, tmpl.name.c_str());
        if (must_move && !(rig.clips[clip].duration_s > 0))
            fail(CLQ_ARGUMENT, "the %s is clip %u ('%s'), which has no length: %s", what, clip, clip_name(rig, clip),
                 name_another);
    };
    check("walk", clips.walk, true);
    if (clips.run != none) check("run", clips.run, true);
    if (clips.slow != none) check("slow walk", clips.slow, true);
    if (clips.turn != none) check("turn", clips.turn, true);
    if (clips.idle_count > max_idles)
        fail(CLQ_ARGUMENT, "%u clips to stand with: at most %u are possible", clips.idle_count, max_idles);
    for (uint32_t i = 0; i < clips.idle_count; ++i) check("standing clip", clips.idles[i], false);
}

uint32_t clip_of_step(const LocomotionClips &clips, uint32_t step)
{
    if (step > walk_step && clips.run != none) return clips.run;
    return step <= slow_step && clips.slow != none ? clips.slow : clips.walk;
}

bool is_of_one_clip(const LocomotionClips &clips, uint32_t step)
{
    return step == walk_step || (step + 1 == gait_step_count && clips.run != none) ||
           (step == slow_step && clips.slow != none);
}

void check_direction(const model::Template &tmpl, uint32_t clip, double x, double z)
{
    const double length = std::sqrt(x * x + z * z);
    if (!(length > 0.1) || z < -0.5 * length) return;  // up to 60 degrees aside
    const double goes_deg = math::atan2(-x, -z) * 180 / math::pi;
    model::Facing facing = pose::facing_in(tmpl.rig, &tmpl.motion, clip);
    if (facing.is_elsewhere()) facing = pose::facing_in_clips(tmpl.rig);  // the clip may turn a character that faces +z
    const char *name = clip_name(tmpl.rig, clip), *way = z > 0.5 * length ? "forward" : "sideways";
    const double turn = model::turn_to_front_deg(goes_deg);
    if (facing.seen && !facing.is_elsewhere())
        fail(CLQ_ARGUMENT,
             "the feet of clip %u ('%s') of template '%s' move %s at stance, and its %s say that it faces +z: the clip "
             "walks %s; %s",
             clip, name, tmpl.name.c_str(), way, facing.seen, z > 0.5 * length ? "backwards" : "aside", name_another);
    const std::string remedy = is_turned(tmpl.rig) ? base::text_of("%g degrees more of turn_deg (--turn) turn it", turn)
                                                   : base::text_of("turn_deg %g (--turn %g) turns it", turn, turn);
    fail(CLQ_ARGUMENT, "the feet of clip %u ('%s') of template '%s' move %s at stance: the character faces %s; %s",
         clip, name, tmpl.name.c_str(), way, model::axis_of(goes_deg), remedy.c_str());
}

void fail_to_walk(const model::Template &tmpl, const LocomotionClips &clips, uint32_t step)
{
    const uint32_t clip = clip_of_step(clips, step);
    const std::string not_walk =
        clip == clips.walk ? "" : base::text_of(", not clip %u ('%s'),", clips.walk, clip_name(tmpl.rig, clips.walk));
    fail(CLQ_ARGUMENT,
         "no foot of template '%s' moves back over the ground at gait %g: clip %u ('%s')%s does not %s; %s",
         tmpl.name.c_str(), double(gait_steps[step]), clip, clip_name(tmpl.rig, clip), not_walk.c_str(),
         step > walk_step && clip != clips.walk ? "run" : "walk", name_another);
}

void check_legs(const model::Template &tmpl, const LocomotionClips &clips)
{
    const model::Rig &rig = tmpl.rig;
    for (const auto &leg : clips.legs)
        for (int part = 0; part < 4; ++part) {
            const uint32_t node = leg[part];
            if (part == 3 && node == none) continue;
            if (node >= rig.node_count())
                fail(CLQ_ARGUMENT, "a leg of template '%s' has node %u of %u", tmpl.name.c_str(), node,
                     rig.node_count());
            if (part != 1 && part != 3) continue;
            uint32_t above = rig.parents[node];
            while (above != none && above != leg[part - 1]) above = rig.parents[above];
            if (above == none)
                fail(CLQ_ARGUMENT,
                     "node %u ('%s') of a leg of template '%s' is not below node %u ('%s'): a leg goes from thigh to "
                     "shin to foot (legs of a scenario's class, --legs of the command, clq_locomotion_def.legs)",
                     node, rig.node_names[node].c_str(), tmpl.name.c_str(), leg[part - 1],
                     rig.node_names[leg[part - 1]].c_str());
        }
}

void check_upper(const model::Template &tmpl, const LocomotionClips &clips)
{
    const model::Rig &rig = tmpl.rig;
    const char *names[] = {"torso", "neck", "head"};
    const uint32_t nodes[] = {clips.torso, clips.neck, clips.head};
    uint32_t above = none;  // the part below which the next one hangs
    for (int part = 0; part < 3; ++part) {
        if (nodes[part] == none) continue;
        if (nodes[part] >= rig.node_count())
            fail(CLQ_ARGUMENT, "the %s of template '%s' is node %u of %u", names[part], tmpl.name.c_str(), nodes[part],
                 rig.node_count());
        uint32_t node = rig.parents[nodes[part]];
        while (node != none && node != above) node = rig.parents[node];
        if (above != none && node == none)
            fail(CLQ_ARGUMENT, "the %s of template '%s', node %u ('%s'), is not below node %u ('%s')", names[part],
                 tmpl.name.c_str(), nodes[part], rig.node_names[nodes[part]].c_str(), above,
                 rig.node_names[above].c_str());
        above = nodes[part];
    }
}

void check_speeds(const model::Template &tmpl, const Locomotion &out)
{
    const LocomotionClips &clips = out.clips;
    const double speed = out.walking_speed();
    const auto name = [&](uint32_t clip) { return clip_name(tmpl.rig, clip); };
    if (!(out.stride[walk_step] > 0.1f * out.leg_length))
        fail(CLQ_ARGUMENT,
             "the feet of clip %u ('%s') of template '%s' move back by %.2g of a leg's length a cycle, as in a clip "
             "that "
             "stands: a walk in place is wanted; %s",
             clips.walk, name(clips.walk), tmpl.name.c_str(), double(out.stride[walk_step] / out.leg_length),
             name_another);
    if (clips.run != none && !(out.running_speed() > speed))
        fail(CLQ_ARGUMENT, "clip %u ('%s') runs at %g units a second, and clip %u ('%s') walks at %g; %s", clips.run,
             name(clips.run), out.running_speed(), clips.walk, name(clips.walk), speed, name_another);
    if (clips.slow != none && !(out.slow_speed() < speed))
        fail(CLQ_ARGUMENT, "clip %u ('%s') walks slowly at %g units a second, and clip %u ('%s') walks at %g; %s",
             clips.slow, name(clips.slow), out.slow_speed(), clips.walk, name(clips.walk), speed, name_another);
}

}  // namespace claque::track
