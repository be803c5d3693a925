#include "lib/api/behave_def.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "lib/api/boundary.h"

namespace claque::api
{

using base::fail;

namespace
{

// Finite and within [low, high].
void require_in(const char *name, float value, float low, float high)
{
    if (std::isfinite(value) && value >= low && value <= high) return;
    if (high < crowd::never)
        fail(CLQ_ARGUMENT, "%s is %g: %g to %g is wanted", name, double(value), double(low), double(high));
    fail(CLQ_ARGUMENT, "%s is %g: a finite number of at least %g is wanted", name, double(value), double(low));
}

void require_more(const char *name, float value, float than)
{
    if (!std::isfinite(value) || !(value > than))
        fail(CLQ_ARGUMENT, "%s is %g: a finite number of more than %g is wanted", name, double(value), double(than));
}

// Copies what a def says about the degrees of freedom of one template.
class Reader
{
public:
    Reader(const model::Template &tmpl, std::pmr::memory_resource *memory, model::Array<uint32_t> &written)
        : tmpl_(tmpl), memory_(memory), written_(written), named_(memory)
    {
    }

    crowd::Gaze gaze(const clq_gaze_def &def);
    crowd::Expression expression(const clq_expression_def &def);
    crowd::Blink blink(const clq_blink_def &def);
    crowd::Phrase phrase(const clq_phrase_def &def);
    crowd::Idle idle(const clq_idle_def &def);

private:
    uint32_t turn(const char *name, uint32_t dof);
    void read_pose(const clq_dof_pose &pose, uint32_t index, model::Array<crowd::DofValue> &values);
    void read_poses(uint32_t count, const clq_dof_pose *from, model::Array<crowd::DofPose> &to,
                    model::Array<crowd::DofValue> &values);
    // Returns whether a pose of this number named it before.
    bool writes(uint32_t dof, uint32_t pose)
    {
        const auto [last, is_new] = named_.try_emplace(dof, pose);
        if (is_new) written_.push_back(dof);
        return !is_new && std::exchange(last->second, pose) == pose;
    }

