// Every call that changes a crowd. Calls throw base::Error (CLQ_STALE_ID, CLQ_ARGUMENT, CLQ_LIMIT) or std::bad_alloc
// and change nothing then: each reserves first and commits afterwards. One writer at a time.
#pragma once

#include "lib/crowd/crowd.h"

namespace claque::crowd
{

class ColourMap;  // colour_map.h

// Actors. The template must outlive the crowd; Crowd::has_template tells beforehand whether it is new to the crowd.
Id create(Crowd &crowd, const model::Template &tmpl, const Transform &transform, const Play &play, uint64_t seed);
void destroy(Crowd &crowd, Id id);
// Copies an individual with everything except its attached objects. Null transform: that of the original.
Id clone(Crowd &crowd, Id id, const Transform *transform, uint64_t seed);
void set_transforms(Crowd &crowd, const Id *ids, const Transform *transforms, uint32_t count);  // all or none
void set_priority(Crowd &crowd, Id id, float priority);                                         // [0, 1]
// How fast the host moves them, world units a second; all or none.
void set_speeds(Crowd &crowd, const Id *ids, const float *speeds, uint32_t count);
float checked_speed(float speed);  // throws base::Error (CLQ_ARGUMENT)

// Appearance (S2 5). Colours are sampled by (crowd seed, actor seed, zone), so they are repeatable.
void set_colours(Crowd &crowd, Id id, const float *rgb, uint32_t zone_count);  // [3 * zone_count], each [0, 1]
void randomise_colours(Crowd &crowd, Id id, const model::HsbRange *ranges,
                       uint32_t count);  // 0: the template's own ranges
// Samples from a class of a map; all or none.
void randomise_colours(Crowd &crowd, const Id *ids, uint32_t count, const ColourMap &map, uint32_t colour_class);
constexpr uint32_t random_texture_set = model::none;
void set_texture_set(Crowd &crowd, Id id, uint32_t set);  // random_texture_set: by the seeds of crowd and actor

// Groups. Members of a destroyed group stay where they are in the world.
Id create_group(Crowd &crowd, const Transform &transform);
void destroy_group(Crowd &crowd, Id id);
void set_group_transform(Crowd &crowd, Id id, const Transform &transform);
void set_group_speed(Crowd &crowd, Id id, float speed);
void enable_group(Crowd &crowd, Id id, bool enabled);
// Transform: in the group's space, or null: the actor stays where it is in the world. Group none: it leaves its group.
void join(Crowd &crowd, Id id, Id group, const Transform *transform);

// Attached objects, callbacks and the ground (S0 4.3, 7.1).
Id attach(Crowd &crowd, Id id, uint32_t node, const model::Sphere &sphere);
void detach(Crowd &crowd, Id attached);
void set_hooks(Crowd &crowd, Id id, const clq_actor_hooks &hooks);                               // both null: none
void set_ground(Crowd &crowd, double (*height)(void *user, const double point[3]), void *user);  // null: none
void follow_ground(Crowd &crowd, Id id, float max_up, float max_down);  // world units; both 0: it does not follow

// Behaviour (S0 5.3, 7.1).
void attach_mechanism(Crowd &crowd, Id id, const MechanismAttachment &attachment);
void detach_mechanism(Crowd &crowd, Id id, uint32_t mechanism);
// the commands of this attachment, for the caller to change
CommandHistory &command_history(Crowd &crowd, Id id, uint32_t mechanism);
void play_root_path(Crowd &crowd, Id id, const RootPathPlay &root_play);

// Tracks (follows.h). An actor that begins to follow one plays its gait; fades and layers end. When it leaves, it stays
// where it is at that time.
void follow_track(Crowd &crowd, Id id, const track::Track &track, double start_s);
void leave_track(Crowd &crowd, Id id, double at_s);
void fade_to_track(Crowd &crowd, Id id, double at_s, float length_s, Curve curve);  // from clips of its own

// Clips, fades, gaits and layers (layers.h). Throws base::Error (CLQ_ARGUMENT) unless the clip is one of the template's
// and the numbers are finite.
void check_play(const Play &play, const model::Template &tmpl);
void play(Crowd &crowd, Id id, const Play &play);
// Checked. `share`: that of the gait's second clip; the play's clip becomes the gait's first. Gait none: the clip
// alone.
Source source(const Crowd &crowd, uint32_t row, const Play &play, uint32_t gait, float share);
void play(Crowd &crowd, Id id, const Source &source);  // at once; ends all fades
// A fade with a start before that of the last fade replaces that one.
void fade_to(Crowd &crowd, Id id, const Source &source, double at_s, float length_s, Curve curve);
void change_share(Crowd &crowd, Id id, float share, double at_s, float length_s);
uint32_t add_layer(Crowd &crowd, Id id, const Layer &layer);  // returns its id
void end_layer(Crowd &crowd, Id id, uint32_t layer_id, double at_s, float fade_out_s);
void watch(Crowd &crowd, Id id, bool watched);  // whether events of its clips are recorded

// Swaps the state with `restored` (save.h). Callbacks stay: the ground, and the hooks of actors with the same id in
// both. All versions become new, so that no result that was cached for this crowd is taken for one of the restored
// crowd. std::bad_alloc: unchanged. Both must use the same memory resource.
void swap_state(Crowd &crowd, Crowd &restored);

}  // namespace claque::crowd
