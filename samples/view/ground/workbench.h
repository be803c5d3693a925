// The testing ground at work: it gives roles to the individuals of a world, and draws what belongs to them.
#pragma once

#include <memory>

#include "samples/scenes/roles/performer.h"
#include "samples/scenes/scene.h"
#include "samples/view/model.h"

namespace view
{

class Workbench
{
public:
    Workbench(scenes::Library &library, clq_crowd *crowd, const std::vector<clq_template *> &templates);

    // Gives the crowd what the roles of the model say. Call it before clq_crowd_update with the same time. What the
    // crowd refuses is taken back in the model, with the sentence in its message.
    void act(Model &model);
    // A touch of the picture with a tool moves the gaze's target, or adds a corner to the path.
    void touch(Model &model, const clq_camera &camera);
    void draw_ground(const scenes::Gl &gl, const scenes::Eye &eye, double time_s) const;
    void draw_things(const scenes::Gl &gl, const scenes::Eye &eye, const Model &model) const;

    // What an individual does; begins a role for one that has none.
    scenes::roles::Role &role_of(Model &model, clq_actor actor) const;

    // Where an individual stands when no treadmill and no path moves it.
    clq_transform place_of(clq_actor actor, const clq_actor_info &info) const;
    // Notes what it has decided.
    static void watch(Model &model, const scenes::Scene &scene);

private:
    scenes::roles::Performer *performer_of(clq_actor actor);
    scenes::roles::Kit *kit_of(const clq_template *tmpl);
    void tell(Model &model);

    scenes::Library &library_;
    clq_crowd *crowd_;
    std::vector<clq_template *> templates_;
    std::map<const clq_template *, std::unique_ptr<scenes::roles::Kit>> kits_;
    struct One {
        clq_actor actor;
        std::unique_ptr<scenes::roles::Performer> performer;
    };
    std::map<uint32_t, One> performers_;  // by index1; of individuals that were picked
};

// A fade more: the oldest one is over by now.
void add_fade(scenes::roles::Motion &motion, const scenes::roles::Fade &fade);

}  // namespace view
