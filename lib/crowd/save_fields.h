// The fields of a saved crowd's structs in the order of the bytes: one list for writing and reading, so that the two
// cannot differ. Archives are those of lib/base/archive.h; structs are const when they are written.
#pragma once

#include "lib/crowd/crowd.h"

namespace claque::crowd
{

template <class Archive, class P>
void walk_transform(Archive &a, P &transform)
{
    for (int k = 0; k < 3; ++k) a.value(transform.position[k]);
    a.value(transform.orientation.x), a.value(transform.orientation.y), a.value(transform.orientation.z);
    a.value(transform.orientation.w), a.value(transform.scale);
}

template <class Archive, class P>
void walk_play(Archive &a, P &play)
{
    a.value(play.clip), a.value(play.start_s), a.value(play.speed), a.value(play.phase_s);
}

template <class Archive, class S>
void walk_source(Archive &a, S &source)
{
    walk_play(a, source.play);
    a.value(source.gait), a.value(source.share_from), a.value(source.share), a.value(source.change_length_s);
    a.value(source.change_s), a.value(source.change_rounds);
}

template <class Archive, class F>
void walk_fade(Archive &a, F &fade)
{
    walk_source(a, fade.from);
    a.value(fade.at_s), a.value(fade.length_s), a.value(fade.curve);
}

template <class Archive, class G>
void walk_layer(Archive &a, G &layer)
{
    a.value(layer.layer_id);
    walk_play(a, layer.play);
    a.flag(layer.additive);
    a.value(layer.reference_clip), a.value(layer.reference_time_s), a.value(layer.mask), a.value(layer.weight);
    a.value(layer.start_s), a.value(layer.end_s), a.value(layer.fade_in_s), a.value(layer.fade_out_s);
    a.value(layer.curve);
}

template <class Archive, class G>
void walk_gait(Archive &a, G &gait)
{
    a.value(gait.clip_a), a.value(gait.clip_b);
    a.array(gait.sync_a, 8, [&](auto &at) { a.value(at); });
    a.array(gait.sync_b, 8, [&](auto &at) { a.value(at); });
}

template <class Archive, class U>
void walk_mechanism_attachment(Archive &a, U &attachment)
{
    a.value(attachment.mechanism), a.value(attachment.priority), a.value(attachment.phase_s),
        a.value(attachment.start_s);
}

template <class Archive, class O>
void walk_command(Archive &a, O &command)
{
    a.value(command.at_s), a.value(command.choice), a.value(command.choice_before);
    for (int k = 0; k < 3; ++k) a.value(command.point[k]);
    a.value(command.from_yaw), a.value(command.from_pitch), a.value(command.side);
}

// The track and the pieces before it are saved as their hashes.
template <class Archive, class F>
void walk_follow(Archive &a, F &follow)
{
    a.value(follow.start_s), a.flag(follow.walks), a.value(follow.offset_s);
}

template <class Archive, class M>
void walk_root_path_play(Archive &a, M &root_play)
{
    a.value(root_play.path), a.value(root_play.speed), a.value(root_play.phase_s), a.value(root_play.start_s);
}

template <class Archive, class O>
void walk_attached(Archive &a, O &attached)
{
    a.value(attached.row), a.value(attached.node);
    for (int k = 0; k < 3; ++k) a.value(attached.sphere.centre[k]);
    a.value(attached.sphere.radius);
}

template <class Archive, class Values>
void walk_values(Archive &a, Values &values)
{
    a.array(values, 8, [&](auto &v) { a.value(v.dof), a.value(v.value); });
}

template <class Archive, class Shapes>
void walk_poses(Archive &a, Shapes &poses)
{
    a.array(poses, 8, [&](auto &s) { a.value(s.first), a.value(s.count); });
}

// Of each kind of mechanism. Mechanism itself stores its template as an index, which is not a plain field.
template <class Archive, class Kind>
void walk_kind(Archive &a, Kind &kind)
{
    using K = std::remove_const_t<Kind>;
    if constexpr (std::is_same_v<K, Gaze>) {
        for (int k = 0; k < 2; ++k) a.value(kind.eye_yaw[k]), a.value(kind.eye_pitch[k]);
        a.value(kind.neck_yaw), a.value(kind.neck_pitch), a.value(kind.spine_yaw), a.value(kind.spine_pitch);
        a.value(kind.neck_share), a.value(kind.spine_share);
        for (int k = 0; k < 3; ++k) a.value(kind.eyes[k]);
        a.value(kind.turn_s), a.value(kind.wander_s), a.value(kind.wander_yaw), a.value(kind.wander_pitch);
    } else if constexpr (std::is_same_v<K, Expression>) {
        walk_poses(a, kind.poses), walk_values(a, kind.values);
        a.value(kind.hold_s), a.value(kind.blend_s);
    } else if constexpr (std::is_same_v<K, Blink>) {
        walk_values(a, kind.closed);
        a.value(kind.period_s), a.value(kind.close_s);
    } else if constexpr (std::is_same_v<K, Phrase>) {
        a.array(kind.keys, 8, [&](auto &key) { a.value(key.time_s), a.value(key.pose); });
        walk_poses(a, kind.poses), walk_values(a, kind.values);
        a.value(kind.length_s), a.value(kind.pause_s), a.value(kind.blend_s);
    } else if constexpr (std::is_same_v<K, Idle>) {
        a.array(kind.clips, 4, [&](auto &clip) { a.value(clip); });
        a.array(kind.weights, 4, [&](auto &weight) { a.value(weight); });
        a.value(kind.slot_s), a.value(kind.fade_s), a.value(kind.speed_spread), a.value(kind.phase_spread);
    } else {
        static_assert(std::is_same_v<K, HostMechanism>, "every kind is saved");
        a.flag(kind.memory);
    }
}

template <class Archive, class M>
void walk_levels(Archive &a, M &mechanism)
{
    for (auto &level : mechanism.level_m) a.value(level);
    a.value(mechanism.off_m);
}

// A path's reach is computed from its positions.
template <class Archive, class P>
void walk_path(Archive &a, P &path)
{
    a.flag(path.flight);
    a.value(path.duration_s), a.value(path.bank), a.value(path.max_bank);
    a.array(path.times_s, 4, [&](auto &t) { a.value(t); });
    a.array(path.positions, 12, [&](auto &p) {
        for (int k = 0; k < 3; ++k) a.value(p[k]);
    });
    a.array(path.rotations, 16, [&](auto &q) { a.value(q.x), a.value(q.y), a.value(q.z), a.value(q.w); });
}

}  // namespace claque::crowd
