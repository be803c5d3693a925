// Data that only some actors have: attached objects, callbacks round their drawing, the ground under them; and the
// bounding radius of an actor with all of it (S0 4.1, 4.3, 7.1).
#pragma once

#include <claque/crowd.h>

#include "lib/base/slot_map.h"
#include "lib/model/template.h"

namespace claque::crowd
{

// An object of the scene that an actor holds (S0 4.3); claque has only its bounding sphere.
struct Attachment {
    uint32_t row = model::none;   // of its actor
    uint32_t next = model::none;  // next object of the same actor
    uint32_t node = 0;
    model::Sphere sphere;  // in the node's frame
};

struct Extra {
    clq_actor_hooks hooks = {nullptr, nullptr, nullptr};
    uint32_t first_attached = model::none;
    float max_up = 0, max_down = 0;  // world units
};

struct Extras {
    explicit Extras(std::pmr::memory_resource *memory) : all(memory), attached(memory), of(memory) {}

    base::SlotMap<Extra> all;
    base::SlotMap<Attachment> attached;
    model::Array<uint32_t> of;  // by row of actors: a row of `all`, or none
};

// The largest distance of attached objects from the template's Sklsroot centre, at scale 1. A template without
// node_reach gets a bound from the sphere of the skeleton and that of the object.
float reach_of(const model::Template &tmpl, const Attachment &attached);

// The largest distance of any vertex from there when clips are blended and the weights of additive layers sum to
// `added`. A template without blend_reach was built from the host's arrays: the bound then only assumes that joints
// rotate.
float blended_reach_of(const model::Template &tmpl, float added);

}  // namespace claque::crowd
