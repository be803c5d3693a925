// The recorded calls. Ids are those that the recorded crowd gave.
#pragma once

#include <claque/group.h>
#include <claque/play.h>

#include <tuple>

#include "lib/record/format.h"

namespace claque::record
{

// Any enum of the C API: its number may be invalid in a file.
using EnumBits = uint32_t;

struct ActorCreate {
    static constexpr Kind kind = Kind::actor_create;
    uint32_t tmpl = 0;
    clq_transform transform = {};
    clq_play play = {};
    uint64_t seed = 0;
    uint32_t texture_set = 0;
    clq_actor made = {};
};
struct ActorDestroy {
    static constexpr Kind kind = Kind::actor_destroy;
    clq_actor actor = {};
};
struct ActorClone {
    static constexpr Kind kind = Kind::actor_clone;
    clq_actor actor = {};
    bool placed = false;
    clq_transform transform = {};
    uint64_t seed = 0;
    clq_actor made = {};
};
struct ActorPlay {
    static constexpr Kind kind = Kind::actor_play;
    clq_actor actor = {};
    clq_play play = {};
};
struct ActorFadeTo {
    static constexpr Kind kind = Kind::actor_fade_to;
    clq_actor actor = {};
    clq_play play = {};
    uint32_t gait = 0;
    float share = 0;
    double at_s = 0;
    float length_s = 0;
    EnumBits curve = 0;
};
struct ActorSetGaitShare {
    static constexpr Kind kind = Kind::actor_set_gait_share;
    clq_actor actor = {};
    float share = 0;
    double at_s = 0;
    float length_s = 0;
};
struct ActorAddLayer {
    static constexpr Kind kind = Kind::actor_add_layer;
    clq_actor actor = {};
    EnumBits layer_kind = 0;
    clq_play play = {};
    float weight = 0, loops = 0, fade_in_s = 0, fade_out_s = 0;
    EnumBits curve = 0;
    uint32_t mask = 0;
    bool has_reference = false;
    uint32_t reference_clip = 0;
    float reference_time_s = 0;
    uint32_t made = 0;
};
struct ActorEndLayer {
    static constexpr Kind kind = Kind::actor_end_layer;
    clq_actor actor = {};
    uint32_t layer = 0;
    double at_s = 0;
    float fade_out_s = 0;
};
struct ActorSetWatched {
    static constexpr Kind kind = Kind::actor_set_watched;
    clq_actor actor = {};
    bool watched = false;
};
struct ActorSetTextureSet {
    static constexpr Kind kind = Kind::actor_set_texture_set;
    clq_actor actor = {};
    uint32_t set = 0;
};
struct ActorSetPriority {
    static constexpr Kind kind = Kind::actor_set_priority;
    clq_actor actor = {};
    float priority = 0;
};
struct ActorAttach {
    static constexpr Kind kind = Kind::actor_attach;
    clq_actor actor = {};
    uint32_t node = 0;
    float centre[3] = {0, 0, 0}, radius = 0;
    clq_attachment made = {};
};
struct ActorDetach {
    static constexpr Kind kind = Kind::actor_detach;
    clq_attachment attachment = {};
};
struct ActorJoin {
    static constexpr Kind kind = Kind::actor_join;
    clq_actor actor = {};
    clq_group group = {};
    bool placed = false;
    clq_transform transform = {};
};
struct ActorFollowTrack {
    static constexpr Kind kind = Kind::actor_follow_track;
    clq_actor actor = {};
    uint32_t track = 0;
    double start_s = 0;
};
struct ActorFadeToTrack {
    static constexpr Kind kind = Kind::actor_fade_to_track;
    clq_actor actor = {};
    double at_s = 0;
    float length_s = 0;
};
struct ActorLeaveTrack {
    static constexpr Kind kind = Kind::actor_leave_track;
    clq_actor actor = {};
    double at_s = 0;
};
struct ActorAttachMechanism {
    static constexpr Kind kind = Kind::actor_attach_mechanism;
    clq_actor actor = {};
    uint32_t mechanism = 0;
    float priority = 0, phase_s = 0;
    double start_s = 0;
};
struct ActorDetachMechanism {
    static constexpr Kind kind = Kind::actor_detach_mechanism;
    clq_actor actor = {};
    uint32_t mechanism = 0;
};
struct ActorGaze {
    static constexpr Kind kind = Kind::actor_gaze;
    clq_actor actor = {};
    uint32_t mechanism = 0;
    bool has_point = false;
    double point[3] = {0, 0, 0};
    double at_s = 0;
};
struct ActorExpress {
    static constexpr Kind kind = Kind::actor_express;
    clq_actor actor = {};
    uint32_t mechanism = 0, pose = 0;
    double at_s = 0;
};
struct ActorSay {
    static constexpr Kind kind = Kind::actor_say;
    clq_actor actor = {};
    uint32_t mechanism = 0;
    double at_s = 0;
};
struct ActorPlayRootPath {
    static constexpr Kind kind = Kind::actor_play_root_path;
    clq_actor actor = {};
    uint32_t path = 0;
    float speed = 0, phase_s = 0;
    double start_s = 0;
};
struct ActorFollowGround {
    static constexpr Kind kind = Kind::actor_follow_ground;
    clq_actor actor = {};
    float max_up = 0, max_down = 0;
};
struct GroupCreate {
    static constexpr Kind kind = Kind::group_create;
    bool placed = false;
    clq_transform transform = {};
    clq_group made = {};
};
struct GroupDestroy {
    static constexpr Kind kind = Kind::group_destroy;
    clq_group group = {};
};
struct GroupSetTransform {
    static constexpr Kind kind = Kind::group_set_transform;
    clq_group group = {};
    clq_transform transform = {};
};
struct GroupSetEnabled {
    static constexpr Kind kind = Kind::group_set_enabled;
    clq_group group = {};
    bool enabled = false;
};
struct GroupSetSpeed {
    static constexpr Kind kind = Kind::group_set_speed;
    clq_group group = {};
    float speed = 0;
};

// All of them. Transforms, speeds and colours of many actors, and descriptions (lib/crowd/descriptions.h), have forms
// of their own.
using Calls =
    std::tuple<ActorCreate, ActorDestroy, ActorClone, ActorPlay, ActorFadeTo, ActorSetGaitShare, ActorAddLayer,
               ActorEndLayer, ActorSetWatched, ActorSetTextureSet, ActorSetPriority, ActorAttach, ActorDetach,
               ActorJoin, ActorFollowTrack, ActorFadeToTrack, ActorLeaveTrack, ActorAttachMechanism,
               ActorDetachMechanism, ActorGaze, ActorExpress, ActorSay, ActorPlayRootPath, ActorFollowGround,
               GroupCreate, GroupDestroy, GroupSetTransform, GroupSetEnabled, GroupSetSpeed>;

}  // namespace claque::record
