// What stands behind clq_crowd and clq_view.
#pragma once

#include <claque/view.h>

#include "lib/api/handles.h"
#include "lib/base/error.h"
#include "lib/frame/frame.h"

// The crowd and all its views are one thing to memory and to the BUSY rule.
struct clq_crowd {
    clq_crowd(clq_context *owner, const claque::frame::Settings &settings, uint64_t seed)
        : context(owner),
          crowd(&owner->memory, seed),
          frame(&owner->memory, settings),
          held(&owner->memory),
          views(&owner->memory),
          asked(&owner->memory),
          placed_ids(&owner->memory),
          placed(&owner->memory)
    {
    }
    ~clq_crowd();

    clq_context *context;
    claque::crowd::Crowd crowd;
    claque::frame::Frame frame;
    std::pmr::vector<clq_template *> held;  // every template it has used
    std::pmr::vector<clq_view *> views;
    std::pmr::vector<claque::frame::View *> asked;  // of the update that runs
    // Of the call that places: hosts do so every frame, and a frame asks for no memory once it has grown.
    std::pmr::vector<claque::crowd::Id> placed_ids;
    std::pmr::vector<claque::crowd::Place> placed;
    mutable std::atomic<bool> busy{false};  // while an update runs, or a draw that skins on demand
};

struct clq_view {
    explicit clq_view(clq_crowd *owner) : crowd(owner), view(&owner->context->memory) {}
    clq_crowd *crowd;
    claque::frame::View view;
};

namespace claque::api
{

// Holds a crowd for the length of a call; a second caller, a task of an update included, is told BUSY.
class Busy
{
public:
    explicit Busy(const clq_crowd *crowd) : crowd_(crowd)
    {
        if (crowd->busy.exchange(true))
            base::fail(CLQ_BUSY, "another call is at work on this crowd: calls come one at a time");
    }
    ~Busy() { crowd_->busy = false; }
    Busy(const Busy &) = delete;
    Busy &operator=(const Busy &) = delete;

private:
    const clq_crowd *crowd_;
};

crowd::Place place_of(const clq_place &place);
clq_place place_of(const crowd::Place &place);
crowd::Play play_of(const clq_play &play);
inline crowd::Id id_of(clq_actor actor) { return {actor.index1, actor.generation}; }
inline crowd::Id id_of(clq_group group) { return {group.index1, group.generation}; }

}  // namespace claque::api
