// The fields of recorded calls in the order of the bytes: one list for writing and reading. Archives are those of
// lib/base/archive.h.
#pragma once

#include "lib/crowd/save.h"
#include "lib/record/calls.h"

namespace claque::record
{

template <class A, class Id>
void walk_id(A &a, Id &id)
{
    a.value(id.index1), a.value(id.generation);
}

template <class A, class T>
void walk_place(A &a, T &transform)
{
    for (int k = 0; k < 3; ++k) a.value(transform.position[k]);
    for (int k = 0; k < 4; ++k) a.value(transform.orientation_xyzw[k]);
    a.value(transform.scale);
}

template <class A, class P>
void walk_clip(A &a, P &play)
{
    a.value(play.clip), a.value(play.start_s), a.value(play.speed), a.value(play.phase_s);
}

template <class Call, class T>
constexpr bool is = std::is_same_v<std::remove_const_t<T>, Call>;

// Of clips.
template <class A, class T>
void walk_playing(A &a, T &c)
{
    if constexpr (is<ActorPlay, T>) {
        walk_clip(a, c.play);
    } else if constexpr (is<ActorFadeTo, T>) {
        walk_clip(a, c.play);
        a.value(c.gait), a.value(c.share), a.value(c.at_s), a.value(c.length_s), a.value(c.curve);
    } else if constexpr (is<ActorSetGaitShare, T>) {
        a.value(c.share), a.value(c.at_s), a.value(c.length_s);
    } else if constexpr (is<ActorAddLayer, T>) {
        a.value(c.layer_kind);
        walk_clip(a, c.play);
        a.value(c.weight), a.value(c.loops), a.value(c.fade_in_s), a.value(c.fade_out_s), a.value(c.curve);
        a.value(c.mask), a.flag(c.has_reference), a.value(c.reference_clip), a.value(c.reference_time_s);
        a.value(c.made);
    } else if constexpr (is<ActorEndLayer, T>) {
        a.value(c.layer), a.value(c.at_s), a.value(c.fade_out_s);
    } else if constexpr (is<ActorSetWatched, T>) {
        a.flag(c.watched);
    } else if constexpr (is<ActorFollowTrack, T>) {
        a.value(c.track), a.value(c.start_s);
    } else if constexpr (is<ActorFadeToTrack, T>) {
        a.value(c.at_s), a.value(c.length_s);
    } else {
        static_assert(is<ActorLeaveTrack, T>, "every call is recorded");
        a.value(c.at_s);
    }
}

// Of control mechanisms, root paths and the ground.
template <class A, class T>
void walk_behaving(A &a, T &c)
{
    if constexpr (is<ActorAttachMechanism, T>) {
        a.value(c.mechanism), a.value(c.priority), a.value(c.phase_s), a.value(c.start_s);
    } else if constexpr (is<ActorDetachMechanism, T>) {
        a.value(c.mechanism);
    } else if constexpr (is<ActorGaze, T>) {
        a.value(c.mechanism), a.flag(c.has_point);
        for (int k = 0; k < 3; ++k) a.value(c.point[k]);
        a.value(c.at_s);
    } else if constexpr (is<ActorExpress, T>) {
        a.value(c.mechanism), a.value(c.pose), a.value(c.at_s);
    } else if constexpr (is<ActorSay, T>) {
        a.value(c.mechanism), a.value(c.at_s);
    } else if constexpr (is<ActorPlayRootPath, T>) {
        a.value(c.path), a.value(c.speed), a.value(c.phase_s), a.value(c.start_s);
    } else if constexpr (is<ActorFollowGround, T>) {
        a.value(c.max_up), a.value(c.max_down);
    } else {
        walk_playing(a, c);
    }
}

// Of one actor, after its id.
template <class A, class T>
void walk_acting(A &a, T &c)
{
    if constexpr (is<ActorDestroy, T>) {
    } else if constexpr (is<ActorClone, T>) {
        a.flag(c.placed);
        walk_place(a, c.transform);
        a.value(c.seed);
        walk_id(a, c.made);
    } else if constexpr (is<ActorSetTextureSet, T>) {
        a.value(c.set);
    } else if constexpr (is<ActorSetPriority, T>) {
        a.value(c.priority);
    } else if constexpr (is<ActorAttach, T>) {
        a.value(c.node);
        for (int k = 0; k < 3; ++k) a.value(c.centre[k]);
        a.value(c.radius);
        walk_id(a, c.made);
    } else if constexpr (is<ActorJoin, T>) {
        walk_id(a, c.group);
        a.flag(c.placed);
        walk_place(a, c.transform);
    } else {
        walk_behaving(a, c);
    }
}

template <class A, class T>
void walk(A &a, T &c)
{
    if constexpr (is<ActorCreate, T>) {
        a.value(c.tmpl);
        walk_place(a, c.transform), walk_clip(a, c.play);
        a.value(c.seed), a.value(c.texture_set);
        walk_id(a, c.made);
    } else if constexpr (is<ActorDetach, T>) {
        walk_id(a, c.attachment);
    } else if constexpr (is<GroupCreate, T>) {
        a.flag(c.placed);
        walk_place(a, c.transform), walk_id(a, c.made);
    } else if constexpr (is<GroupDestroy, T>) {
        walk_id(a, c.group);
    } else if constexpr (is<GroupSetTransform, T>) {
        walk_id(a, c.group), walk_place(a, c.transform);
    } else if constexpr (is<GroupSetEnabled, T>) {
        walk_id(a, c.group), a.flag(c.enabled);
    } else if constexpr (is<GroupSetSpeed, T>) {
        walk_id(a, c.group), a.value(c.speed);
    } else {
        walk_id(a, c.actor);
        walk_acting(a, c);
    }
}

}  // namespace claque::record