    const model::Template &tmpl_;
    std::pmr::memory_resource *memory_;
    model::Array<uint32_t> &written_;
    std::pmr::map<uint32_t, uint32_t> named_;  // what is written, and the last pose that did; ordered: never slow
};

uint32_t Reader::turn(const char *name, uint32_t dof)
{
    if (dof == CLQ_NONE) return model::none;
    const model::Rig &rig = tmpl_.rig;
    if (dof >= rig.dofs.size())
        fail(CLQ_ARGUMENT, "%s is degree of freedom %u, which does not exist: there are %zu in template '%s'", name,
             dof, rig.dofs.size(), tmpl_.name.c_str());
    if (rig.dofs[dof].kind != model::DofKind::rotation)
        fail(CLQ_ARGUMENT, "%s is degree of freedom %u '%s', which is no rotation", name, dof,
             rig.dof_names[dof].c_str());
    writes(dof, model::none);
    return dof;
}

void Reader::read_pose(const clq_dof_pose &pose, uint32_t index, model::Array<crowd::DofValue> &values)
{
    const model::Rig &rig = tmpl_.rig;
    if (pose.count && !pose.values)
        fail(CLQ_ARGUMENT, "the values of pose %u are NULL with a count of %u", index, pose.count);
    for (uint32_t i = 0; i < pose.count; ++i) {
        const clq_dof_value &value = pose.values[i];
        if (value.dof >= rig.dofs.size())
            fail(CLQ_ARGUMENT,
                 "pose %u names degree of freedom %u, which does not exist: there are %zu in template '%s'", index,
                 value.dof, rig.dofs.size(), tmpl_.name.c_str());
        const model::Dof &dof = rig.dofs[value.dof];
        const char *name = rig.dof_names[value.dof].c_str();
        if (!(value.value >= dof.min && value.value <= dof.max))
            fail(CLQ_ARGUMENT, "pose %u puts degree of freedom %u '%s' at %g: its range is %g to %g", index, value.dof,
                 name, double(value.value), double(dof.min), double(dof.max));
        if (writes(value.dof, index))
            fail(CLQ_ARGUMENT, "pose %u names degree of freedom %u '%s' twice", index, value.dof, name);
        values.push_back({value.dof, value.value});
    }
}

void Reader::read_poses(uint32_t count, const clq_dof_pose *from, model::Array<crowd::DofPose> &to,
                        model::Array<crowd::DofValue> &values)
{
    if (count == 0) fail(CLQ_ARGUMENT, "pose_count is 0: at least 1 is wanted");
    require_array(from, count, "poses");
    for (uint32_t i = 0; i < count; ++i) {
        const uint32_t first = static_cast<uint32_t>(values.size());
        read_pose(from[i], i, values);
        to.push_back({first, from[i].count});
    }
    if (values.empty()) fail(CLQ_ARGUMENT, "none of %u poses names a degree of freedom", count);
}

crowd::Gaze Reader::gaze(const clq_gaze_def &def)
{
    crowd::Gaze out;
    for (int k = 0; k < 2; ++k) {
        out.eye_yaw[k] = turn("eye_yaw", def.eye_yaw[k]);
        out.eye_pitch[k] = turn("eye_pitch", def.eye_pitch[k]);
    }
    out.neck_yaw = turn("neck_yaw", def.neck_yaw), out.neck_pitch = turn("neck_pitch", def.neck_pitch);
    out.spine_yaw = turn("spine_yaw", def.spine_yaw), out.spine_pitch = turn("spine_pitch", def.spine_pitch);
    if (written_.empty()) fail(CLQ_ARGUMENT, "the gaze names no degree of freedom");
    require_in("neck_share", def.neck_share, 0, 1);
    require_in("spine_share", def.spine_share, 0, 1);
    for (int k = 0; k < 3; ++k)
        if (!std::isfinite(def.eyes[k])) fail(CLQ_ARGUMENT, "coordinate %d of eyes is not finite", k);
    require_in("turn_s", def.turn_s, 0, crowd::never);
    require_in("wander_s", def.wander_s, 0, crowd::never);
    constexpr float half_turn = 3.1415927f;
    require_in("wander_yaw_rad", def.wander_yaw_rad, 0, half_turn);
    require_in("wander_pitch_rad", def.wander_pitch_rad, 0, half_turn);
    out.neck_share = def.neck_share, out.spine_share = def.spine_share;
    out.eyes = glm::vec3(def.eyes[0], def.eyes[1], def.eyes[2]);
    out.turn_s = def.turn_s, out.wander_s = def.wander_s;
    out.wander_yaw = def.wander_yaw_rad, out.wander_pitch = def.wander_pitch_rad;
    return out;
}

crowd::Expression Reader::expression(const clq_expression_def &def)
{
    crowd::Expression out(memory_);
    read_poses(def.pose_count, def.poses, out.poses, out.values);
    require_more("hold_s", def.hold_s, 0);
    require_in("blend_s", def.blend_s, 0, def.hold_s / 2);
    out.hold_s = def.hold_s, out.blend_s = def.blend_s;
    return out;
}

crowd::Blink Reader::blink(const clq_blink_def &def)
{
    crowd::Blink out(memory_);
    if (def.closed.count == 0) fail(CLQ_ARGUMENT, "the pose of closed lids names no degree of freedom");
    read_pose(def.closed, 0, out.closed);
    require_more("close_s", def.close_s, 0);
    require_more("period_s", def.period_s, def.close_s);
    out.period_s = def.period_s, out.close_s = def.close_s;
    return out;
}

crowd::Phrase Reader::phrase(const clq_phrase_def &def)
{
    crowd::Phrase out(memory_);
    read_poses(def.pose_count, def.poses, out.poses, out.values);
    if (def.key_count == 0) fail(CLQ_ARGUMENT, "key_count is 0: at least 1 is wanted");
    require_array(def.keys, def.key_count, "keys");
    for (uint32_t i = 0; i < def.key_count; ++i) {
        const clq_phrase_key &key = def.keys[i];
        const bool ascends = i == 0 ? key.time_s == 0 : key.time_s > def.keys[i - 1].time_s;
        if (!ascends || !std::isfinite(key.time_s))
            fail(CLQ_ARGUMENT, "key %u of the phrase is at %g s: they ascend from 0", i, double(key.time_s));
        if (key.pose != CLQ_NONE && key.pose >= def.pose_count)
            fail(CLQ_ARGUMENT, "key %u of the phrase names pose %u, which does not exist: there are %u", i, key.pose,
                 def.pose_count);
        out.keys.push_back({key.time_s, key.pose == CLQ_NONE ? model::none : key.pose});
    }
    require_more("length_s", def.length_s, 0);
    require_in("length_s", def.length_s, def.keys[def.key_count - 1].time_s, crowd::never);
    if (!std::isfinite(def.pause_s)) fail(CLQ_ARGUMENT, "pause_s is not finite");
    require_in("blend_s", def.blend_s, 0, crowd::never);
    out.length_s = def.length_s, out.pause_s = def.pause_s, out.blend_s = def.blend_s;
    return out;
}

crowd::Idle Reader::idle(const clq_idle_def &def)
{
    crowd::Idle out(memory_);
    if (def.clip_count == 0) fail(CLQ_ARGUMENT, "clip_count is 0: at least 1 is wanted");
    require_array(def.clips, def.clip_count, "clips");
    for (uint32_t i = 0; i < def.clip_count; ++i) {
        if (def.clips[i] >= tmpl_.rig.clips.size())
            fail(CLQ_ARGUMENT, "clip %u does not exist: there are %zu in template '%s'", def.clips[i],
                 tmpl_.rig.clips.size(), tmpl_.name.c_str());
        out.clips.push_back(def.clips[i]);
    }
    require_more("slot_s", def.slot_s, 0);
    out.slot_s = def.slot_s;
    require_in("fade_s", def.fade_s, 0, def.slot_s);
    require_in("speed_spread", def.speed_spread, 0, 0.999999f);
    require_in("phase_spread", def.phase_spread, 0, 1);
    out.fade_s = def.fade_s, out.speed_spread = def.speed_spread, out.phase_spread = def.phase_spread;
    if (!def.weights) return out;
    float maximum = 0;
    for (uint32_t i = 0; i < def.clip_count; ++i) {
        require_in("a clip's weight", def.weights[i], 0, std::numeric_limits<float>::max());
        maximum = std::max(maximum, def.weights[i]);
        out.weights.push_back(def.weights[i]);
    }
    if (!(maximum > 0)) fail(CLQ_ARGUMENT, "the weights of all %u clips are 0", def.clip_count);
    return out;
}

crowd::HostMechanism host_of(const clq_mechanism_def &def)
{
    if (!def.host.run) fail(CLQ_ARGUMENT, "run of the host's mechanism is NULL");
    if (def.host.has_memory && def.off_m != 0)
        fail(CLQ_ARGUMENT, "off_m is %g: a mechanism that keeps a memory is never off", double(def.off_m));
    return {def.host.run, def.host.user, def.host.has_memory};
}

void take_levels(const clq_mechanism_def &def, crowd::Mechanism &out)
{
    float last = 0;
    bool ended = false;
    for (uint32_t k = 0; k < crowd::max_behaviour_levels - 1; ++k) {
        const float at = def.level_m[k];
        if (at == 0) {
            ended = true;
            continue;
        }
        if (!std::isfinite(at) || !(at > last) || ended)
            fail(CLQ_ARGUMENT, "level_m[%u] is %g: they ascend, all after a 0 are 0", k, double(at));
        out.level_m[k] = last = at;
    }
    require_in("off_m", def.off_m, 0, crowd::never);
    if (def.off_m > 0) out.off_m = def.off_m;
}

}  // namespace

crowd::Mechanism mechanism_of(const clq_mechanism_def &def, const model::Template &tmpl,
                              std::pmr::memory_resource *memory, model::Array<uint32_t> &written)
{
    crowd::Mechanism out;
    out.tmpl = &tmpl;
    take_levels(def, out);
    Reader reader(tmpl, memory, written);
    switch (number_of(def.kind)) {
        case CLQ_MECHANISM_GAZE:
            out.kind = reader.gaze(def.gaze);
            break;
        case CLQ_MECHANISM_EXPRESSION:
            out.kind = reader.expression(def.expression);
            break;
        case CLQ_MECHANISM_BLINK:
            out.kind = reader.blink(def.blink);
            break;
        case CLQ_MECHANISM_PHRASE:
            out.kind = reader.phrase(def.phrase);
            break;
        case CLQ_MECHANISM_IDLE:
            out.kind = reader.idle(def.idle);
            break;
        case CLQ_MECHANISM_HOST:
            out.kind = host_of(def);
            break;
        default:
            fail(CLQ_ARGUMENT, "kind is %u: none of clq_mechanism_kind", number_of(def.kind));
    }
    return out;
}

}  // namespace claque::api
