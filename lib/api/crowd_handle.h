// The structs behind clq_crowd and clq_view.
#pragma once

#include <claque/view.h>

#include "lib/api/handles.h"
#include "lib/base/error.h"
#include "lib/behave/events.h"
#include "lib/crowd/edits.h"
#include "lib/frame/frame.h"

// A crowd and all its views share one memory resource and one lock for CLQ_BUSY.
struct clq_crowd {
    clq_crowd(clq_context *owner, const claque::frame::Settings &settings, uint64_t seed)
        : context(owner),
          crowd(&owner->memory, seed),
          frame(&owner->memory, settings),
          held(&owner->memory),
          views(&owner->memory),
          views_of_update(&owner->memory),
          placed_ids(&owner->memory),
          placed(&owner->memory),
          events(&owner->memory)
    {
    }
    ~clq_crowd();

    clq_context *context;
    claque::crowd::Crowd crowd;
    claque::frame::Frame frame;
    std::pmr::vector<clq_template *> held;  // every template it has used
    std::pmr::vector<clq_view *> views;
    std::pmr::vector<claque::frame::View *> views_of_update;  // of the present update
    // Scratch of set_transforms: hosts call it every frame, and it allocates only when it grows.
    std::pmr::vector<claque::crowd::Id> placed_ids;
    std::pmr::vector<claque::crowd::Transform> placed;
    std::pmr::vector<claque::behave::Event> events;  // result of the last query for events
    mutable std::atomic<int32_t> users{0};  // number of calls that draw its views (readers); -1: a call that changes it
};

struct clq_view {
    explicit clq_view(clq_crowd *owner) : crowd(owner), view(&owner->context->memory) {}
    clq_crowd *crowd;
    claque::frame::View view;
    mutable std::atomic<bool> drawn{false};  // a draw skins into its memory: one at a time
};

namespace claque::api
{

// Locks a crowd for the length of a call; a second caller, including a task of an update, gets CLQ_BUSY.
class Busy
{
public:
    explicit Busy(const clq_crowd *crowd) : crowd_(crowd)
    {
        int32_t nobody = 0;
        if (!crowd->users.compare_exchange_strong(nobody, -1))
            base::fail(CLQ_BUSY, nobody < 0 ? "another call is at work on this crowd: calls come one at a time"
                                            : "a view of this crowd is being drawn, and what it shows must not change");
    }
    ~Busy() { crowd_->users = 0; }
    Busy(const Busy &) = delete;
    Busy &operator=(const Busy &) = delete;

private:
    const clq_crowd *crowd_;
};

// Locks a view for the length of a draw. Several threads may draw different views of one crowd at once. A call that
// would change the crowd meanwhile gets CLQ_BUSY, and so does a draw during a change.
class Drawing
{
public:
    explicit Drawing(const clq_view *view) : view_(view)
    {
        std::atomic<int32_t> &users = view->crowd->users;
        int32_t before = users;
        do
            if (before < 0)
                base::fail(CLQ_BUSY, "the crowd is being changed, by an update for example: draw before or after it");
        while (!users.compare_exchange_weak(before, before + 1));
        if (!view->drawn.exchange(true)) return;
        --users;
        base::fail(CLQ_BUSY, "another thread draws this view");
    }
    ~Drawing()
    {
        view_->drawn = false;
        --view_->crowd->users;
    }
    Drawing(const Drawing &) = delete;
    Drawing &operator=(const Drawing &) = delete;

private:
    const clq_view *view_;
};

crowd::Transform transform_of(const clq_transform &transform);
clq_transform transform_of(const crowd::Transform &transform);
crowd::Play play_of(const clq_play &play);
inline crowd::Id id_of(clq_actor actor) { return {actor.index1, actor.generation}; }
inline crowd::Id id_of(clq_group group) { return {group.index1, group.generation}; }

}  // namespace claque::api
