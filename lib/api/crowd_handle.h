// What stands behind clq_crowd and clq_view.
#pragma once

#include <claque/view.h>

#include "lib/api/handles.h"
#include "lib/base/error.h"
#include "lib/behave/events.h"
#include "lib/frame/frame.h"

// The crowd and all its views are one thing to memory and to the BUSY rule.
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
    std::pmr::vector<claque::frame::View *> views_of_update;  // of the update that runs
    // Of the call that places: hosts do so every frame, and a frame asks for no memory once it has grown.
    std::pmr::vector<claque::crowd::Id> placed_ids;
    std::pmr::vector<claque::crowd::Transform> placed;
    std::pmr::vector<claque::behave::Event> events;  // of the last question for them
    mutable std::atomic<int32_t> users{0};  // calls that draw its views, which only read it; -1: one that changes it
};

struct clq_view {
    explicit clq_view(clq_crowd *owner) : crowd(owner), view(&owner->context->memory) {}
    clq_crowd *crowd;
    claque::frame::View view;
    mutable std::atomic<bool> drawn{false};  // whoever draws it skins into its memory: one at a time
};

namespace claque::api
{

// Holds a crowd for the length of a call; a second caller, a task of an update included, is told BUSY.
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

// Holds a view for the length of a draw. Views of one crowd may be drawn at once, each by its own thread; who would change
// the crowd meanwhile is told BUSY, and so is who would draw what changes.
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
