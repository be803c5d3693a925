// The structs behind clq_crowd and clq_view.
#pragma once

#include <claque/scene.h>
#include <claque/track.h>
#include <claque/view.h>

#include <unordered_set>

#include "lib/api/handles.h"
#include "lib/base/error.h"
#include "lib/behave/events.h"
#include "lib/crowd/edits.h"
#include "lib/frame/frame.h"
#include "lib/record/contents.h"

namespace claque::api
{

class Recorder;  // recorder.h

// How far a record (lib/api/record_handle.h) has been played into a crowd.
struct Played {
    uint64_t record = 0;  // its id; 0: the host has changed the crowd since, or no record was played
    record::Cursor next;
};

}  // namespace claque::api

// A crowd and all its views share one memory resource and one lock for CLQ_BUSY.
struct clq_crowd {
    clq_crowd(clq_context *owner, const claque::frame::Settings &settings, uint64_t seed)
        : context(owner),
          crowd(&owner->memory, seed),
          frame(&owner->memory, settings),
          held(&owner->memory),
          tracks(&owner->memory),
          views(&owner->memory),
          scenes(&owner->memory),
          views_of_update(&owner->memory),
          actor_ids(&owner->memory),
          placed(&owner->memory),
          events(&owner->memory)
    {
    }
    ~clq_crowd();

    clq_context *context;
    claque::crowd::Crowd crowd;
    claque::frame::Frame frame;
    std::pmr::vector<clq_template *> held;        // every template it has used
    std::pmr::unordered_set<clq_track *> tracks;  // every track that its actors may follow
    std::pmr::vector<clq_view *> views;
    std::pmr::vector<clq_scene *> scenes;
    std::pmr::vector<claque::frame::View *> views_of_update;  // of the present update
    // Scratch of calls with many actors: hosts make them every frame, and it allocates only when it grows.
    std::pmr::vector<claque::crowd::Id> actor_ids;
    std::pmr::vector<claque::crowd::Transform> placed;
    std::pmr::vector<claque::behave::Event> events;  // result of the last query for events
    clq_crowd_def def = clq_crowd_def_init();        // of which it was made
    claque::api::Recorder *recorder = nullptr;       // null: it is not recorded
    claque::api::Played played;
    uint64_t lender = 0;                    // the id of the record whose templates and tracks it holds
    mutable std::atomic<int32_t> users{0};  // number of calls that read it or draw its views; -1: one that changes it
};

struct clq_view {
    explicit clq_view(clq_crowd *owner) : crowd(owner), view(&owner->context->memory) {}
    clq_crowd *crowd;
    claque::frame::View view;
    mutable std::atomic<bool> drawn{false};  // a draw skins into its memory: one at a time
};

namespace claque::api
{

// Locks a crowd until `users` is 0 again.
inline void lock(const clq_crowd *crowd)
{
    int32_t users = 0;
    if (!crowd->users.compare_exchange_strong(users, -1))
        base::fail(CLQ_BUSY, users < 0 ? "another call is at work on this crowd: calls come one at a time"
                                       : "this crowd is being read, or a view of it drawn: it must not change now");
}

// Locks a crowd for the length of a call; a second caller, including a callback of an update, gets CLQ_BUSY.
class Busy
{
public:
    explicit Busy(const clq_crowd *crowd) : crowd_(crowd) { lock(crowd); }
    ~Busy() { crowd_->users = 0; }
    Busy(const Busy &) = delete;
    Busy &operator=(const Busy &) = delete;

private:
    const clq_crowd *crowd_;
};

// Keeps a crowd as it is for the length of a call that reads it. Any number of readers and draws run at once.
class Reading
{
public:
    explicit Reading(const clq_crowd *crowd) : crowd_(crowd)
    {
        int32_t before = crowd->users;
        do
            if (before < 0)
                base::fail(CLQ_BUSY, "the crowd is being changed, by an update for example: ask before or after it");
        while (!crowd->users.compare_exchange_weak(before, before + 1));
    }
    ~Reading() { --crowd_->users; }
    Reading(const Reading &) = delete;
    Reading &operator=(const Reading &) = delete;

private:
    const clq_crowd *crowd_;
};

// Locks a view for the length of a draw. Several threads may draw different views of one crowd at once. A call that
// would change the crowd meanwhile gets CLQ_BUSY, and so does a draw during a change.
class Drawing
{
public:
    explicit Drawing(const clq_view *view) : reading_(view->crowd), view_(view)
    {
        if (view->drawn.exchange(true)) base::fail(CLQ_BUSY, "another call draws or reads this view");
    }
    ~Drawing() { view_->drawn = false; }
    Drawing(const Drawing &) = delete;
    Drawing &operator=(const Drawing &) = delete;

private:
    Reading reading_;
    const clq_view *view_;
};

crowd::Transform transform_of(const clq_transform &transform);
clq_transform transform_of(const crowd::Transform &transform);
crowd::Play play_of(const clq_play &play);
inline crowd::Id id_of(clq_actor actor) { return {actor.index1, actor.generation}; }
inline crowd::Id id_of(clq_group group) { return {group.index1, group.generation}; }
// Valid until the crowd's next call with many actors.
inline const crowd::Id *ids_of(clq_crowd *crowd, const clq_actor *actors, uint32_t count)
{
    crowd->actor_ids.clear();
    crowd->actor_ids.reserve(count);
    for (uint32_t i = 0; i < count; ++i) crowd->actor_ids.push_back(id_of(actors[i]));
    return crowd->actor_ids.data();
}

}  // namespace claque::api
